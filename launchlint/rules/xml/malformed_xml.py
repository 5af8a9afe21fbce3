"""The file is not well-formed XML.

It names the slip behind the parser's complaint: the element that was never closed, the quote that is missing, the
character that must be escaped. The caret stands where the mistake is, not where the parser noticed it. The includes
that lead to the file are shown with it.

It is a warning where the file is empty (all empty files are told at once, and so are all with comments behind a `#`), and an info where
it holds nothing but comments, or is a script (`#!/bin/bash`) by another name: nobody starts these with roslaunch. A file that another one
includes is an error all the same. It is an info where the line holds the placeholder of a template (`<your-package>`, `__robot__`,
`@ROBOT@`), or a file that nobody includes is called one.

In ROS 2 the same is told of launch files in YAML: tabs, lines that do not line up, brackets that are never closed, tags such as
`!!python/…`.

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

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.made_file import malformed
from launchlint.rules.judging.template import FILLED_IN, has_placeholder, is_called_template
from launchlint.rules.rule import Rule
from launchlint.syntax.problems import MalformedXml
from launchlint.syntax.ros2.problems import MalformedXml2, MalformedYaml, TooDeep
from launchlint.syntax.tags import UNRESOLVED

RULE = Rule("LL101", "malformed-xml", Severity.ERROR, roslaunch="refuses")
TEMPLATE = "template"
HASH = "comments"
_HASH = late(r"\s*#(?!\s*(?:include|define|if|ifdef|ifndef|pragma)\b)")
"""How people begin a comment where they think of another language; not what a source file of C++ begins with."""
_CANNOT = "ros2 launch cannot read the file: it refuses all of it"
_YAML_ADVICE = {
    "tag": "a launch file needs no tags: write plain values",
    "documents": "put all actions into the list of the first document",
    "anchor": "set the anchor before it is used, and only once",
}


def tell(problem: MalformedXml | MalformedXml2 | MalformedYaml | TooDeep, view: object) -> Iterator[Finding]:
    """Say what is wrong with the XML, or with the YAML of ROS 2."""
    source, span = problem.place
    if isinstance(problem, MalformedYaml):
        message = f"not valid YAML: {problem.message}"
        yield RULE.at(
            problem.origin, message, notes=(_CANNOT,), help=_YAML_ADVICE.get(problem.reason, ""), shared_cause=malformed(source.file)
        )
        return
    if isinstance(problem, TooDeep):
        message = f"actions stand in each other more than {problem.deepest} deep"
        yield RULE.at(
            problem.origin, message, notes=("ros2 launch stops with: maximum recursion depth exceeded",), help="make the file flatter"
        )
        return
    message, advice = f"not well-formed XML: {problem.message}", problem.hint
    severity: Severity | None = None
    notes = [_CANNOT if isinstance(problem, MalformedXml2) else "roslaunch stops with: Invalid roslaunch XML syntax"]
    cause = topic = ""
    alone = problem.origin.step is None
    template = has_placeholder(source.line(source.position(span.start).line)) or (alone and is_called_template(source.path))
    if template:
        severity, topic = Severity.INFO, TEMPLATE
        notes.append(FILLED_IN)
    elif source.text.startswith("#!"):
        severity, cause = Severity.INFO, "a script"
        message, advice = (
            f"this is a script and no XML: {_first_line(source.text)}",
            "give it a name that does not end like that of a launch file",
        )
    elif _HASH.match(source.text, span.start) is not None:
        topic, advice = HASH, "write comments as <!-- … -->: a # begins none in XML"
    elif problem.code == "XML_ERROR_NO_ELEMENTS" and not problem.opened:
        severity = Severity.INFO if source.text.strip() else Severity.WARNING
    yield RULE.at(
        problem.origin,
        message,
        severity=severity,
        related=problem.related,
        notes=tuple(notes),
        help=advice,
        topic=topic,
        cause=cause,
        shared_cause="" if cause else malformed(source.file),
    )


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for all files whose comments begin with a ``#``, a belief about XML and no slip in each of them; and one for all that were
    committed in the middle of a merge.
    """
    alike: dict[tuple[Severity, str], list[Finding]] = {}
    for finding in findings:
        kind = UNRESOLVED if finding.message.endswith(UNRESOLVED) else finding.topic if finding.topic == HASH else ""
        if kind:
            alike.setdefault((finding.severity, kind), []).append(finding)
        else:
            yield finding
    for several in alike.values():
        yield joined(several) if len(several) > 1 else several[0]


def _first_line(text: str) -> str:
    return text.partition("\n")[0].strip()[:60]
