"""The program of a node is built or lies in its package, and is not installed to where ROS 2 looks for it.

What it does: for each node whose package lies in the workspace, it works out what the package installs, from `CMakeLists.txt`, or from
`setup.py` and `setup.cfg`, which are read and never run. It tells of programs that are installed to another directory than `lib/PKG` (to
`bin`, say), that are built and not installed, and of scripts of this very name that are not installed. Nothing is said where the build
files cannot be followed to their end. It is a warning where the condition around the node cannot be worked out, and where the program is
built only if somebody switches on an `option()` that is off; and an info where the target or script is commented out in an `install()`: it
is left out on purpose. What no part of the package is called is told by LL304. All scripts of a `setup.py` that go to another directory are
one finding, and so are those of all packages of a workspace whose `setup.py` sends them to the same one, and all programs of a package that
installs none.

## Why it matters

`ros2 launch` and `ros2 run` look in `lib/PKG` of the place where the package is installed, and nowhere else. The launch stops with
`executable '…' not found on the libexec directory`, although the build went well.

## Example

```xml launch/robot.launch.xml
<launch>
  <node pkg="my_robot" exec="drive_node"/>
</launch>
```

```xml package.xml
<package format="3">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
```

```cmake CMakeLists.txt
project(my_robot)
find_package(ament_cmake REQUIRED)
add_executable(drive_node src/drive.cpp)
install(TARGETS drive_node)
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
ament_package()
```

## Use instead

```xml launch/robot.launch.xml
<launch>
  <node pkg="my_robot" exec="drive_node"/>
</launch>
```

```xml package.xml
<package format="3">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
```

```cmake CMakeLists.txt
project(my_robot)
find_package(ament_cmake REQUIRED)
add_executable(drive_node src/drive.cpp)
install(TARGETS drive_node DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
ament_package()
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping, Sequence

from launchlint.finding import Finding, Severity
from launchlint.plural import listed
from launchlint.rules.judging.joined import joined, spokesman
from launchlint.rules.judging.not_in_libexec import Missing, build_file, missing_programs
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin
from launchlint.workspace.cmake_comments import CMAKE_FILE, left_out_of_install
from launchlint.workspace.cmake_switches import switch_of

_MOST_NAMED = 3
_MOST_WRITTEN = 20
_ENTRY_POINTS = "console_scripts"
_NONE = "none at all"
LEFT_OUT = "it is commented out in an install(), so that it is left out on purpose: "
RULE = Rule("LL946", "not-in-libexec", Severity.ERROR, roslaunch="refuses")


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each node whose program is elsewhere (launch_ros.substitutions.ExecutableInPackage)."""
    launch = view.launch
    root = root_of(launch.entry)
    for missing in missing_programs(launch, view.packages):
        if missing.built is None and missing.file is None:
            continue
        node, package = missing.node, missing.package
        assumed = any(condition.assumed for condition in node.conditions)
        switch, line = _kept_back(missing)
        severity = Severity.INFO if line else Severity.WARNING if assumed or switch else RULE.severity
        file = shown(posixpath.join(package.directory, build_file(package)), root)
        yield RULE.at(
            Origin(node.places.get("executable", node.origin.place), node.origin.step),
            f"{node.executable} is not in lib/{package.name}: {_where(missing, switch)}",
            severity=severity,
            label="not found there",
            notes=(
                f"{LEFT_OUT}{file}, line {line}" if line else f"read in {file}",
                f"ros2 launch stops: executable '{node.executable}' not found on the libexec directory",
            ),
            help=_help(missing, switch),
            cause=f"{severity.word} {package.name}/{node.executable}" if switch or line else f"{severity.word} {_cause(missing)}",
            about=(package.name, missing.built or "", node.executable, *_added(missing)),
        )


def together(findings: Sequence[Finding]) -> Finding:
    """One for packages that all lack the same lines of ``setup.cfg``: it names them. One for what a package lacks that installs nothing."""
    packages = list(dict.fromkeys(each.about[0] for each in findings))
    first = spokesman(findings)
    if len(packages) > 1:
        message = (
            f"{len(packages)} packages install their programs to {first.about[1]}, and not to lib/PKG: {listed(packages, _MOST_NAMED)}"
        )
        return joined(findings, first._replace(message=message, help=f"{first.help}, and the same in the others"))
    programs = list(dict.fromkeys(each.about[2] for each in findings))
    told = joined(findings)
    if len(programs) < 2 or not first.cause.endswith(_NONE):
        return told
    kinds: dict[str, list[str]] = {}
    for kind, what in dict.fromkeys(each.about[3:5] for each in findings if each.about[3:]):
        kinds.setdefault(kind, []).append(what)
    return told._replace(
        message=f"the package {packages[0]} installs none of {len(programs)} programs that are started: {listed(programs, _MOST_NAMED)}",
        help=_add(kinds) if kinds else told.help,
    )


