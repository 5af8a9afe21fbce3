"""A parameter file is given to a ROS 2 node, and a key in it that is meant for the node does not reach it.

A key is the full name of a node, or has wildcards: `/**` is all of them, `/**/n` every `n`. Without a slash, `n` is `/n` and nothing else:
a node in a namespace has another full name. It is an info where the key is the name of the node with a namespace before it, which a
launch file that includes this one may push.

Nothing is said of keys for a node of that name in other namespaces where the node has a key of its own: such a file is for several robots;
nor of a file for a costmap of nav2, which is a node beside that of its server, nor of a key that is near the name of the node and is that
of another program of its package (`map_saver` beside `/map_server`). Where several programs are given a file with nothing for the node, it
is an info: one of them may make a node of that name.

## Why it matters

The node starts without these params, with the defaults of its program, and nobody says so.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker" namespace="front">
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
  <node pkg="demo_nodes_cpp" exec="talker" name="talker" namespace="front">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
/front/talker:
  ros__parameters:
    rate: 5
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import ParametersForNobody
from launchlint.finding import Finding, Severity
from launchlint.library.shipped import Bundled
from launchlint.model import ROS2
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import SHARED

RULE = Rule("LL901", "params-for-nobody", Severity.WARNING)


def tell(problem: ParametersForNobody, view: LaunchView) -> Iterator[Finding]:
    """Say which key was meant for the node, and what it would have to be."""
    if problem.near == "spelling" and _is_of_another(problem, view):
        return
    file, node, key = problem.file.rpartition("/")[2], problem.node, problem.key
    if not problem.near:
        yield RULE.at(
            problem.origin,
            f"nothing in {file} is for {node}",
            severity=Severity.INFO if problem.shared else None,
            label=f"the node is {node}",
            related=problem.related,
            notes=(f"its keys: {', '.join(problem.keys)}", *((SHARED,) if problem.shared else ())),
            help=f"add the key {node} or /**, or do not give the file to this node",
            cause=f"{problem.file} nobody",
        )
        return
    last = node.rpartition("/")[2]
    every = f", or /**/{last} for every {last}" if problem.wildcards else ""
    means = f"{key} is /{key} and nothing else" if not key.startswith("/") else f"{key} is another name"
    around = f"/{key.lstrip('/')}".removesuffix(node) if problem.near == "namespace" else ""
    included = bool(around) and f"{around}{node}" == f"/{key.lstrip('/')}"  # for a launch file that includes this one
    yield RULE.at(
        problem.origin,
        f"the params under {key} do not reach {node}",
        severity=Severity.INFO if included else None,
        label="no node that is given this file has that name",
        related=problem.related,
        notes=(
            f"{means}, and the node is {node}",
            *([f"they do where the launch file is included with the namespace {around} pushed"] if included else []),
        ),
        help=f"did you mean {node}?" if problem.near == "spelling" else f"write {node}{every}",
        cause=f"{problem.file.rpartition('/')[0]} namespace" if problem.near == "namespace" else f"{problem.file} {key}",
        about=(node.split("/")[1],) if problem.near == "namespace" and node.startswith("/") and "/" not in key else (),
    )


def _is_of_another(problem: ParametersForNobody, view: LaunchView) -> bool:
    """Whether another program of the node's package, as it is known of public ones, calls its node by the name of the key."""
    node = next((each for each in view.launch.nodes if each.full_name == problem.node and each.knows("package")), None)
    known = None if node is None else Bundled(ROS2).package(node.package)
    if node is None or known is None:
        return False
    name = problem.key.rpartition("/")[2]
    programs = [each for table in ("executables", "components") for each in known.get(table, {}).values()]
    return any(way.get("node") == name for each in programs for way in each.get("variants", {}).values())


def idea(finding: Finding) -> tuple[object, ...] | None:
    """The keys of files of several packages all lack the namespace that the launch files of all of them push."""
    return finding.about or None
