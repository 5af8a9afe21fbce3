"""A node is started from a package that does not exist.

What it does: it looks for the `pkg` of every node and test among the packages of the workspace, the installed ones and the public
index. It is an error where every package is known (a ROS installation is set up here, or the configuration says `packages:
complete`) or where the name is one slip away from a package that exists; a warning where nobody has ever heard of the name.
Public packages that are only not installed here are passed over. Of several nodes from one such package the first of a file is told of.

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
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.model import Node

RULE = Rule("LL303", "unknown-package", Severity.ERROR, roslaunch="reports")


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Yield one finding for each package that is not there (roslaunch.rlutil.check_roslaunch), at its first node or test of a file.

    The places behind it are in order for this rule: in another configuration one of them may be the first.
    """
    launch = view.launch
    missing: dict[tuple[str, str], list[Node]] = {}
    for node in (*launch.nodes, *launch.tests):
        name = node.package
        if "pkg" not in node.unknown and name.strip() and not view.packages.has(name):
            missing.setdefault((_place(node).source.path, name), []).append(node)
    for (_, name), nodes in missing.items():
        node = min(nodes, key=lambda each: _place(each).span.start)
        judgement = judge(name, view.packages, node.origin.place.source.file)
        if judgement is None:
            continue
        assumed = any(condition.assumed for condition in node.conditions)
        place = _place(node)
        others = {_place(each) for each in nodes} - {place}
        yield from (RULE.fine(other) for other in sorted(others, key=lambda each: each.span.start))
        notes = [judgement.why] if judgement.why else []
        if launch.refused is None:
            notes.append("roslaunch loads the file and fails when it starts this node")
        if others:
            notes.append(f"{len(others)} more in this file {'is' if len(others) == 1 else 'are'} of {name} too")
        yield RULE.at(
            Origin(place, node.origin.step),
            f"there is no package {name}" if judgement.severity is Severity.ERROR else f"the package {name} is not known here",
            severity=min(judgement.severity, Severity.WARNING) if assumed else judgement.severity,
            label="not found",
            notes=tuple(notes),
            help=judgement.help,
        )


def _place(node: Node) -> Place:
    return node.attributes.get("pkg", node.origin.place)
