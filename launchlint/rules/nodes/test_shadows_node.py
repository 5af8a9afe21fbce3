"""A test has the same full name as a node it runs beside, or as another test.

What it does: it compares the node names of all tests (`name`, or `test-name` where that is missing) with those of the nodes.
roslaunch compares only nodes with nodes.

## Why it matters

When the test starts, the ROS master shuts down the node that has the name: the test runs against a system without it. Tests of
one name get each other's private parameters.

## Example

```xml example.test
<launch>
  <node pkg="amcl" type="amcl" name="amcl"/>
  <test pkg="amcl" type="basic_localization.py" test-name="localization" name="amcl"/>
</launch>
```

## Use instead

```xml example.test
<launch>
  <node pkg="amcl" type="amcl" name="amcl"/>
  <test pkg="amcl" type="basic_localization.py" test-name="localization" name="amcl_test"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.model import Node
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin

RULE = Rule("LL313", "test-shadows-node", Severity.WARNING)


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each test that bears the name of a node or of an earlier test (rosmaster's RegistrationManager)."""
    launch = view.launch
    nodes: dict[str, Node] = {}
    for node in launch.nodes:
        if _is_known(node):
            nodes.setdefault(node.full_name, node)
    earlier: dict[str, Node] = {}
    for test in launch.tests:
        if not _is_known(test):
            continue
        name = test.full_name
        place = test.places.get("name") or test.places.get("test_name", test.origin.place)
        other = nodes.get(name)
        if other is not None:
            yield RULE.at(
                Origin(place, test.origin.step), f"the test {name} has the name of a node it runs beside", label="this test",
                related=((other.places.get("name", other.origin.place), "this node is shut down when the test starts"),),
                help="give the test another name",
            )  # fmt: skip
            continue
        first = earlier.setdefault(name, test)
        if first is not test and first.test_name != test.test_name and first.origin.place != test.origin.place:
            shared = any(setting.node == name for setting in launch.parameter_settings)
            yield RULE.at(
                Origin(place, test.origin.step), f"two tests are named {name}", label="the second one",
                related=((first.places.get("name") or first.places.get("test_name", first.origin.place), "the first one"),),
                notes=("both get the private parameters of both",) if shared else ("nothing tells them apart in logs and parameters",),
                help="give each test a name of its own",
            )  # fmt: skip


def _is_known(node: Node) -> bool:
    return bool(node.name) and node.knows("name", "namespace") and not any(condition.assumed for condition in node.conditions)
