"""A parameter file of ROS 2 is loaded by a ROS 1 `<rosparam>`.

In ROS 2 the params of a node stand below `ros__parameters`, below the name of the node. For ROS 1 that is a name like any other.

## Why it matters

The parameters are set as `/node/ros__parameters/rate`, and a ROS 1 node asks for `/node/rate`: it runs with its defaults, without a word.
This is told once per file, and nothing else is told of these parameters.

## Example

```xml
<launch>
  <rosparam file="$(dirname)/talker.yaml"/>
</launch>
```

```yaml talker.yaml
talker:
  ros__parameters:
    rate: 10
```

## Use instead

```xml
<launch>
  <rosparam file="$(dirname)/talker.yaml"/>
</launch>
```

```yaml talker.yaml
talker:
  rate: 10
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import Ros2Parameters
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule

RULE = Rule("LL515", "ros2-parameter-file", Severity.WARNING)


def tell(problem: Ros2Parameters, view: object) -> Iterator[Finding]:
    """Say what its parameters become."""
    name, count = problem.name, problem.count
    yield RULE.at(
        problem.origin,
        "this is a parameter file of ROS 2, loaded in ROS 1",
        label="a name like any other in ROS 1",
        related=problem.related,
        notes=(
            f"{count} parameter{' is' if count == 1 else 's are'} set below ros__parameters, such as {name}, where ROS 1 nodes do not look",
        ),
        help="take the params out of ros__parameters, in a file of its own where ROS 2 needs this one",
    )
