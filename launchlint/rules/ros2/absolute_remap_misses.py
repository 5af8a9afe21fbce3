"""A remap names a topic or service by its global name, and the node has it in a namespace.

What it does: where all names of a node are known, it looks for remaps whose source is a global name (`/scan`) that the node does not have,
while its code says a relative or private name (`scan`, `~/scan`) that ends so, and that its namespace or its own name makes another one of.
Nothing is said where the remap acts on some other node that it reaches. Remaps that match no name in any other way are told by LL601. It
is an info where the node has the name that the remap leads to anyhow.

## Why it matters

The remap does nothing, and nobody is told: the node keeps its name, and talks to nobody.

## Example

```xml example.launch.xml
<launch>
  <node pkg="mapping" exec="mapper" name="mapper" namespace="robot">
    <remap from="/scan" to="/lidar/points"/>
  </node>
</launch>
```

```yaml .launchlint.yaml
library: [nodes.json]
```

```json nodes.json
{"format": "launchlint-library", "version": 2, "packages": {
  "mapping": {"middleware": "ros2", "executables": {"mapper": {"class": "rclcpp", "variants": {"default": {
    "subscribers": [{"name": "scan", "type": "sensor_msgs/msg/LaserScan"}]}}}}}
}}
```

## Use instead

```xml example.launch.xml
<launch>
  <node pkg="mapping" exec="mapper" name="mapper" namespace="robot">
    <remap from="scan" to="/lidar/points"/>
  </node>
</launch>
```

```yaml .launchlint.yaml
library: [nodes.json]
```

```json nodes.json
{"format": "launchlint-library", "version": 2, "packages": {
  "mapping": {"middleware": "ros2", "executables": {"mapper": {"class": "rclcpp", "variants": {"default": {
    "subscribers": [{"name": "scan", "type": "sensor_msgs/msg/LaserScan"}]}}}}}
}}
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.ros2_remaps import in_vain
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL948", "absolute-remap-misses", Severity.WARNING)


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at every remap of every node whose names are all known (rcl_remap_name)."""
    yield from in_vain(RULE, view, absolute=True)
