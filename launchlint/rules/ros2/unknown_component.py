"""A composable node is of a class that its package does not register.

What it does: where the package is here and its CMake files tell all that it registers with `rclcpp_components_register_node` and
`rclcpp_components_register_nodes`, it compares the `plugin` with that. Where the package is not here the library is asked: a name that is
near a class that it knows is an error where the library lists all components of the package, else an info: the class may have
another name in the release that is used.

## Why it matters

The container starts, fails to load the node, and goes on without it. `ros2 launch` prints the failure among everything else.

## Example

```xml example.launch.xml
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="images" namespace="">
    <composable_node pkg="image_proc" plugin="image_proc::Rectify" name="rectify"/>
  </node_container>
</launch>
```

```yaml .launchlint.yaml
library: [nodes.json]
```

```json nodes.json
{"format": "launchlint-library", "version": 2, "packages": {
  "image_proc": {"middleware": "ros2", "complete": ["components"], "components": {
    "image_proc::RectifyNode": {"class": "component", "variants": {"default": {}}},
    "image_proc::DebayerNode": {"class": "component", "variants": {"default": {}}}}}
}}
```

## Use instead

```xml example.launch.xml
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="images" namespace="">
    <composable_node pkg="image_proc" plugin="image_proc::RectifyNode" name="rectify"/>
  </node_container>
</launch>
```

```yaml .launchlint.yaml
library: [nodes.json]
```

```json nodes.json
{"format": "launchlint-library", "version": 2, "packages": {
  "image_proc": {"middleware": "ros2", "complete": ["components"], "components": {
    "image_proc::RectifyNode": {"class": "component", "variants": {"default": {}}},
    "image_proc::DebayerNode": {"class": "component", "variants": {"default": {}}}}}
}}
```
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Instance
from launchlint.rules.judging.package_contents import installs
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.source import Origin
from launchlint.spelling import closest, one_slip

RULE = Rule("LL938", "unknown-component", Severity.ERROR)
_MOST_NAMED = 6


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every composable node (rclcpp_components::ComponentManager::create_component_factory)."""
    for instance in view.graph.instances:
        if instance.kind != "component" or not instance.node.knows("package", "executable"):
            continue
        package, name = instance.node.package, instance.program
        here = view.packages.colcon.get(package, view.launch.entry.file)
        if here is None:
            known: Collection[str] = view.library.nodelets(package)
            complete = view.library.has_all_nodelets(package)
        else:
            found = installs(view.packages).of(here).components
            known, complete = found or (), found is not None
        if not known or name in known:
            continue
        near = _near(name, known)
        if near is not None or (complete and here is not None):
            yield _finding(instance, known, near, complete=complete, here=here is not None)


def _near(name: str, known: Collection[str]) -> str | None:
    """The class that was probably meant: the same but for what stands before or between, or for a slip."""
    last = name.replace("/", "::").rpartition("::")[2]
    same = [each for each in sorted(known) if each.rpartition("::")[2] in (last, f"{last}Node", f"{last}Component")]
    return same[0] if len(same) == 1 else one_slip(name, known) or closest(name, known)


def _finding(instance: Instance, known: Collection[str], near: str | None, *, complete: bool, here: bool) -> Finding:
    node = instance.node
    # What a library lists in part is of one release: in another one the class may be called otherwise.
    severity = Severity.WARNING if complete or here else Severity.INFO
    severity = Severity.ERROR if complete and instance.certain else severity
    some = sorted(known)
    return RULE.at(
        Origin(node.places.get("executable", node.origin.place), node.origin.step),
        f"the package {node.package} registers no component {instance.program}"
        if complete
        else f"the package {node.package} has a component {near}, and {instance.program} is not known",
        severity=severity,
        label="no such class" if complete else "not known",
        notes=(
            f"it has: {', '.join(some[:_MOST_NAMED])}{' …' if len(some) > _MOST_NAMED else ''}",
            "the container starts and cannot load it: the node is not there",
        ),
        help=f"did you mean {near}?" if near is not None else "correct the class, or register it in the CMakeLists.txt of its package",
        cause=f"{severity.word} {node.package} {instance.program}",
    )
