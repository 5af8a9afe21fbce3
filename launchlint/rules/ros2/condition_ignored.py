"""A `<composable_node>` in a `<load_composable_node>` is loaded although its condition does not hold.

What it does: it speaks where the distribution of ROS 2 is Humble, whose `<load_composable_node>` does not look at `if` and `unless`
of what it loads. Those of a `<node_container>` count.

## Why it matters

What was to be left out is started, and nobody says so.

## Example

```xml main.launch.xml
<launch>
  <arg name="rectify" default="false"/>
  <node_container pkg="rclcpp_components" exec="component_container" name="images" namespace="/"/>
  <load_composable_node target="/images">
    <composable_node pkg="image_proc" plugin="image_proc::RectifyNode" name="rectify" if="$(var rectify)"/>
  </load_composable_node>
</launch>
```

```yaml .launchlint.yaml
distro: humble
```

## Use instead

```xml main.launch.xml
<launch>
  <arg name="rectify" default="false"/>
  <node_container pkg="rclcpp_components" exec="component_container" name="images" namespace="/"/>
  <load_composable_node target="/images" if="$(var rectify)">
    <composable_node pkg="image_proc" plugin="image_proc::RectifyNode" name="rectify"/>
  </load_composable_node>
</launch>
```

```yaml .launchlint.yaml
distro: humble
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at

RULE = Rule("LL939", "condition-ignored", Severity.WARNING)


def check(view: LaunchView) -> Iterator[Finding]:
    """All that is loaded against its condition (launch_ros.actions.LoadComposableNodes)."""
    for node in view.launch.nodes:
        if not node.condition_ignored or not node.conditions:
            continue
        condition = node.conditions[-1]
        load = words_at(node.origin).tag("load_composable_node")
        yield RULE.at(
            node.origin._replace(place=condition.place),
            f"{node.name or node.plugin} is loaded, whatever this condition says",
            label=f"{condition.text} here, and not looked at",
            notes=(f"{load} of {view.launch.distro} does not look at the conditions of what it loads",),
            help=f"put the condition on a {load} of its own",
        )
