"""Two nodes of one launch have the same name.

What it does: it compares the full names of all nodes that would start together, after namespaces, arguments and includes are
worked out and with the conditions as they are. Nodes that exclude each other by `if` and `unless` are no duplicates. `/rosout`
belongs to roscore, whose own file `roscore.xml` may start it. Where the names meet only when an arg has another value than its default
and no launch file here gives it that one, it is a warning. What two includes of one file, or one such value, bring about is told once.

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

`--unsafe-fixes` puts a number behind the name of the second node: `camera_2`. Other launch files and nodes may know it by its old name.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.names import UNKNOWN_NAMESPACE
from launchlint.finding import Finding, Fix, Severity
from launchlint.model import Node
from launchlint.problem import Problem
from launchlint.rules.edits import LOADS, fix, is_literal, set_value, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Place

RULE = Rule("LL301", "duplicate-node-name", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``duplicate-node`` (roslaunch.config.ROSLaunchConfig.add_node)."""
    name = problem.facts["name"].replace(UNKNOWN_NAMESPACE, "…")
    stops = f"roslaunch stops with: roslaunch file contains multiple nodes named [{name}]"
    if problem.facts["core"]:
        if problem.place.source.path.rpartition("/")[2] == "roscore.xml":
            return
        yield RULE.at(
            problem.origin, f"{name} is the name of a node that roscore starts itself", label="taken", notes=(stops,),
            help="give the node another name, or put it into a namespace",
        )  # fmt: skip
        return
    first: Node = problem.facts["first"]
    second: Node = problem.facts["second"]
    related = _way_to(first, second)
    tried = view.tried
    notes = (stops,) if not tried else (stops, f"only with {tried}, which is not what this launch file does by itself")
    twice = first.origin.place == second.origin.place
    if not twice:
        related = ((problem.related[0][0], "the first one"), *related)
    yield RULE.at(
        problem.origin,
        f"the node {name} is started twice" if twice else f"two nodes are named {name}",
        label="its file is included twice" if twice else "the second one",
        severity=Severity.WARNING if tried else None,
        related=related,
        notes=notes,
        cause=_cause(first, second, tried, view),
        help=_advice(first, second, twice),
        fix=None if twice else _fix(second, view),
    )


def _cause(first: Node, second: Node, tried: str, view: LaunchView) -> str:
    """What all nodes that meet share: the args that are tried, or else the two includes that they come from."""
    if tried:
        return f"{view.launch.entry.path} {tried}"
    if not second.origin.chain:
        return ""
    ways = ((place.source.path, place.span.start) for node in (first, second) for place in node.origin.chain)
    return f"{second.origin.place.source.path} {[*ways]}"


def _fix(second: Node, view: LaunchView) -> Fix | None:
    """The second node gets a number behind its name, the first one that no node here has."""
    place = second.attributes.get("name")
    if place is None or not is_literal(place, second.name):
        return None
    taken = view.node_names
    name = next(each for number in range(2, len(taken) + 3) if (each := f"{second.name}_{number}") not in taken)
    return fix(f"call the second {name}", set_value(spot(view, place), name), safe=False, changes=f"{LOADS}, and the second node is {name}")


def _way_to(first: Node, second: Node) -> tuple[tuple[Place, str], ...]:
    """The includes that lead to the first node and not to the second."""
    shared = set(second.origin.chain)
    return tuple((place, "the first one comes from this include") for place in first.origin.chain if place not in shared)[-3:]


def _advice(first: Node, second: Node, twice: bool) -> str:
    written = {node.attributes["name"].text for node in (first, second) if "name" in node.attributes}
    if len(written) == 1 and "$(anon " in next(iter(written)) and not twice:
        return "give each $(anon …) an id of its own: one id stands for one name in its scope"
    if twice:
        return "include the file once, or with another ns each time"
    return "rename one, or put them into different namespaces"
