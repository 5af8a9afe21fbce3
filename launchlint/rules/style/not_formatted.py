"""The file is not in normal form.

`launchlint format` would change it: indentation, blank lines, line ends, quotes, empty elements, or the order and the
lines of attributes. There is one finding for a file, at the first such line. This rule is off until it is selected.

## Why it matters

Files in one form are easier to read, and changes of them show what has changed and nothing else.

## Example

```xml
<launch>
    <arg name="robot"></arg>
  <group ns="$(arg robot)">
    <node name="amcl" pkg="amcl" type="amcl"/>
  </group>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="robot"/>
  <group ns="$(arg robot)">
    <node name="amcl" pkg="amcl" type="amcl"/>
  </group>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule, shortened
from launchlint.rules.view import FileView
from launchlint.source import Source, Span
from launchlint.workspace.discovery import is_program
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

RULE = Rule("LL801", "not-formatted", Severity.INFO, default=False)


def check(view: FileView) -> Iterator[Finding]:
    """Find the first line that is not in normal form."""
    from launchlint.fix.format.formatting import is_yaml, normal_form
    from launchlint.fix.format.printer import TooLarge

    written = view.document.source
    if is_program(written.file, written.text.encode("utf-8", "replace")):
        return  # programs have formatters of their own
    try:
        wanted = Source(written.path, normal_form(written.text, view.style, yaml=is_yaml(written.path)))
    except TooLarge:  # nobody wrote this for people
        return
    except (YamlError, YamlBeyond, ValueError):  # LL101 says so
        return
    if wanted.text == written.text:
        return
    number = next(number for number in range(1, len(written.line_starts) + 1) if _line(written, number) != _line(wanted, number))
    line, instead = written.line(number), wanted.line(number)
    yield RULE.at(
        view.document.place(_shown(written, number)),
        "this line is not in normal form" if line != instead else "this line does not end as lines of this file do in normal form",
        notes=(f"it would be written as: {shortened(instead)}",) if instead.strip() and line != instead else (),
        help="launchlint format writes the file in normal form; with --diff it shows what it would change",
    )


def _shown(source: Source, number: int) -> Span:
    """A line without the blanks around it, if there is anything else in it."""
    line = source.line(number)
    words = line.strip(" \t") or line
    start = source.line_starts[number - 1] + line.index(words)
    return Span(start, start + len(words))


def _line(source: Source, number: int) -> str:
    """A line with its end; empty where there is none."""
    starts = source.line_starts
    if number > len(starts):
        return ""
    return source.text[starts[number - 1] : starts[number] if number < len(starts) else len(source.text)]