def idea(finding: Finding) -> tuple[object, ...] | None:
    """The packages got another name, all in the same way, and their programs still go to the directories of the old ones."""
    if finding.rule != RULE.id:
        return None
    new, old = finding.about[0].split("_"), finding.about[1].rpartition("/")[2].split("_")
    same = 0
    while same < min(len(new), len(old)) and new[-1 - same] == old[-1 - same]:
        same += 1
    renamed = new[: len(new) - same], old[: len(old) - same]
    return tuple("_".join(words) for words in renamed) if same and all(renamed) else None


def _kept_back(missing: Missing) -> tuple[str, int | None]:
    """The option without which the program is not built, and the line in which an ``install()`` has it in a comment; of CMake only."""
    package, name = missing.package, missing.node.executable
    if build_file(package) != CMAKE_FILE:
        return "", None
    line = None
    if missing.file is not None:
        line = left_out_of_install(package.directory, package.name, (posixpath.relpath(missing.file, package.directory),))
    elif missing.built == "":
        line = left_out_of_install(package.directory, package.name, (name,))
    return "" if missing.built is None else switch_of(package.directory, package.name, name), line


def _cause(missing: Missing) -> str:
    """``setup.cfg`` says of all scripts at once where they are installed; who leaves it out of one package knows of no other.

    Who installs no program has not thought of it: that is one slip, however many programs are started.
    """
    if missing.built and build_file(missing.package) == "setup.py":
        return f"setup.py {missing.built}"
    if not any(each.destination for each in missing.installed.programs):
        return f"{missing.package.name}/{_NONE}"
    return f"{missing.package.name}/{missing.node.executable}"


def _where(missing: Missing, switch: str) -> str:
    if missing.built:
        return f"it is installed to {missing.built}"
    if switch:
        return f"it is built only with -D{switch}=ON, and not installed"
    if missing.built == "":
        return "it is built and not installed"
    assert missing.file is not None
    return f"{posixpath.relpath(missing.file, missing.package.directory)} is not installed"


def _added(missing: Missing) -> tuple[str, ...]:
    """What is to be added for the program, and to which list; empty where that would not help."""
    name = missing.node.executable
    if build_file(missing.package) == "setup.py":
        return (_ENTRY_POINTS, name) if missing.built is None else ()
    if missing.built is not None:
        return ("TARGETS", name)
    assert missing.file is not None
    return ("PROGRAMS", posixpath.relpath(missing.file, missing.package.directory))


def _add(kinds: Mapping[str, Sequence[str]]) -> str:
    """The advice to add what is listed, by the kind that :func:`_added` gives."""
    if _ENTRY_POINTS in kinds:
        return f"add {listed(kinds[_ENTRY_POINTS], _MOST_WRITTEN)} to {_ENTRY_POINTS} in setup.py"
    return f"add {' and '.join(_command(kind, what) for kind, what in kinds.items())} to CMakeLists.txt"


def _command(kind: str, what: Sequence[str]) -> str:
    written = " ".join([*what[:_MOST_WRITTEN], *(["…"] if len(what) > _MOST_WRITTEN else [])])
    return f"install({kind} {written} DESTINATION lib/${{PROJECT_NAME}})"


def _help(missing: Missing, switch: str) -> str:
    made = [each.name for each in missing.installed.libexec.values() if missing.file in each.sources]
    if len(made) == 1:
        return f"write {made[0]}, which {build_file(missing.package)} makes of {posixpath.basename(missing.file or '')}"
    added = _added(missing)
    if not added:
        return f"write install_scripts=$base/lib/{missing.package.name} below [install] in setup.cfg, and script_dir below [develop]"
    kind, what = added
    return f"put {_command(kind, [what])} into the if({switch}) that builds it" if switch else _add({kind: [what]})
