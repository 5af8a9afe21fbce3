"""A node's `type` names no executable of its package.

What it does: where the package lies in the workspace or is installed, it looks for the `type` among the programs that its `CMakeLists.txt`
builds, its scripts, and its installed files. It is an error where the package is installed or the name is one slip away from a program of
it; otherwise a warning. Where the package is not here, the library is asked: a name that is one slip away from a program that it knows is
an error where the library lists all programs of the package, else a warning. Where the list of programs may have gaps, as with packages
below `/usr`, whose programs Debian distributes over several packages of its own, nothing is said but such a warning. Each program is told
of once, with all places that start it. A package without any programs is told of once, with all that is asked of it,
and so is one whose programs have an end like `.py` that the launch files leave out, or the other way round. It is an info where
an arg with an empty default makes the name: whoever starts the file gives it. Where another package of the workspace has a program of just
that name, the help names it; a program or script (with the executable bit or without) of the same name but for blanks, `_`, `-` or a
`_test` or `_node` at the end comes first. Where the command that would build the program is commented out in `CMakeLists.txt`, a note says
so. In ROS 2 only what is installed to `lib/PKG` counts, by `CMakeLists.txt` or by `setup.py` and `setup.cfg`: where these can be followed
to their end and nothing in the package is called so, it is an error. What is built or lies there and is not installed is told by LL946.
What a shell script or Makefile of the workspace copies to `install/…/lib/` or `devel/lib/` is passed over, where it names both the package
and the program. A package of ROS 2 that only brings a command (`ros2bag`) has no program that could be started.

## Why it matters

roslaunch loads such a file without a word and fails only when it starts the node, after the other nodes are up.

## Example

```xml
<launch>
  <node pkg="my_robot" type="drive_nod" name="drive"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
```

```cmake CMakeLists.txt
project(my_robot)
find_package(catkin REQUIRED)
catkin_package()
add_executable(drive_node src/drive.cpp)
```

## Use instead

```xml
<launch>
  <node pkg="my_robot" type="drive_node" name="drive"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
```

```cmake CMakeLists.txt
project(my_robot)
find_package(catkin REQUIRED)
catkin_package()
add_executable(drive_node src/drive.cpp)
```

## Fix

`--unsafe-fixes` writes the executable of the package that the name is one slip away from.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Fix, Severity
from launchlint.model import ROS2, Node
from launchlint.plural import listed
from launchlint.rules.edits import fix, is_literal, set_value, spot
from launchlint.rules.judging.commands import COMMANDS
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.judging.package_contents import contents, installs
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.rules.wording import words_at
from launchlint.source import Origin
from launchlint.spelling import closest, one_slip, same_letters, surely
from launchlint.syntax.ros1.substitutions import parse
from launchlint.workspace.cmake_comments import CMAKE_FILE, commented_out
from launchlint.workspace.cmake_mentions import may_build
from launchlint.workspace.packages import SYSTEM_SHARE

RULE = Rule("LL304", "unknown-executable", Severity.ERROR, roslaunch="reports", fixable="unsafe")

_MOST_NAMED = 6
_MOST_PACKAGES = 3
_NONE = "none at all"
_CORRECT = "correct the name, or let"
_WITH, _WITHOUT = "with", "without"
_SCRIPT_ENDS = (".py", ".sh", ".bash", ".pl", ".rb")


def check(view: GraphView) -> Iterator[Finding]:
    """Yield one finding for each node or test whose executable is not there (roslib.packages.find_node)."""
    if view.dialect.name == ROS2:
        yield from _in_ros2(view)
        return
    launch = view.launch
    for node in (*launch.nodes, *launch.tests):
        name = node.executable
        if not node.knows("package", "executable") or not name.strip() or "/" in name:
            continue
        package = view.packages.get(node.package, launch.entry.file)
        if package is None:
            yield from _by_library(node, view, here=False)
            continue
        known = contents(view.packages).executables(package)
        if name in known.by_name or known.flaw(name) is not None or _is_placed(package.name, name, view):
            continue
        slip = _slip(name, known.names)
        if not known.exhaustive and slip is not None and may_build(package.directory, name):
            slip = None  # by a list that is included where some variable says so
        exhaustive = known.exhaustive and not package.directory.startswith(SYSTEM_SHARE + "/")
        if not exhaustive and slip is None:
            yield from _by_library(node, view, here=True)
            continue
        assumed = any(condition.assumed for condition in node.conditions)
        certain = exhaustive and (known.installed or slip is not None) and not assumed
        scripts = [each for each in known.unrunnable if each.endswith(_SCRIPT_ENDS)]
        same = same_letters(name, known.names) or same_letters(name, scripts)
        if same in scripts:
            same = f"{same}, which lacks the executable bit"
        near = same or slip or closest(name, [other for other in known.names if not other.endswith("~")])
        some = _some(known.programs)
        notes = [f"it has: {some}" if some else "it has no executables at all"]
        line = commented_out(package.directory, package.name, name)
        if line is not None:
            cmake = shown(f"{package.directory}/{CMAKE_FILE}", root_of(node.origin.place.source))
            notes.append(f"the command that would build it is commented out in {cmake}, line {line}")
        left_empty = _left_empty(node, view)
        if left_empty:
            notes.append(f"the arg {left_empty} has an empty default: whoever starts this file gives it")
        severity = Severity.INFO if left_empty else Severity.ERROR if certain else Severity.WARNING
        others = contents(view.packages).having(name)
        reason = _end(name, near) or (name if near and known.names else f"in {' '.join(others)}" if others else _NONE)
        yield RULE.at(
            Origin(node.places.get("executable", node.origin.place), node.origin.step),
            f"the package {node.package} has no executable {name}",
            severity=severity,
            label="not found",
            notes=(*notes, "roslaunch loads the file and fails when it starts this node"),
            help=_help(
                node,
                same or slip,
                near,
                others,
                f"correct the type, or add {name} to the CMakeLists.txt or scripts of {node.package}",
            ),
            cause=f"{severity.word} {node.package}/{reason}",
            topic=name,
            fix=None if slip is None or same not in (None, slip) else _fix(node, view, slip),
        )


def together(findings: Sequence[Finding]) -> Finding:
    """All that is asked of a package and that it does not have, by the names."""
    whole = joined(findings)
    names = list(dict.fromkeys(each.topic for each in findings))
    package, _, reason = whole.cause.partition("/")
    package = package.rpartition(" ")[2]
    way, _, end = reason.partition(" ")
    if len(names) < 2 or (reason != _NONE and way not in (_WITH, _WITHOUT)):
        return whole
    if way in (_WITH, _WITHOUT):
        stems = [name.removesuffix(end) if way == _WITHOUT else name for name in names]
        return whole._replace(
            message=f"the package {package} has {len(names)} executables only {reason}: {listed(stems, _MOST_NAMED)}",
            help=f"write the names {reason}",
        )
    return whole._replace(
        message=f"the package {package} has none of {len(names)} executables: {listed(names, _MOST_NAMED)}",
        help=f"{whole.help.rpartition(' ')[0].replace('name', 'names', 1)} them"
        if whole.help.startswith(_CORRECT)
        else f"let the CMakeLists.txt of {package} build them, or correct the package",
        fix=None,
    )


def _is_placed(package: str, name: str, view: GraphView) -> bool:
    from launchlint.rules.judging.not_in_libexec import is_placed

    return is_placed(package, name, view.packages)


def _left_empty(node: Node, view: GraphView) -> str:
    """The arg with an empty default that the program's name is made of, where nobody gives it; empty where there is none."""
    place = node.places.get("executable")
    if place is None or node.origin.chain:
        return ""
    asked = {part.only for part in parse(place.text).substitutions("arg")} - dict(view.launch.given).keys()
    return next((each.name for each in view.launch.declared if each.name in asked and each.value is None and each.default == ""), "")


