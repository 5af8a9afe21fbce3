"""The file is not well-formed XML.

It names the slip behind the parser's complaint: the element that was never closed, the quote that is missing, the
character that must be escaped. The caret stands where the mistake is, not where the parser noticed it. The includes
that lead to the file are shown with it.

## Why it matters

roslaunch stops before it looks at a single tag, with a line number that is often far below the mistake.

## Example

```xml
<launch>
  <group ns="robot1">
    <node pkg="amcl" type="amcl" name="amcl"/>

  <node pkg="map_server" type="map_server" name="map_server"/>
</launch>
```

## Use instead

```xml
<launch>
  <group ns="robot1">
    <node pkg="amcl" type="amcl" name="amcl"/>
  </group>

  <node pkg="map_server" type="map_server" name="map_server"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.made_file import malformed
from launchlint.rules.rule import Rule
from launchlint.rules.template import has_placeholder
from launchlint.syntax.problems import MalformedXml

RULE = Rule("LL101", "malformed-xml", Severity.ERROR, roslaunch="refuses")


def tell(problem: MalformedXml, view: object) -> Iterator[Finding]:
    """Say what is wrong with the XML."""
    source, span = problem.place
    template = has_placeholder(source.line(source.position(span.start).line))
    notes: tuple[str, ...] = ("roslaunch stops with: Invalid roslaunch XML syntax",)
    yield RULE.at(
        problem.origin,
        f"not well-formed XML: {problem.message}",
        severity=Severity.INFO if template else None,
        related=problem.related,
        notes=(*notes, "it looks like a template that is filled in before anybody launches it") if template else notes,
        help=problem.hint,
        shared_cause=malformed(source.file),
    )
