"""A launch file is not among the files that its package installs.

What it does: where `CMakeLists.txt` can be read to the end and installs something, it looks whether some `install(DIRECTORY …)` or
`install(FILES …)` takes the launch file. Tests, examples and experiments are passed over, what was put aside (`old`, `tmp`), files of
params that are no launch files by their names, packages that install nothing at all, or nothing that exists,
and what an `EXCLUDE` of `install(DIRECTORY …)` leaves out: that is done on purpose; and packages below a `CATKIN_IGNORE`. It is an info
where the package installs nothing but headers, and where all it has is `catkin_install_python`, which makes scripts run in a devel space,
too, or it installs none of the programs that it builds (a rest of a template), or nothing but programs, libraries, headers and descriptions
of plugins, which is what catkin's template offers, and was never released; unless a script, a workflow, an image or a README installs what
is built. Where one of the files that it installs by name does not exist, installing fails, and it is an info, too. So it is where the file,
or a directory above it, is commented out in an `install()`: it is left out on purpose. And it is one for a file beside `CMakeLists.txt`
where another one of its name is installed. All files of one package that are missing for one reason are told of at once, and so are those
of several packages that each leave out directories of the same names.

## Why it matters

From a source workspace the file is found. From an installed or released package it is missing.

## Example

```xml launch/robot.launch
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
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
  <exec_depend>usb_cam</exec_depend>
</package>
```

```cmake CMakeLists.txt
project(my_robot)
find_package(catkin REQUIRED)
catkin_package()
install(DIRECTORY config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
```

```yaml config/camera.yaml
frame_rate: 30
```

## Use instead

```xml launch/robot.launch
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
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
  <exec_depend>usb_cam</exec_depend>
</package>
```

```cmake CMakeLists.txt
project(my_robot)
find_package(catkin REQUIRED)
catkin_package()
install(DIRECTORY config launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
```

```yaml config/camera.yaml
frame_rate: 30
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.plural import listed
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.judging.other_file import is_inside, root_of, shown
from launchlint.rules.judging.package_contents import contents
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView
from launchlint.syntax.tree import Document
from launchlint.workspace.cmake_comments import left_out_of_install
from launchlint.workspace.looking import exists, is_file, question
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.put_aside import put_aside

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.cmake_targets import Install

RULE = Rule("LL702", "launch-not-installed", Severity.WARNING)
DEVEL = "it has catkin_install_python only, which a devel space needs, too; nothing here installs the package"
FAILS = "it installs {}, which does not exist, so that installing fails: nobody installs the package as it is"
OFFERED = "it installs only what catkin's template offers (programs, libraries, headers), and nothing here installs the package"
LEFT = "it installs none of the programs that it builds, and nothing here installs the package"

_LEFT_OUT = "it is commented out in an install() (line {}), so that it is left out on purpose"
_SHARE = "DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}"
_OF_LAUNCH = "launch"
_MOST_NAMED = 6
_NOT_MEANT = late(r"(?:^|[/_.-])(?:tests?|examples?|debug|dev|sandbox|scripts|experimental|experiments?|tmp|temp|wip)\d*(?:[/_.-]|$)")
_STARTING = frozenset(("node", "test", "include", "machine"))


@question
def _is_installed(packages: Packages, manifest_path: str) -> bool:
    """Whether a step that installs is written where it speaks of a package: above it, or in a directory beside what lies above it."""
    homes = [each.directory for place in packages.places[: len(packages.workspaces)] for each in place.everything]
    for directory in packages.distributions().installs:
        scope = directory
        while scope != posixpath.dirname(scope) and not any(is_inside(f"{home}/package.xml", (scope,)) for home in homes):
            scope = posixpath.dirname(scope)
        if is_inside(manifest_path, (scope,)):
            return True
    return False


def _is_data(install: Install) -> bool:
    """Whether files for people or nodes to read are installed: descriptions of plugins come with a library."""
    return (install.destination or "share").partition("/")[0] == "share" and (install.is_directory or not install.path.endswith(".xml"))


def _fails(install: Install, package: Package) -> bool:
    """Whether a file of the package is to be installed that is not there; git keeps no empty directory, so that those say nothing."""
    return not install.is_directory and not install.optional and is_inside(install.path, (package.directory,)) and not exists(install.path)


def check(view: FileView) -> Iterator[Finding]:
    """Yield a finding where the launch file is not installed (cmake-commands(7), install)."""
    document, packages = view.document, view.packages
    file = posixpath.abspath(document.source.file)
    package = packages.package_of(file)
    if package is None or package.broken or package.is_metapackage or not is_inside(file, packages.workspaces):
        return
    inside = posixpath.relpath(file, package.directory)
    cmake = posixpath.join(package.directory, "CMakeLists.txt")
    if document.launch is None or not is_file(cmake) or _NOT_MEANT.search(inside) or packages.is_hidden(package.directory):
        return
    installed = contents(packages).installs(package)
    if not installed.installs or not installed.exhaustive or installed.covers(file) or installed.leaves_out(file):
        return
    if put_aside(inside) or _is_piece(document):
        return
    present = [each for each in installed.installs if exists(each.path)]
    if not present:  # such an install() fails: nobody installs this package
        return
    name = shown(cmake, root_of(document.source))
    directory = _to_install(inside)
    headers = all((each.destination or "").partition("/")[0] == "include" for each in present)
    unused = (
        LEFT
        if installed.leaves_programs
        else DEVEL
        if not installed.by_name
        else OFFERED
        if not (headers or package.name in public_names() or any(map(_is_data, present)))
        else ""
    )
    reason = unused if unused and not packages.answer(_is_installed, package.manifest_path) else ""
    if not directory:
        namesakes = (f"{posixpath.relpath(each, package.directory)}/{inside}" for each in installed.directories)
        reason = next((f"it installs {each}" for each in namesakes if is_file(posixpath.join(package.directory, each))), reason)
    absent = next((each.path for each in installed.installs if _fails(each, package)), "")
    if absent:
        reason = FAILS.format(posixpath.relpath(absent, package.directory))
    parts = inside.split("/")
    line = left_out_of_install(package.directory, package.name, {"/".join(parts[:end]) for end in range(1, len(parts) + 1)})
    if line is not None:
        reason = _LEFT_OUT.format(line)
    severity = Severity.INFO if headers or reason else RULE.severity
    meant = f"it installs {'headers' if headers else 'other files'}, so that the package is meant to be installed"
    yield RULE.at(
        document.place(document.launch.name_span),
        f"{name} does not install this file",
        severity=severity,
        label="missing from an installed package",
        notes=(reason or meant,),
        help=f"take it in again in line {line}, once it is to be installed"
        if line is not None
        else _installing([directory])
        if directory
        else f"add install(FILES {inside} {_SHARE})",
        cause=f"{severity.word} {name}{'' if line is None else ' left out'}",
        about=(package.name, *((directory,) if directory and not reason else ())),
    )


def _to_install(inside: str) -> str:
    """The directory of a package to install for a file of it; the outermost, unless that is one for sources and more. Empty for none."""
    directory = posixpath.dirname(inside)
    outer = inside.partition("/")[0] if directory else ""
    return directory if "/" in directory and _OF_LAUNCH not in outer and _OF_LAUNCH in directory else outer


def _installing(directories: Sequence[str]) -> str:
    """The commands that install directories of a package at the same paths."""
    by_parent: dict[str, list[str]] = {}
    for each in directories:
        by_parent.setdefault(posixpath.dirname(each), []).append(each)
    return "add " + " and ".join(f"install(DIRECTORY {' '.join(each)} {_SHARE}{at and f'/{at}'})" for at, each in by_parent.items())


def _is_piece(document: Document) -> bool:
    """Whether nobody would start the file: it starts nothing itself, and is not called a launch file."""
    called = _OF_LAUNCH in posixpath.basename(document.source.path)
    return not called and not any(each.tag in _STARTING for each in document.elements)


def together(findings: Sequence[Finding]) -> Finding:
    """One for all launch files of one package that are not installed, with all directories they lie in."""
    told = joined(findings)
    directories = sorted({each for finding in findings for each in finding.about[1:]})
    if told.severity is Severity.INFO or len(directories) < 2 or any(not each.about[1:] for each in findings):
        return told
    return told._replace(help=_installing(directories), about=(*told.about[:1], *directories))


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for packages that leave out directories of the same names: several forget it in the same way."""
    for several in alike(findings, lambda each: each.about[1:] or each.key):
        told = joined(several) if len(several) > 1 else several[0]
        packages = list(dict.fromkeys(each.about[0] for each in several if each.about))
        if len(packages) > 1:
            files = len({told.location.path, *(each.location.path for each in told.related)})
            names = listed(packages, _MOST_NAMED)
            told = told._replace(message=f"{len(packages)} packages do not install {files} of their launch files: {names}")
        yield told