def _in_ros2(view: GraphView) -> Iterator[Finding]:
    """Likewise for ROS 2 (launch_ros.substitutions.ExecutableInPackage)."""
    from launchlint.rules.judging.not_in_libexec import build_file, missing_programs

    yield from _commands(view)
    for missing in missing_programs(view.launch, view.packages):
        if missing.built is not None or missing.file is not None:
            continue
        node, names = missing.node, list(missing.installed.libexec)
        slip = _slip(node.executable, names)
        same = same_letters(node.executable, names)
        longer = [each for each in names if each.endswith(f"_{node.executable}")]
        near = same or slip or min(longer, key=len, default=closest(node.executable, names))
        some = _some(names)
        severity = Severity.WARNING if any(condition.assumed for condition in node.conditions) else RULE.severity
        others = installs(view.packages).having(node.executable)
        reason = _end(node.executable, near) or (node.executable if near else f"in {' '.join(others)}" if others else _NONE)
        yield RULE.at(
            Origin(node.places.get("executable", node.origin.place), node.origin.step),
            f"the package {node.package} has no executable {node.executable}",
            severity=severity,
            label="not found",
            notes=(
                f"it has: {some}" if some else "it installs no executables at all",
                f"ros2 launch stops: executable '{node.executable}' not found on the libexec directory",
            ),
            help=_help(
                node,
                same or slip,
                near,
                others,
                f"{_CORRECT} {build_file(missing.package)} of {node.package} install {node.executable}",
            ),
            cause=f"{severity.word} {node.package}/{reason}",
            topic=node.executable,
            fix=None if slip is None or near != slip else _fix(node, view, slip),
        )


