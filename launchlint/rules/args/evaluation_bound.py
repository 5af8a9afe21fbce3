"""A launch file is too large to be checked to its end.

Files that include each other many times over can amount to more elements than any robot has. launchlint gives up
after 400,000 of them in one configuration, so that it always ends. Of one rule 1,000 findings are listed for a launch file and as many
for each of its configurations; where there are more, this says at which place the list ends.

## Why it matters

Nothing that comes behind is checked, and roslaunch itself would take very long or run out of memory.

## Example

The file includes itself twice, twenty-four levels deep, which makes sixteen million nodes:

```xml
<launch>
  <arg name="level" default="24"/>
  <node pkg="rospy_tutorials" type="talker" name="talker" if="$(eval level == 0)"/>
  <group unless="$(eval level == 0)">
    <include file="$(dirname)/example.launch"><arg name="level" value="$(eval level - 1)"/></include>
    <include file="$(dirname)/example.launch"><arg name="level" value="$(eval level - 1)"/></include>
  </group>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="rospy_tutorials" type="talker" name="talker"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import EvaluationBound
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule

RULE = Rule("LL216", "evaluation-bound", Severity.WARNING)


def left_out(finding: Finding, most: int) -> Finding:
    """Say that ``finding`` is the first of its rule that is not listed, since ``most`` are."""
    return RULE.at_location(
        finding.location,
        f"more than {most:,} findings of {finding.rule} {finding.name}: from here on they are not listed",
        severity=Severity.INFO,
        help="put right what is listed, and check again",
        topic=finding.rule,
    )


def tell(problem: EvaluationBound, view: object) -> Iterator[Finding]:
    """Say where it was given up."""
    yield RULE.at(
        problem.origin,
        f"given up after {problem.elements:,} elements: this launch file amounts to more than can be checked",
        label="got as far as this",
        help="look for files that include each other again and again",
    )
