'''The YAML of a `<rosparam>` cannot be loaded.

It is read as PyYAML reads it for rosparam: one document, and a dictionary unless the attribute `param` says which
parameter the value is for. Where the YAML stands in a file of its own, the finding stands there.

## Why it matters

roslaunch refuses the launch file, and with it every launch file that includes it.

## Example

```xml
<launch>
  <rosparam>
    rate:10
  </rosparam>
</launch>
```

## Use instead

```xml
<launch>
  <rosparam>
    rate: 10
  </rosparam>
</launch>
```
'''

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule

RULE = Rule("LL503", "param-yaml-invalid", Severity.ERROR, roslaunch="refuses")


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Say what is wrong and what was meant; facts: ``reason``, ``hint``, ``in_file``, ``file``."""
    place = problem.place
    reason, hint = problem.facts["reason"], problem.facts["hint"]
    line = place.source.line(place.source.position(place.span.start).line)
    where = "this YAML file" if problem.facts["in_file"] else "this <rosparam>"
    if hint == "colon":
        key, _, value = place.text.partition(":")
        message = f"the YAML has no blank after the colon of {key!r}, so that it is one text and no dictionary"
        label, help_ = "a text", f"write {key}: {value}"
    elif hint == "scalar":
        message = f"the value of {where} is no dictionary, and no parameter is named for it"
        label, help_ = "", "name the parameter with param=, or write NAME: VALUE"
    else:
        message, label, help_ = f"{where} cannot be loaded: {reason}", "here", _advice(line, problem.facts["in_file"])
    note = "roslaunch stops with: 'param' attribute must be set for non-dictionary values" if hint else "roslaunch refuses the launch file"
    yield RULE.at(problem.origin, message, label=label, related=problem.related, notes=(note,), help=help_)


def _advice(line: str, in_file: bool) -> str:
    if line.lstrip(" ").startswith("\t"):
        return "indent YAML with blanks: tabs are not allowed there"
    if "$(" in line and in_file:
        return "substitutions in the file need subst_value=\"true\" on the <rosparam>, and quotes around values such as \"$(arg x)\""
    return "mend it, and try it with: rosparam load FILE" if in_file else ""
