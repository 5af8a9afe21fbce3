"""A param that its node declares as a double is given an integer.

What it does: where the sources or a library say for certain that a node declares a param as a double, or as a list of doubles, it looks
at the value that the launch file or a parameter file gives. `1` is an integer, `1.0` a double. Values of one file that are wrong in the
same way, for the same program, are told as one. Values of other types are told by LL508. It is an info for a program of others where the
repository names a distribution older than Humble: such a program may have declared another type then.

## Why it matters

rclcpp and rclpy take no integer for a double: the node dies when it declares the param, with an InvalidParameterTypeException.

## Example

```xml example.launch.xml
<launch>
  <node pkg="lidar" exec="driver" name="driver">
    <param name="rate" value="10"/>
  </node>
</launch>
```

```yaml .launchlint.yaml
library: [nodes.json]
```

```json nodes.json
{"format": "launchlint-library", "version": 2, "packages": {
  "lidar": {"middleware": "ros2", "executables": {"driver": {"class": "rclcpp", "variants": {"default": {
    "params": [{"name": "~rate", "type": "double", "declared": true, "default": 5.0}]}}}}}
}}
```

## Use instead

```xml example.launch.xml
<launch>
  <node pkg="lidar" exec="driver" name="driver">
    <param name="rate" value="10.0"/>
  </node>
</launch>
```

```yaml .launchlint.yaml
library: [nodes.json]
```

```json nodes.json
{"format": "launchlint-library", "version": 2, "packages": {
  "lidar": {"middleware": "ros2", "executables": {"driver": {"class": "rclcpp", "variants": {"default": {
    "params": [{"name": "~rate", "type": "double", "declared": true, "default": 5.0}]}}}}}
}}
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.ros2_params import WORDS, fate, given, is_integer_for_double, is_of_old
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView

_MOST_SHOWN = 4
RULE = Rule("LL906", "param-int-for-double", Severity.ERROR)


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every param of every node (rclcpp::Node::declare_parameter, rclpy.node.Node.declare_parameters)."""
    for each in given(view):
        if is_integer_for_double(each):
            several = isinstance(each.value, list)
            said = "integers" if several else f"the integer {each.value}"
            yield RULE.at(
                each.origin,
                f"{each.instance.name} declares {each.name} as {WORDS[each.wanted[0].type]}, and is given {said}",
                severity=Severity.INFO if is_of_old(each, view) else None,
                label=WORDS[each.type],
                notes=(fate(each.instance),),
                help=f"write {_with_points(each.value)}",
                topic=f"{each.instance.program} {each.name}",
                cause=f"{each.instance.program} {each.origin.place.source.path}",
            )


def _with_points(value: int | list[int]) -> str:
    if isinstance(value, list):
        return f"[{', '.join(f'{each}.0' for each in value[:_MOST_SHOWN])}{', …' if len(value) > _MOST_SHOWN else ''}]"
    return f"{value}.0"
