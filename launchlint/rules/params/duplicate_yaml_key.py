"""A key stands twice in one YAML dictionary.

The YAML parser takes the last one and drops the others without a word. Where both have the same value, it is an info, and all of one file
are told as one; so it is where the first value has an anchor (`&name`) by which it is used further down. The same key in copies of a file
is told once. In ROS 2 it is about launch files in YAML: a second `node` without a dash of its own replaces the first one.

## Why it matters

The value that one reads first is not the one the robot runs with; whole blocks of settings get lost when the key of a
block is repeated.

## Example

```xml
<launch>
  <rosparam file="$(dirname)/costmap.yaml"/>
</launch>
```

```yaml costmap.yaml
costmap:
  resolution: 0.05
  width: 10
  resolution: 0.1
```

## Use instead

```xml
<launch>
  <rosparam file="$(dirname)/costmap.yaml"/>
</launch>
```

```yaml costmap.yaml
costmap:
  resolution: 0.1
  width: 10
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import YamlDuplicateKey
from launchlint.finding import Finding, Severity
from launchlint.plural import listed
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.problems import KeyTwice

RULE = Rule("LL513", "duplicate-yaml-key", Severity.WARNING)
_MOST_NAMED = 6
_MOST_ALIKE = 20
"""Keys by which a copy is recognised."""
_SAID = {"same": " with the same value", "anchored": "", "": ": the first value is lost"}


def tell(problem: YamlDuplicateKey | KeyTwice, view: object) -> Iterator[Finding]:
    """Show both keys."""
    key, same = problem.key, problem.same
    anchored = isinstance(problem, YamlDuplicateKey) and problem.anchored
    harmless = "same" if same else "anchored" if anchored else ""
    yield RULE.at(
        problem.origin,
        f"the key {key} stands twice{_SAID[harmless]}",
        severity=Severity.INFO if harmless else None,
        label="the last one counts",
        # Of a text with substitutions only the element is known.
        related=tuple(each for each in problem.related if each[0] != problem.place),
        notes=("the first value is used by its anchor",) if anchored else (),
        topic=key,
        cause=f"{problem.place.source.path} {harmless}" if harmless else _twice(problem, view),
        help="remove one of the two" if same else "remove one of the two, or merge what is below them",
    )


def together(findings: Sequence[Finding]) -> Finding:
    """The keys of one cause by their names: those of a text with substitutions have one place."""
    told, keys = joined(findings), list(dict.fromkeys(each.topic for each in findings))
    if len(keys) < 2 or len({each.location for each in findings}) > 1:
        return told
    what = ": the first values are lost"
    if told.severity is Severity.INFO:
        what = "" if told.notes else " with the same values"
    return told._replace(message=f"the keys {listed(keys, _MOST_NAMED)} stand twice{what}")


def _twice(problem: YamlDuplicateKey | KeyTwice, view: object) -> str:
    """One for all keys of a file that stand twice, and for copies of the file."""
    if not isinstance(view, LaunchView):
        return f"{problem.place.source.path} {problem.key}"
    return view.once(_causes).get(id(problem.place.source), "")


def _causes(view: LaunchView) -> dict[int, str]:
    """For each file, by the identity of its source, its first keys that stand twice, and where."""
    found: dict[int, set[tuple[str, int, int]]] = {}
    for each in view.launch.noticed(YamlDuplicateKey):
        if not (each.same or each.anchored):
            found.setdefault(id(each.place.source), set()).add((each.key, *each.place.source.position(each.place.span.start)))
    return {source: f"{sorted(keys)[:_MOST_ALIKE]}" for source, keys in found.items()}
