"""A node is started from a package that does not exist.

What it does: it looks for the `pkg` of every node and test among the packages of the workspace, the installed ones, the public index, and
the repositories that a `.gitmodules`, `*.rosinstall` or `*.repos` of the workspace names. It is an error where every package is known (a
ROS installation is set up here, or the configuration says `packages: complete`) or where the name is one slip away from a package that is
here or that a `package.xml` here declares; a warning where the name is much like that of a package that is here, declared or public, or is
one that is here with a number or its end twice (`arm_2` beside `arm`); else an info, since it may well lie in another repository of the
same people. So it is where a document names it, or a script, a workflow or an image fetches something of that name. Public packages that
are only not installed here are passed over, and so is a package inside another one where an image, a workflow or a script of the workspace
lets colcon look for packages there (`--base-paths`).
Each package is told of once, with all files that need it. Where a file looks for it with `$(find …)`, too, LL210 tells, and
the two rules are told as one.

## Why it matters

roslaunch loads such a file without a word and fails only when it starts the node, after the other nodes are up.

## Example

```xml
<launch>
  <node pkg="my_robto" type="drive.py" name="drive"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
</package>
```

## Use instead

```xml
<launch>
  <node pkg="my_robot" type="drive.py" name="drive"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
</package>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import PackageNotFound
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.first_of_file import all_but_first
from launchlint.rules.judging.missing_package import cause, judge, told_of_all
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.source import Origin, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.problems import NodePackageMissing
    from launchlint.model import Node

RULE = Rule("LL303", "unknown-package", Severity.ERROR, roslaunch="reports")


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Yield one finding for each package that is not there (roslaunch.rlutil.check_roslaunch), at its first node or test of a file.

    The places behind it are in order for this rule: in another configuration one of them may be the first.
    """
    if of_ros2(view):
        from launchlint.evaluate.ros2.problems import NodePackageMissing

        yield from all_but_first(RULE, ((each, each.package) for each in view.launch.noticed(NodePackageMissing)))
        return
    launch = view.launch
    told = {
        (problem.place.source.path, problem.package) for problem in launch.noticed(PackageNotFound)
    }  # by LL210, of which roslaunch takes notice first
    missing: dict[tuple[str, str], list[Node]] = {}
    for node in (*launch.nodes, *launch.tests):
        name = node.package
        if node.knows("package") and name.strip() and not view.packages.has(name):
            missing.setdefault((_place(node).source.path, name), []).append(node)
    for (path, name), nodes in missing.items():
        if (path, name) in told:
            yield from (RULE.fine(_place(each)) for each in nodes)
            continue
        node = min(nodes, key=lambda each: _place(each).span.start)
        judgement = judge(name, view.packages, node.origin.place.source.file, node.origin.place.source.text)
        if judgement is None:
            continue
        assumed = any(condition.assumed for condition in node.conditions)
        severity = min(judgement.severity, Severity.WARNING) if assumed else judgement.severity
        place = _place(node)
        others = {_place(each) for each in nodes} - {place}
        yield from (RULE.fine(other) for other in sorted(others, key=lambda each: each.span.start))
        notes = [judgement.why] if judgement.why else []
        if launch.refused is None:
            notes.append("roslaunch loads the file and fails when it starts this node")
        if others:
            notes.append(f"{len(others)} more in this file {'is' if len(others) == 1 else 'are'} of {name} too")
        yield RULE.at(
            Origin(place, node.origin.step),
            f"there is no package {name}" if judgement.severity is Severity.ERROR else f"the package {name} is not known here",
            severity=severity,
            label="not found",
            notes=tuple(notes),
            help=judgement.help,
            shared_cause=cause(name, severity, judgement),
            about=(name,),
        )


def tell(problem: NodePackageMissing, view: LaunchView) -> Iterator[Finding]:
    """What launch itself stops at, in ROS 2."""
    from launchlint.rules.judging import ros2_names as ros2_words

    return ros2_words.package(problem, RULE, view)


def _place(node: Node) -> Place:
    return node.places.get("package", node.origin.place)


def together(findings: Sequence[Finding]) -> Finding:
    """One for all packages that are missing for one reason."""
    return told_of_all(findings)
