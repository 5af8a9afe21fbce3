"""Two nodes of one launch have the same name.

What it does: it compares the full names of all nodes that would start together, after namespaces, arguments and includes are
worked out and with the conditions as they are. Nodes that exclude each other by `if` and `unless` are no duplicates. `/rosout`
belongs to roscore, whose own file `roscore.xml` may start it. Where the names meet only when an arg has another value than its default
and no launch file here gives it that one, it is a warning; an info, if another arg can switch off one of the two: nodes behind switches of
their own (`if="$(arg real)"`, `if="$(arg simulation)"`) are alternatives. What two includes of one file, one include of several files that
others include, too, or one such value bring about is told once, and so is a node of a file whose name several of those that include it use
again, and a block of nodes that stands twice. In ROS 2 it is a warning: launch itself warns, and starts them all.

## Why it matters

A name is the address of a node: its private parameters, its logs and its private topics hang on it. roslaunch refuses to start
anything as soon as two nodes share one, often because a file is included twice.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="localization"/>
  <include file="sensors.launch"/>
</launch>
```

```xml sensors.launch
<launch>
  <node pkg="ekf" type="filter" name="localization"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="localization"/>
  <include file="sensors.launch"/>
</launch>
```

```xml sensors.launch
<launch>
  <node pkg="ekf" type="filter" name="odometry_filter"/>
</launch>
```

## Fix

`--unsafe-fixes` removes the second node where both are equal (program, args, remaps, params). Where one of two equal nodes stands in a file
that the file of the other one includes, it removes the other: somebody else may include that file for its node. Else it puts a number
behind the name of the second: `camera_2`. Other launch files and nodes may know it by its old name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.names import UNKNOWN_NAMESPACE
from launchlint.evaluate.problems import DuplicateNode
from launchlint.finding import Finding, Fix, Severity
from launchlint.model import Node
from launchlint.rules.edits import LOADS, fix, is_literal, remove_element, set_value, spot
from launchlint.rules.judging.included_twice import told_of_includes, ways
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.source import Place
from launchlint.syntax.ros1.substitutions import parse
from launchlint.syntax.tree import Element

RULE = Rule("LL301", "duplicate-node-name", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: DuplicateNode, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``duplicate-node`` (roslaunch.config.ROSLaunchConfig.add_node)."""
    if of_ros2(view):
        from launchlint.rules.judging.ros2_nodes import one_name

        yield from one_name(problem, RULE, view)
        return
    name = problem.name.replace(UNKNOWN_NAMESPACE, "…")
    stops = f"roslaunch stops with: roslaunch file contains multiple nodes named [{name}]"
    if problem.core:
        if problem.place.source.path.rpartition("/")[2] == "roscore.xml":
            return
        yield RULE.at(
            problem.origin, f"{name} is the name of a node that roscore starts itself", label="taken", notes=(stops,),
            help="give the node another name, or put it into a namespace",
        )  # fmt: skip
        return
    first: Node = problem.first
    second: Node = problem.second
    related = _way_to(first, second)
    tried = view.tried
    notes = (stops,) if not tried else (stops, f"only with {tried}, which is not what this launch file does by itself")
    switches = _own_switches(first, second, view) if tried else []
    if switches:
        notes = (*notes, f"one of the two hangs on {' and '.join(switches)}, so that they may be alternatives")
    twice = first.origin.place == second.origin.place
    equal = not twice and _are_equal(first, second, view)
    if not twice:
        related = ((problem.related[0][0], "the first one"), *related)
    yield RULE.at(
        problem.origin,
        f"the node {name} is started twice" if twice else f"two nodes are named {name}",
        label="its file is included twice" if twice else "the second one",
        severity=Severity.INFO if switches else Severity.WARNING if tried else None,
        related=related,
        notes=notes,
        cause=_cause(first, second, tried, view),
        about=(name, *(ways(first, second) if twice else ())),
        help="let one arg choose between the two, with if and unless"
        if switches
        else _removed(first, second)[1]
        if equal
        else _advice(first, second, twice),
        fix=None if twice or switches else _removal(first, second, view) if equal else _fix(problem, view),
    )


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for all files that one include brings once more."""
    return told_of_includes(findings)


def _own_switches(first: Node, second: Node, view: LaunchView) -> list[str]:
    """The args that can switch off one of the two and not the other, beside those that were tried."""
    steers: dict[Place, frozenset[str]] = {}
    for branch in view.launch.branches:
        steers[branch.origin.place] = steers.get(branch.origin.place, frozenset()) | branch.steered_by
    one, other = (
        frozenset().union(*(steers.get(condition.place, frozenset()) for condition in node.conditions)) for node in (first, second)
    )
    return sorted((one ^ other) - {name for name, _ in view.launch.given})


def _cause(first: Node, second: Node, tried: str, view: LaunchView) -> str:
    """What all nodes that meet share: the args that are tried, the node of an included file whose name others use, the include that brings
    the second one beside what is there already, or else the name.
    """
    if tried:
        return f"{view.launch.entry.path} {tried}"
    if not second.origin.chain and first.origin.chain:
        return f"included {first.origin.place.key}"
    if first.origin.chain == second.origin.chain and first.origin.place.source is second.origin.place.source:
        return f"{[each.key for each in (first.origin.place, *first.origin.chain)]} {second.origin.place.source.path}"
    there, brought = first.origin.chain, second.origin.chain
    shared = next((at for at, (one, other) in enumerate(zip(there, brought, strict=False)) if one != other), min(len(there), len(brought)))
    if len(brought) > shared:
        return f"brought by {brought[shared].key}"
    return f"{second.origin.place.source.path} {[place.key for place in there]}"


def _are_equal(first: Node, second: Node, view: LaunchView) -> bool:
    """Whether both start the same program in the same way: what acts on them is the same, and so is what is written inside them.

    Who writes ``$(anon …)`` wants several of them.
    """
    if first.unknown or second.unknown or _acting_on(first) != _acting_on(second):
        return False
    one, other = (_element(node, view) for node in (first, second))
    if (
        one is None
        or other is None
        or _is_made_up(other.get("name") or "")
        or any(one.get(name) != other.get(name) for name in ("if", "unless"))
    ):
        return False
    here = first.origin.chain == second.origin.chain and first.origin.place.source is second.origin.place.source
    inside = _written(one)
    return inside == _written(other) and (here or "$" not in repr(inside))


def _is_made_up(written: str) -> bool:
    return any(parse(written).substitutions("anon"))


def _acting_on(node: Node) -> tuple[object, ...]:
    remaps = [(each.source, each.target) for each in node.remaps]
    environment = [(each.name, each.value) for each in node.environment]
    started = (node.package, node.executable, node.machine, node.arguments.split(), node.launch_prefix, node.cwd)
    return (*started, node.output, node.respawn, node.required, remaps, environment)


def _element(node: Node, view: LaunchView) -> Element | None:
    place = node.places.get("name")
    at = None if place is None else spot(view, place)
    return None if at is None else at.element


def _written(element: Element) -> list[object]:
    """What is written inside an element, at any depth (the parser bounds it), without its layout."""
    return [
        (child.tag, sorted((name, child.get(name)) for name in child.attributes), child.text.strip(), _written(child))
        for child in element.children
    ]


def _removed(first: Node, second: Node) -> tuple[Node | None, str]:
    """Which of two equal nodes nobody misses, and the advice: never one in a file that others may include for it, the including file aside.

    Whoever starts the file of the one also gets the other if that is in the same file, or in one that is included there.
    """
    if first.conditions != second.conditions:
        return None, "they start the same, under different conditions: let one arg choose, or remove one"
    paths = [node.origin.place.source.path for node in (first, second)]
    ways = [tuple(place.key for place in node.origin.chain) for node in (first, second)]
    if ways[0] == ways[1] and paths[0] == paths[1]:
        return second, "remove the second one, which starts the same once more"
    for outer, node, word in ((0, first, "first"), (1, second, "second")):
        inner = 1 - outer
        depth = len(ways[outer])
        if ways[inner][:depth] == ways[outer] and len(ways[inner]) > depth and ways[inner][depth][0] == paths[outer]:
            return node, f"remove the {word} one, in {paths[outer]}: {paths[inner]}, which is included there, starts the same"
    return None, "they start the same: remove the one that no other launch file needs"


def _removal(first: Node, second: Node, view: LaunchView) -> Fix | None:
    node = _removed(first, second)[0]
    if node is None:
        return None
    at = spot(view, node.places["name"])
    which = "second" if node is second else "first"
    return fix(f"remove the {which} one", remove_element(at), safe=False, changes=f"{LOADS}, and the node is started once")


def _new_names(view: LaunchView) -> dict[Place, str]:
    """What each node whose name is taken may be called: a number behind its name, the first one that no other node has."""
    taken = set(view.node_names)
    numbers: dict[str, int] = {}
    names: dict[Place, str] = {}
    for problem in view.launch.problems:
        if not isinstance(problem, DuplicateNode) or problem.core:
            continue
        place = problem.second.places.get("name")
        if place is None or place in names:
            continue
        name: str = problem.second.name
        number = numbers.get(name, 2)
        while f"{name}_{number}" in taken:
            number += 1
        names[place] = f"{name}_{number}"
        taken.add(names[place])
        numbers[name] = number + 1
    return names


def _fix(problem: DuplicateNode, view: LaunchView) -> Fix | None:
    second: Node = problem.second
    place = second.places.get("name")
    if place is None or not is_literal(place, second.name):
        return None
    name = view.once(_new_names).get(place, f"{second.name}_2")
    return fix(f"call the second {name}", set_value(spot(view, place), name), safe=False, changes=f"{LOADS}, and the second node is {name}")


def _way_to(first: Node, second: Node) -> tuple[tuple[Place, str], ...]:
    """The includes that lead to the first node and not to the second."""
    shared = set(second.origin.chain)
    return tuple((place, "the first one comes from this include") for place in first.origin.chain if place not in shared)[-3:]


def _advice(first: Node, second: Node, twice: bool) -> str:
    written = {place.text for node in (first, second) if (place := node.places.get("name")) is not None}
    if len(written) == 1 and _is_made_up(next(iter(written))) and not twice:
        return "give each $(anon …) an id of its own: one id stands for one name in its scope"
    if twice:
        return "include the file once, or with another ns each time"
    return "rename one, or put them into different namespaces"
