"""Something that older versions of ROS knew and that has no place in a launch file any more.

The `<master>` tag (roslaunch starts a master by itself), the `ros-root`, `ros-package-path`, `ros-ip` and `ros-hostname` attributes and
the `<env>` children of a `<machine>`, the `ns` attribute of `<rosparam>` (it is called `param` now), and the program `xacro.py`, which ROS
Noetic does not have. So are programs and params of which the library knows that a distribution removed them
(`robot_state_publisher/state_publisher`, `use_gui` of joint_state_publisher), where the package is not in the workspace. A param that is
set to what was its default is an info: it changed nothing when it was still read. One that is shadowed by the node's own private param is
left alone. What a distribution removed is an info, too, where the workspace itself (a README, a workflow, an image, a script; where none
of these names any, the templates of the `CMakeLists.txt`) names older distributions only, where the package is built with rosbuild (it
has a `manifest.xml`), and where a launch file of the same package, or its `package.xml`, needs a public package that was never released for
that distribution. Each such program or param, `<master>` and `ns` are told of once, with all places; so is what roslaunch refuses of
machines.

## Why it matters

Some are ignored, some still work, some make roslaunch refuse the file: none does what the author once relied on.

## Example

```xml
<launch>
  <master auto="start"/>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Fix

`--fix` removes `<master>` and attributes that are empty, and writes `param` for the `ns` of a `<rosparam>`: nothing changes, which is
proved before it is done. It writes `xacro` for `xacro.py`: the command is another one then, and where the workspace is for distributions
before Kinetic only `--unsafe-fixes` does so. `--unsafe-fixes` removes attributes of `<machine>` that roslaunch refuses.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.finding import Finding, Fix, Severity
from launchlint.graph.connections import Instance, Reading
from launchlint.model import Role
from launchlint.rules.edits import LOADS, fix, is_literal, remove_attribute, remove_element, rename_attribute, replace, set_value, spot
from launchlint.rules.judging.of_rosbuild import AS_USUAL, is_of_rosbuild
from launchlint.rules.judging.other_file import is_inside
from launchlint.rules.judging.package_contents import contents
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, GraphView, LaunchView
from launchlint.source import Origin, Place
from launchlint.syntax.problems import DeprecatedConstruct
from launchlint.workspace.packages import SYSTEM_SHARE, Packages
from launchlint.workspace.releases import never_released

RULE = Rule("LL111", "deprecated-construct", Severity.WARNING, fixable="safe")


STOPS = "roslaunch stops with: <machine>: {} not supported since ROS Fuerte."
SCRIPT = "set the environment in a script and name that in env-loader"

# Construct → message, note, help; the attributes of <machine> are all alike.
WORDS = {
    "<master>": (
        "<master> has no effect",
        "roslaunch ignores it since ROS Fuerte, and says so",
        "remove it: roslaunch starts a master by itself",
    ),
    "rosparam ns": (
        "ns on <rosparam> is the old name of param",
        "both still work, and are joined where both are given",
        "write param instead of ns",
    ),
    "xacro.py": (
        "ROS Noetic has no xacro.py",
        "the command is not found there, and the parameter that it fills cannot be set",
        "write xacro instead, which ROS Kinetic and Melodic have too",
    ),
    "machine env": ("<machine> takes no <env>", STOPS.format("<env> tag is"), SCRIPT),
}


WITH_XACRO = "kinetic"
"""The oldest distribution that is known to have a program xacro."""
ONE_HABIT = ("xacro.py", "<master>", "rosparam ns")
"""What is told once over all files: it is copied from one to the next, and mended everywhere alike."""


def check(view: GraphView) -> Iterator[Finding]:
    """Yield a finding for each program that is started and each param that is set although a distribution has it no more."""
    for instance in view.graph.instances:
        yield from _program(instance, view)
    for name, readings in view.graph.readers.items():
        setting = view.graph.parameters.setting(name)
        if setting is None or not all(reading.declaration.removed for reading in readings):
            continue
        reading = next((each for each in readings if not _is_shadowed(each, view)), None)
        removed = None if reading is None else reading.declaration.removed
        if reading is None or removed is None:
            continue
        program = _of(reading.node, view)
        if _lies_here(program.partition("/")[0], view):
            continue  # which version that is nobody knows
        default = reading.declaration.default
        as_default = default is not None and setting.value == default
        old = _for_older(removed["in"], setting.origin.place, view.packages)
        severity = Severity.INFO if as_default or old else RULE.severity
        yield RULE.at(
            setting.origin,
            f"{program} has no param {reading.declared} in ROS {removed['in'].title()} any more",
            severity=severity,
            label="out of date",
            notes=("it is set to what was its default, and changed nothing when it was still read",)
            if as_default
            else ("nothing reads it there", *old),
            help="remove it" if as_default else _instead(removed, "remove it"),
            topic=f"removed {reading.declared}",
            cause=f"{severity.word} {program} {reading.declared.lstrip('~')}",
        )


def _is_shadowed(reading: Reading, view: GraphView) -> bool:
    """Whether the node has a private param of this name set, which it reads first (as get_param of joint_state_publisher does)."""
    own = f"{reading.node}/{reading.declared.lstrip('~/')}"
    return own != reading.name and view.graph.parameters.is_set(own)


def _program(instance: Instance, view: GraphView) -> Iterator[Finding]:
    node = instance.node
    role: Role = "executable"
    package, table, name = node.package, "executables", node.executable
    if instance.kind == "nodelet":
        role = "arguments"
        package, table, name = instance.program.partition("/")[0], "nodelets", instance.program
    removed = view.library.removed(package, table, name)
    if removed is None or _lies_here(package, view) or _is_settled(package, name, view):
        return
    place = node.places.get(role, node.origin.place)
    instead = removed.get("instead", "")
    change = None
    if instead and "/" not in instead and is_literal(place, name):
        change = fix(f"write {instead}", set_value(spot(view, place), instead), safe=False, changes=f"{instead} is started")
    old = _for_older(removed["in"], place, view.packages)
    yield RULE.at(
        Origin(place, node.origin.step),
        f"ROS {removed['in'].title()} has no {name} in {package} any more",
        severity=Severity.INFO if old else None,
        label="out of date",
        notes=("roslaunch loads the file there and fails when it starts this node", *old),
        help=_instead(removed, "remove the node"),
        fix=change,
        topic="removed",
        cause=f"{package}/{name}",
    )


def _for_older(distribution: str, place: Place, packages: Packages) -> tuple[str, ...]:
    """Why what this distribution lacks does not concern the file, for people; nothing where it may."""
    if packages.distributions().are_older_than(distribution):
        return ("the workspace names only older distributions of ROS",)
    home = packages.package_of(place.source.file)
    if is_of_rosbuild(home):
        return (AS_USUAL,)
    needed = "" if home is None else never_released((name for name in packages.needs(home) if not packages.has(name)), distribution)
    return (f"it needs {needed}, which was never released for ROS {distribution.title()}",) if needed else ()


def _lies_here(package: str, view: GraphView) -> bool:
    """Whether the package lies in a workspace: its own sources say what it has."""
    found = view.packages.get(package, view.launch.entry.file)
    return found is not None and is_inside(found.directory, view.packages.workspaces)


def _is_settled(package: str, name: str, view: GraphView) -> bool:
    """Whether an installation shows that the program is there, or shows all there is (then LL304 tells that it is not)."""
    found = view.packages.get(package, view.launch.entry.file)
    if found is None:
        return False
    known = contents(view.packages).executables(found)
    return name in known.by_name or (known.exhaustive and not found.directory.startswith(SYSTEM_SHARE + "/"))


def _instead(removed: Mapping[str, str], otherwise: str) -> str:
    return f"use {removed['instead']} instead" if "instead" in removed else otherwise


def _of(node: str, view: GraphView) -> str:
    return next((instance.program for instance in view.graph.instances if instance.name == node), node)


def tell(problem: DeprecatedConstruct, view: FileView | LaunchView) -> Iterator[Finding]:
    """Say what has taken its place."""
    construct: str = problem.construct
    attribute = construct.partition(" ")[2]
    machine = (f"<machine> takes no {attribute} any more", STOPS.format("ros-* attributes are"), SCRIPT)
    message, note, advice = WORDS.get(construct, machine)
    if construct.startswith("machine") and not problem.refused:
        note = "not supported since ROS Fuerte"
    older = _for_older("noetic", problem.place, view.packages) if construct == "xacro.py" else ()
    severity = Severity.ERROR if problem.refused else Severity.INFO if older or construct == "rosparam ns" else Severity.WARNING
    yield RULE.at(
        problem.origin,
        message,
        severity=severity,
        label="out of date",
        notes=(note, *older),
        help=advice,
        fix=_fix(
            construct, problem, view, is_there=not older and min(view.packages.distributions().meant, default=WITH_XACRO) >= WITH_XACRO
        ),
        cause=_cause(problem, severity),
    )


def _cause(problem: DeprecatedConstruct, severity: Severity) -> str:
    """What is told once: a habit, over all files, and so is what roslaunch refuses of machines."""
    if problem.refused:
        return "machine env" if problem.construct == "machine env" else "machine attributes"
    return f"{problem.construct} {severity.word}" if problem.construct in ONE_HABIT else ""


def _fix(construct: str, problem: DeprecatedConstruct, view: object, *, is_there: bool) -> Fix | None:
    """The change; it is safe if what is written instead ``is_there`` in every distribution that may be meant."""
    at = spot(view, problem.place)
    if construct == "<master>":
        return fix("remove it", remove_element(at), safe=True)
    if construct == "rosparam ns":
        return fix("write param", rename_attribute(at, "param"), safe=True)
    if construct == "xacro.py":
        return fix("write xacro", replace(at, problem.place, "xacro"), safe=is_there, changes="the command is xacro")
    if construct == "machine env" or at is None or at.attribute is None:
        return None
    if not at.attribute.value:
        return fix(f"remove {at.attribute.name}", remove_attribute(at), safe=True)
    return fix(f"remove {at.attribute.name}", remove_attribute(at), safe=False, changes=LOADS)
