"""A file that the launch needs is in the sources of its package, and its build installs it nowhere.

What it does: for each file that is included, given to a node for params, or named in its arguments, and that `$(find-pkg-share …)` leads
to, it looks whether the package installs it: by `install(…)` or `ament_auto_package(…)` in `CMakeLists.txt`, or by `data_files` in
`setup.py`, which is read and never run. Nothing is said where the build files cannot be followed to their end. It is a warning where only
an argument of a node names the file, and where the condition around it cannot be worked out. The files of one directory are told of
together.

## Why it matters

`$(find-pkg-share …)` is the directory that the package is installed to, whether the file lies in the sources or not. The launch stops at
an include that is not there; a file of params that is not there is passed over with a warning, and the node runs with its defaults.

## Example

```xml launch/robot.launch.xml
<launch>
  <include file="$(find-pkg-share my_robot)/launch/camera.launch.xml"/>
</launch>
```

```xml launch/camera.launch.xml
<launch/>
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
install(FILES launch/robot.launch.xml DESTINATION share/${PROJECT_NAME}/launch)
ament_package()
```

## Use instead

```xml launch/robot.launch.xml
<launch>
  <include file="$(find-pkg-share my_robot)/launch/camera.launch.xml"/>
</launch>
```

```xml launch/camera.launch.xml
<launch/>
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
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
ament_package()
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.model import Condition
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.not_in_libexec import build_file
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin
from launchlint.workspace.ament.shares import Shared, shared
from launchlint.workspace.looking import exists

RULE = Rule("LL945", "not-installed", Severity.ERROR, roslaunch="refuses")

_INCLUDED = "ros2 launch stops when it comes to this include"
_PARAMS = "the node is started without these params"
_ARGUMENT = "the program is given a path that does not exist"


class _Use(NamedTuple):
    """A file that is named: by what, with which effect if it is missing."""

    file: str
    origin: Origin
    conditions: tuple[Condition, ...]
    effect: str


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield a finding for each file that is certainly not installed (ament_index_python.packages.get_package_share_directory)."""
    root = root_of(view.launch.entry)
    texts = [document.source.text for document in view.documents.values()]
    only_by_share = any("find-pkg-share" in text for text in texts) and not any("dirname" in text for text in texts)
    places: dict[str, Shared | None] = {}
    for use in _uses(view):
        if not posixpath.isabs(use.file):
            continue
        if use.file not in places:
            places[use.file] = _lacking(view, use.file)
        place = places[use.file]
        if place is None or not _by_share(use, texts, only_by_share):
            continue
        if place.installed.share_paths(use.file) and not _written(place.path, use, texts):
            continue  # found at the place that it is installed to
        build = shown(posixpath.join(place.package.directory, build_file(place.package)), root)
        severity = Severity.WARNING if use.effect == _ARGUMENT or any(each.assumed for each in use.conditions) else RULE.severity
        top = posixpath.dirname(place.path)
        yield RULE.at(
            use.origin,
            f"{place.path} of the package {place.package.name} is not installed",
            severity=severity,
            label="not there once the package is installed",
            notes=(f"{build} installs nothing to this place: the file is in the sources only", use.effect),
            help=_help(place),
            topic=place.path,
            cause=f"{severity.word} {place.package.directory} {top}",
            about=(place.package.name,),
        )


def _lacking(view: LaunchView, file: str) -> Shared | None:
    """Where ``file`` would lie below the share directory of its package, if it is there in the sources and is not installed."""
    place = shared(view.packages, file)
    return place if place is not None and exists(file) and place.installed.lacks(place.path) else None


def together(findings: Sequence[Finding]) -> Finding:
    """The files of one directory."""
    whole = joined(findings)
    files = sorted({finding.topic for finding in findings})
    if len(files) < 2:
        return whole
    return whole._replace(message=f"{', '.join(files)} of the package {findings[0].about[0]} are not installed")


def _uses(view: LaunchView) -> Iterator[_Use]:
    for include in view.launch.includes:
        yield _Use(include.file, include.origin, include.conditions, _INCLUDED)
    for node in view.launch.nodes:
        for source in node.sources:
            file = source.of if source.file is None else source.file
            if file is not None:
                yield _Use(file, source.origin, node.conditions, _PARAMS)
        if node.process is not None:
            for word in node.process.arguments:
                at = Origin(node.places.get("arguments", node.origin.place), node.origin.step)
                yield _Use(word.rpartition("=")[2], at, node.conditions, _ARGUMENT)


def _by_share(use: _Use, texts: Sequence[str], only: bool) -> bool:
    """Whether the path comes from ``$(find-pkg-share …)``: written there; or, where a variable gives it or the place is no more than a key
    of YAML, ``only`` by that, for all that the ``texts`` of the launch files say: they have one, none of them uses ``$(dirname)``, and none
    writes the path out.
    """
    text = use.origin.place.text
    if "find-pkg-share" in text:
        return "dirname" not in text
    return only and not any(use.file in each for each in texts)


def _written(path: str, use: _Use, texts: Sequence[str]) -> bool:
    """Whether the launch files name the place in the sources, and not the one that the file is installed to."""
    text = use.origin.place.text
    return path in text or ("find-pkg-share" not in text and any(path in each for each in texts))


def _help(place: Shared) -> str:
    directory, name = posixpath.split(place.path)
    top = directory.partition("/")[0]
    if build_file(place.package) == "setup.py":
        return f"add ('{posixpath.join('share', place.package.name, directory).rstrip('/')}', ['{place.path}']) to data_files in setup.py"
    what = f"DIRECTORY {top}" if top else f"FILES {name}"
    return f"add install({what} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt"
