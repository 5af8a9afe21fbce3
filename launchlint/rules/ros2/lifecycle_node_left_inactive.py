"""A lifecycle node is started, and nobody activates it.

What it does: it looks at nodes with a lifecycle that have names only once they are configured, or active: those that a
`LifecycleNode` starts, those of Navigation2, and whatever other program has such nodes. It is told where nothing in the launch takes the
node from one state to the next: no `nav2_lifecycle_manager` has its name in `node_names`, no event or `LifecycleTransition` asks for it,
no other node calls its `change_state`, and its own program does not do it either.

Nothing is said where somebody may do it: where an include could not be followed or a node is not known, where a program is started that
is no node, where any configuration of any launch file of the workspace activates it, and where another file of the workspace, be it a
script or a README, has its name and a command that changes the state of nodes. Nor is it of a file that has args without a default, or
that another one of its package includes: what activates the node may be around it.

## Why it matters

A lifecycle node waits in the state *unconfigured* until somebody configures and then activates it. Until then it runs, complains
of nothing, and publishes, hears and serves nothing.

## Example

```xml example.launch.xml
<launch>
  <node pkg="nav2_map_server" exec="map_server" name="map_server"/>
</launch>
```

## Use instead

```xml example.launch.xml
<launch>
  <node pkg="nav2_map_server" exec="map_server" name="map_server"/>
  <node pkg="nav2_lifecycle_manager" exec="lifecycle_manager" name="lifecycle_manager">
    <param name="autostart" value="true"/>
    <param name="node_names" value="map_server, " value-sep=", "/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Endpoint, Instance
from launchlint.rules.judging.lifecycle_states import MANAGER, managed_names, may_be_taken
from launchlint.rules.judging.name_places import node_origin
from launchlint.rules.judging.part_of_launch import is_part
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView
from launchlint.workspace.ros2_distributions import AGE

RULE = Rule("LL950", "lifecycle-node-left-inactive", Severity.WARNING)
_SINCE = {"slam_toolbox": "jazzy"}
"""Packages whose nodes were plain ones before that distribution."""
_MOST_NAMED = 4


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at each lifecycle node (the managed nodes of ROS 2: https://design.ros2.org/articles/node_lifecycle.html)."""
    instances = view.graph.instances
    if not any(each.lifecycle for each in instances):
        return
    part = is_part(view)
    managers = [each for each in instances if each.node.package == MANAGER]
    for instance in instances:
        if not instance.lifecycle or not instance.certain or not _has_lifecycle(instance, view):
            continue
        missing = [end for end in instance.endpoints if _comes_later(end)]
        if not missing or instance.name.endswith(")") or may_be_taken(instance, view):
            yield RULE.fine(node_origin(instance))
            continue
        if part:
            continue
        yield RULE.at(
            node_origin(instance),
            f"nobody activates {instance.name}, a lifecycle node",
            label="it stays unconfigured",
            notes=(
                f"until it is {_state(missing)} it does not have {_listed(missing)}",
                *(f"{each.name} manages {', '.join(managed_names(each) or ('no node',))}" for each in managers[:_MOST_NAMED]),
            ),
            help=f"add its name to the node_names of {managers[0].name}"
            if managers
            else "start a nav2_lifecycle_manager with autostart and its name in node_names, or have launch change its state",
            cause=f"{node_origin(instance).place.source.path} inactive",
        )


def _has_lifecycle(instance: Instance, view: GraphView) -> bool:
    """Whether it has one in every distribution that the repository names, where there are some in which its program was a plain node."""
    since, named = _SINCE.get(instance.node.package), view.launch.named
    return since is None or (bool(named) and all(AGE[each] >= AGE[since] for each in named))


def _comes_later(end: Endpoint) -> bool:
    declaration = end.declaration
    return end.certain and declaration.exists != "constructed" and not declaration.node and not end.is_plumbing


def _listed(ends: list[Endpoint]) -> str:
    names = list(dict.fromkeys(end.name for end in ends))
    return ", ".join(names[:_MOST_NAMED]) + (" …" if len(names) > _MOST_NAMED else "")


def _state(ends: list[Endpoint]) -> str:
    return "configured" if any(end.declaration.exists == "configured" for end in ends) else "active"
