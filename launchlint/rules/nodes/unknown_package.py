"""A node is started from a package that does not exist.

What it does: it looks for the `pkg` of every node and test among the packages of the workspace, the installed ones and the public
index. It is an error where every package is known (a ROS installation is set up here, or the configuration says `packages:
complete`) or where the name is one slip away from a package that exists; a warning where nobody has ever heard of the name.
Public packages that are only not installed here are passed over.

## Why it matters

roslaunch loads such a file without a word and fails only when it starts the node, after the other nodes are up.

## Example

```xml
<launch>
  <node pkg="robot_state_publsher" type="robot_state_publisher" name="robot_state_publisher"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="robot_state_publisher" type="robot_state_publisher" name="robot_state_publisher"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.missing_package import judge
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin

RULE = Rule("LL303", "unknown-package", Severity.ERROR, roslaunch="reports")


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each node or test of a package that is not there (roslaunch.rlutil.check_roslaunch)."""
    launch = view.launch
    for node in (*launch.nodes, *launch.tests):
        name = node.package
        if "pkg" in node.unknown or not name.strip() or view.packages.has(name):
            continue
        judgement = judge(name, view.packages, node.origin.place.source.file)
        if judgement is None:
            continue
        assumed = any(condition.assumed for condition in node.conditions)
        place = node.attributes.get("pkg", node.origin.place)
        notes = (judgement.why,) if judgement.why else ()
        yield RULE.at(
            Origin(place, node.origin.step),
            f"there is no package {name}" if judgement.severity is Severity.ERROR else f"the package {name} is not known here",
            severity=min(judgement.severity, Severity.WARNING) if assumed else judgement.severity,
            label="not found",
            notes=(*notes, "roslaunch loads the file and fails when it starts this node"),
            help=judgement.help,
        )
