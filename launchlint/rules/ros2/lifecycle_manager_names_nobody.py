"""A lifecycle manager of Navigation2 waits for a node that the launch does not start.

What it does: it looks at the `node_names` of each `nav2_lifecycle_manager`, where all of its params are known. A name is relative to the
namespace of the manager. It is an error where a node of nearly that name, or of that name in another namespace, is started; a warning where
none is, in a launch of which everything is known. Nothing is said where that node may be started by somebody else: where an include could
not be followed, where the name of a node is not known, or where none of the names is there at all.

## Why it matters

The manager activates the nodes in their order, and stops at the first that is not there. The ones behind it, and those before it, stay
inactive or are shut down again: nothing moves, and the nodes that are to blame say nothing.

## Example

```xml example.launch.xml
<launch>
  <node pkg="nav2_map_server" exec="map_server" name="map_server"/>
  <node pkg="nav2_amcl" exec="amcl" name="amcl"/>
  <node pkg="nav2_lifecycle_manager" exec="lifecycle_manager" name="lifecycle_manager">
    <param name="node_names" value="map_servr, amcl" value-sep=", "/>
  </node>
</launch>
```

## Use instead

```xml example.launch.xml
<launch>
  <node pkg="nav2_map_server" exec="map_server" name="map_server"/>
  <node pkg="nav2_amcl" exec="amcl" name="amcl"/>
  <node pkg="nav2_lifecycle_manager" exec="lifecycle_manager" name="lifecycle_manager">
    <param name="node_names" value="map_server, amcl" value-sep=", "/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Instance
from launchlint.rules.judging.ros2_params import place_of
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.spelling import closest

RULE = Rule("LL940", "lifecycle-manager-names-nobody", Severity.ERROR)
_MANAGER = "nav2_lifecycle_manager"
_NAMES = "node_names"
_MOST_TOLD = 20
"""Names of one manager that are told: who has more of them has one mistake."""


def check(view: GraphView) -> Iterator[Finding]:
    """Compare what each manager manages with what is started (nav2_lifecycle_manager::LifecycleManager)."""
    instances = view.graph.instances
    managers = [each for each in instances if each.node.package == _MANAGER and each.certain and each.node.own]
    if not managers or not view.launch.complete or not all(_is_named(each) for each in instances):
        return
    started = {each.name for each in instances}
    for manager in managers:
        _, value = (manager.node.own or {}).get(_NAMES, ("", None))
        listed = [each for each in value if isinstance(each, str) and each] if isinstance(value, tuple) else []
        wanted = {each: _full(each, manager) for each in listed}
        absent = [name for name, full in wanted.items() if full not in started]
        if absent and len(absent) < len(wanted):
            yield from _of_manager(manager, absent, wanted, started, view)


def _is_named(instance: Instance) -> bool:
    return not instance.name.endswith(")") and instance.node.knows("name", "namespace")


def _full(name: str, manager: Instance) -> str:
    return name if name.startswith("/") else f"{manager.namer.namespace.rstrip('/')}/{name}"


def _of_manager(manager: Instance, absent: list[str], wanted: dict[str, str], started: set[str], view: GraphView) -> Iterator[Finding]:
    spare = sorted(started - set(wanted.values()))
    for name in absent[:_MOST_TOLD]:
        full = wanted[name]
        elsewhere = [each for each in spare if each.rpartition("/")[2] == name.rpartition("/")[2]]
        near = elsewhere[0] if len(elsewhere) == 1 else closest(full, spare)
        yield RULE.at(
            place_of(manager, _NAMES),
            f"{manager.name} manages {name}, and no node {full} is started",
            severity=Severity.ERROR if near is not None and not view.launch.given else Severity.WARNING,
            label="node_names",
            notes=("the manager waits for it: none of its nodes is activated",),
            help=f"did you mean {near}?" if near is not None else f"start it, or take {name} out of node_names",
            topic=full,
            cause=f"{full} {near}",
        )
