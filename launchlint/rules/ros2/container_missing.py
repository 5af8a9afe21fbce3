"""A composable node is to be loaded into a container that nobody starts.

What it does: it looks for the target of each `<load_composable_node>` among the nodes of the launch. A target is a text: the namespace that
a group or an include pushes is not put before it. It is an error where a container of that name is in another namespace, or of nearly that
name in the same one; a warning where there are others only. Nothing is said where the launch starts no container at all, since that may be
there already; where the file is the part of a launch in which the container gets a namespace put before its name; and where not all that is
started is known.

## Why it matters

`ros2 launch` waits for the container for ever. It says nothing, and the nodes are not there.

## Example

```xml
<launch>
  <group>
    <push_ros_namespace namespace="front"/>
    <node_container pkg="rclcpp_components" exec="component_container" name="images" namespace=""/>
    <load_composable_node target="images">
      <composable_node pkg="image_proc" plugin="image_proc::RectifyNode" name="rectify"/>
    </load_composable_node>
  </group>
</launch>
```

## Use instead

```xml
<launch>
  <group>
    <push_ros_namespace namespace="front"/>
    <node_container pkg="rclcpp_components" exec="component_container" name="images" namespace=""/>
    <load_composable_node target="/front/images">
      <composable_node pkg="image_proc" plugin="image_proc::RectifyNode" name="rectify"/>
    </load_composable_node>
  </group>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.model import Node, UnknownText
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at
from launchlint.source import Origin
from launchlint.spelling import closest, one_slip

_STARTED = {"pkg": "rclcpp_components", "exec": "component_container", "name": "…", "namespace": "…"}
RULE = Rule("LL937", "container-missing", Severity.ERROR)
_MOST_NAMED = 6


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """All targets without a node (launch_ros.actions.LoadComposableNodes calls a service of the target's)."""
    launch = view.launch
    loaded = [node for node in launch.nodes if node.container is not None and "container" in node.places]
    if not loaded:
        return
    hosts = [node for node in launch.nodes if node.kind != "composable"]
    names = {node.full_name for node in hosts if node.name}
    containers = sorted(node.full_name for node in hosts if node.name and _is_container(node))
    known = launch.complete and all(node.name and node.knows("name", "namespace") for node in hosts)
    told: set[tuple[str, int]] = set()
    for node in loaded:
        place, target = node.places["container"], node.container or ""
        if place.key in told:
            continue
        told.add(place.key)
        full = target if target.startswith("/") else f"/{target}"
        unsure = isinstance(target, UnknownText) or any(each.assumed for each in node.conditions)
        elsewhere = not containers or any(full.endswith(name) for name in containers)
        if full in names or not known or unsure or not target or (elsewhere and not view.declared_entry):
            yield RULE.fine(place)
            continue
        near = _near(full, containers)
        yield RULE.at(
            Origin(place, node.origin.step),
            f"no node is called {full}, the container to load into",
            severity=_severity(view, near is not None),
            label="no such container",
            notes=(*_here(containers), "ros2 launch waits for the container for ever"),
            help=f"write {near}: a target is taken as it is, without the namespace that is pushed"
            if near is not None and near.rpartition("/")[2] == full.rpartition("/")[2]
            else f"did you mean {near}?"
            if near is not None
            else f"start it: {words_at(place).written('node_container', _STARTED, 'ComposableNodeContainer(name=…, namespace=…, …)')}",
        )


def _is_container(node: Node) -> bool:
    return node.kind == "container" or node.package == "rclcpp_components"


def _near(full: str, containers: list[str]) -> str | None:
    """A container of the same name in another namespace, else one of nearly the same full name."""
    last = full.rpartition("/")[2]
    same = [name for name in containers if name.rpartition("/")[2] == last]
    return same[0] if same else one_slip(full, containers) or closest(full, containers)


def _severity(view: LaunchView, near: bool) -> Severity:
    """An error only where nothing has to be given for it: who switches a node on may switch its container on, too."""
    if view.declared_entry:
        return Severity.ERROR
    worst = Severity.ERROR if near else Severity.WARNING
    return Severity(worst - 1) if view.launch.given else worst


def _here(containers: list[str]) -> tuple[str, ...]:
    return (f"the containers here are {', '.join(containers[:_MOST_NAMED])}",) if containers else ()
