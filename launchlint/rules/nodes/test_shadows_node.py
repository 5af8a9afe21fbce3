"""A test has the same full name as a node it runs beside, or as another test.

What it does: it compares the node names of all tests (`name`, or `test-name` where that is missing) with those of the nodes.
roslaunch compares only nodes with nodes. Nothing is told of a test in Python that makes no node (no
`rospy.init_node`): nobody bears its name.

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

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.model import Launch, Node
from launchlint.rules.judging.joined import led_by
from launchlint.rules.judging.nodeless_test import makes_no_node
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin, Place

RULE = Rule("LL313", "test-shadows-node", Severity.WARNING)


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each test that bears the name of a node or of an earlier test (rosmaster's RegistrationManager)."""
    launch = view.launch
    nodes: dict[str, Node] = {}
    for node in launch.nodes:
        if _is_known(node):
            nodes.setdefault(node.full_name, node)
    for test in launch.tests:
        other = nodes.get(test.full_name) if _is_known(test) else None
        if other is not None and not makes_no_node(test.package, test.executable, view):
            yield RULE.at(
                Origin(_place(test), test.origin.step), f"the test {test.full_name} has the name of a node it runs beside",
                label="this test",
                related=((other.places.get("name", other.origin.place), "this node is shut down when the test starts"),),
                help="give the test another name",
            )  # fmt: skip
    for first, test in twins(launch):
        if test.full_name in nodes:
            continue
        shared = any(each.name.startswith(f"{test.full_name}/") for each in launch.parameter_settings)
        yield RULE.at(
            Origin(_place(test), test.origin.step), f"two tests are named {test.full_name}", label="the second one",
            related=((_place(first), "the first one"),),
            notes=("both get the private parameters of both",) if shared else ("nothing tells them apart in logs and parameters",),
            help="give each test a name of its own",
            shared_cause=named(test.full_name),
        )  # fmt: skip


def together(findings: Sequence[Finding]) -> Finding:
    """The name is told before the private parameters that its tests set one after the other."""
    return led_by(findings, RULE.id)


def twins(launch: Launch) -> Iterator[tuple[Node, Node]]:
    """The first test of a name, and each other one that has it."""
    earlier: dict[str, Node] = {}
    for test in filter(_is_known, launch.tests):
        first = earlier.setdefault(test.full_name, test)
        if first is not test and first.test_name != test.test_name and first.origin.place != test.origin.place:
            yield first, test


def named(name: str) -> str:
    """The cause that all findings have which come from two tests with the full ``name``."""
    return f"tests named {name}"


def _place(test: Node) -> Place:
    return test.places.get("name") or test.places.get("test_name", test.origin.place)


def _is_known(node: Node) -> bool:
    return bool(node.name) and node.knows("name", "namespace") and not any(condition.assumed for condition in node.conditions)