def _commands(view: GraphView) -> Iterator[Finding]:
    """Nodes of public packages that have a command of the tool ros2, and no program."""
    for node in view.launch.nodes:
        command = COMMANDS.get(node.package)
        if command is None or node.kind == "composable" or not node.knows("package", "executable") or not node.executable.strip():
            continue
        if view.packages.colcon.get(node.package, view.launch.entry.file) is not None:
            continue
        assumed = any(condition.assumed for condition in node.conditions)
        severity = Severity.WARNING if assumed else RULE.severity
        origin = Origin(node.places.get("executable", node.origin.place), node.origin.step)
        yield RULE.at(
            origin,
            f"the package {node.package} has no executables: it brings the command ros2 {command}",
            severity=severity,
            label="not found",
            notes=(f"ros2 launch stops: executable '{node.executable}' not found on the libexec directory",),
            help=f"start ros2 {command} with {words_at(origin).tag('executable')}",
            cause=f"{severity.word} {node.package}/{_NONE}",
        )


def _end(name: str, near: str | None) -> str:
    """How the program is called, ``with .py`` or ``without .py``, where nothing but the end of a script tells the two names apart."""
    for end in _SCRIPT_ENDS if near else ():
        if near == f"{name}{end}":
            return f"{_WITH} {end}"
        if name == f"{near}{end}":
            return f"{_WITHOUT} {end}"
    return ""


def _help(node: Node, slip: str | None, near: str | None, others: Sequence[str], otherwise: str) -> str:
    """A slip first; then the packages ``others`` that have just this program; then whatever is similar."""
    if slip is None and 0 < len(others) <= _MOST_PACKAGES:
        *most, last = others
        return (
            f'{", ".join(most) + " and " if most else ""}{last} {"has" if not most else "have"} {node.executable}: is pkg="{last}" meant?'
        )
    if near:
        return f"did you mean {near}?"
    return otherwise


def _by_library(node: Node, view: GraphView, *, here: bool) -> Iterator[Finding]:
    """Where the package is not here, or not all that it builds can be seen: is it a slip for a program that the library knows?

    Programs of tests are seldom installed; and a package that is ``here`` may build what the library has never heard of.
    """
    name, library = node.executable, view.library
    known = library.executables(node.package)
    if not known or name in known or node in view.launch.tests or (view.packages.complete and not here):
        return
    complete = not here and library.has_all_executables(node.package)
    near = surely(name, known)
    if near is None or library.removed(node.package, "executables", near):
        return
    assumed = any(condition.assumed for condition in node.conditions)
    severity = Severity.ERROR if complete and not assumed else Severity.WARNING
    yield RULE.at(
        Origin(node.places.get("executable", node.origin.place), node.origin.step),
        f"the package {node.package} has no executable {name}"
        if complete
        else f"the package {node.package} has {near}, and {name} is not known",
        severity=severity,
        label="not found" if complete else "not known",
        notes=(f"the library knows of it: {_some(known)}", "roslaunch loads the file and fails when it starts a node that is not there"),
        help=f"did you mean {near}?",
        cause=f"{severity.word} {node.package}/{name}",
        fix=_fix(node, view, near),
    )


def _fix(node: Node, view: GraphView, slip: str) -> Fix | None:
    place = node.places.get("executable")
    if place is None or not is_literal(place, node.executable):
        return None
    return fix(f"write {slip}", set_value(spot(view, place), slip), safe=False, changes=f"{slip} is started")


def _slip(name: str, names: list[str]) -> str | None:
    """The one executable that ``name`` is a slip for; ``drive1`` and ``drive2`` are neighbours, not slips."""
    names = [other for other in names if not other.endswith("~")]  # what an editor left behind is not what was meant
    stem = name.removesuffix(".py")
    for other in names:
        if other != name and other.removesuffix(".py") == stem:
            return other
    return one_slip(name, names)


def _some(names: Sequence[str]) -> str:
    return ", ".join(names[:_MOST_NAMED]) + (" …" if len(names) > _MOST_NAMED else "")
