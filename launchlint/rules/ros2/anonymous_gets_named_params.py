"""The params for a node stand under a name in a file, and the launch file does not give the node that name.

What it does: it looks for a parameter file with names only, no `/**`, that is given to a node without `name`, or with one of `$(anon …)`.
It is a warning where no key can be that of the node: the name is made up for each start, no key is in the node's namespace, or the sources
or a library say what the program calls itself, and it is something else. Where they say that it calls itself as the file does, nothing is
told. Else it is information: they reach the node as long as its program calls itself so, and nothing is said where that is what the program
is called. Where several programs are given the file it is, too: it may be for a node that one of them makes beside its own.

## Why it matters

The node starts with the defaults of its program, and nobody says so: at once, or when its author calls it something else.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="$(anon talker)">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
talker:
  ros__parameters:
    rate: 5
```

## Use instead

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="$(anon talker)">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
/**:
  ros__parameters:
    rate: 5
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import NamedForUnnamed
from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Instance
from launchlint.rcl.table import reaches
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.rules.wording import SHARED, words_at

RULE = Rule("LL944", "anonymous-gets-named-params", Severity.WARNING)


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every file of params under names only that a node without a name is given."""
    for problem in view.launch.noticed(NamedForUnnamed):
        if problem.anonymous or problem.certain:
            yield _told(problem)
            continue
        runs = [each for each in view.graph.instances if _is_of(problem, each)]
        names = {name for each in runs for name in _names(each)}
        if any(reaches(key, name) for key in problem.keys for name in names):
            continue
        name = "" if _may_be_another(runs) else ", ".join(sorted({each.name for each in runs}))
        if name or not any(key.rpartition("/")[2] == problem.program for key in problem.keys):  # else it is as everybody may expect
            yield _told(problem, name)


def _is_of(problem: NamedForUnnamed, instance: Instance) -> bool:
    node = instance.node
    return not node.name and node.executable == problem.program and node.namespace.rstrip("/") == problem.namespace.rstrip("/")


def _names(instance: Instance) -> set[str]:
    """The full names of the nodes that a program is known to make."""
    return {instance.name, *(f"{instance.node.namespace.rstrip('/')}/{each}" for each in _others(instance))}


def _others(instance: Instance) -> set[str]:
    """The further nodes of a program that have names or params, as the library calls them."""
    return {*(each.declaration.node for each in instance.endpoints), *(each.declaration.node for each in instance.readings)} - {""}


def _may_be_another(runs: list[Instance]) -> bool:
    """Whether there may be a node of a name that is not known: a program that nobody knows, or that is not known as a whole."""
    return not runs or any(each.name.endswith(")") or each.doubts or set(each.open) - {"params"} for each in runs)


def _told(problem: NamedForUnnamed, name: str = "") -> Finding:
    """Say under which key they would reach it; ``name`` is that of the node, where it is known."""
    file, keys = problem.file.rpartition("/")[2], ", ".join(problem.keys)
    words = words_at(problem.origin)
    note = f"the keys of the file: {keys}"
    if problem.anonymous:
        message = f"nothing in {file} reaches this node: its name is made up for each start"
        advice = f"write /** as the key, or give the node a name without {words.call('anon', '…')}"
    elif problem.certain:
        message = f"nothing in {file} reaches {problem.program}: no key is in its namespace {problem.namespace}"
        advice = f"write /** as the key, or the full name, which begins with {problem.namespace.rstrip('/')}/"
    elif name:
        message = f"nothing in {file} reaches {problem.program}: it calls itself {name}"
        advice = f"write {name} as the key, or give the node a name here: {words.set_to('name', problem.keys[0].rpartition('/')[2])}"
    else:
        message = f"{file} reaches {problem.program} only if it calls itself {keys}: the launch file does not say its name"
        note = "a node without a name here has the one that its program gives it"
        advice = f"say it here, too: {words.set_to('name', problem.keys[0].rpartition('/')[2])}"
    others = (SHARED,) if problem.shared else ()
    return RULE.at(
        problem.origin,
        message,
        severity=None if (problem.anonymous or problem.certain or name) and not problem.shared else Severity.INFO,
        label="params under names",
        notes=(note, *others),
        help=advice,
        cause=f"{problem.file} {problem.anonymous} {problem.certain} {name}",
    )
