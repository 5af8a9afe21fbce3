"""An element has an attribute that its tag does not take.

It is a misspelt one (`clear_parmas`), one of another tag (`args` belongs to `<node>`, `default` to `<arg>`), or one
that never existed.

## Why it matters

roslaunch drops the attribute. It says so in a warning that is easy to miss, and for `<launch>` not at all; the node
then runs without the setting that somebody wrote down.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" respwan="true"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" respawn="true"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule
from launchlint.spelling import closest

RULE = Rule("LL104", "unknown-attribute", Severity.ERROR, roslaunch="reports")


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Name the attribute that was meant; facts: ``tag``, ``attribute``, ``known`` (not given yet), ``owners``, ``silent``."""
    facts = problem.facts
    tag, name, owners = facts["tag"], facts["attribute"], facts["owners"]
    silent: bool = facts["silent"]
    near = closest(name, facts["known"])
    belongs = f"{name} belongs to {_tags(owners)}" if owners else ""
    advice = f"did you mean {near}?" if near is not None else f"{belongs}: move it there, or remove it" if belongs else "remove it"
    said = "roslaunch never looks at it" if silent else "roslaunch prints a warning and drops it"
    notes = (said, belongs) if belongs and near is not None else (said,)
    yield RULE.at(
        problem.origin,
        f"<{tag}> has no attribute {name}",
        severity=Severity.WARNING if silent else Severity.ERROR,
        label="dropped",
        notes=notes,
        help=advice,
    )


def _tags(tags: tuple[str, ...]) -> str:
    words = [f"<{tag}>" for tag in tags]
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
