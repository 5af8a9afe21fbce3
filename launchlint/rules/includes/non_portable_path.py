"""A file is named in a way that works on one machine or from one directory only.

What it does: it looks at the files that `<include>`, `<rosparam>`, `textfile` and `binfile` name, as they are written. It speaks about
absolute paths of includes, about paths below a home directory or a source workspace, about `~`, which roslaunch does not expand, about `..`
that leads out of the package (an info where it leads just into the package beside it, since packages lie side by side once installed, too,
and where it begins in a package that is not here: how that lies, its own people know), and about relative names, which count from the
directory roslaunch is started in. Absolute names of system configuration (`/etc`, `/dev`, `/tmp` and the like) are passed over, and so is
all that begins with a substitution other than `$(find …)` and `$(dirname)`.

Home directories that the containers of the workspace have (Dockerfiles, compose files, `docker run` in scripts) are passed over.

In the values of args and params, and in what nodes get as `args` or `env`, it speaks about paths below the home directory of one person
and about `..` that leads out of a package; that is an info where no package holds what is named, and so is `~`, which nodes expand or
do not. What stands in many places is told once.

## Why it matters

The launch breaks on the next robot, for the next user, or as soon as the package is installed.

## Example

```xml
<launch>
  <rosparam command="load" file="/home/ada/catkin_ws/src/my_robot/config/limits.yaml"/>
</launch>
```

## Use instead

```xml
<launch>
  <rosparam command="load" file="$(find my_robot)/config/limits.yaml"/>
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

```yaml config/limits.yaml
speed: 1.0
```

## Fix

`--fix` writes the path with `$(find …)` or `$(dirname)` where it leads to the same file here, which is proved before it is done.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import NamedTuple

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import Spot, fix, set_value
from launchlint.rules.rule import Rule
from launchlint.rules.template import is_path_to_fill_in
from launchlint.rules.view import FileView
from launchlint.source import Place
from launchlint.workspace.looking import exists

RULE = Rule("LL406", "non-portable-path", Severity.WARNING, fixable="safe")

_ATTRIBUTES = {"include": ("file",), "rosparam": ("file",), "param": ("textfile", "binfile")}
_TEXTS = {"arg": ("value", "default"), "param": ("value",), "node": ("args",), "test": ("args",), "env": ("value",)}
_HOME = r"(?<![\w.$/\\-])(?:/home/|/Users/)[\w.-]+/"
_TILDE = r"(?<![\w.$/\\-])~/(?:\.[\w-]|(?:[\w. -]+/)*[\w-]+\.[A-Za-z]\w{0,5}\b)[^\s\"';,:]*"
"""``~/.ros/x`` or ``~/maps/hall.yaml``; ``~/scan`` may well be a topic."""
_ANY_PACKAGE = "keep it in a package, and write $(find pkg)/…"
_SYSTEM = r"/(?:etc|dev|tmp|var|run|mnt|media|sys|proc|opt/(?!ros/))"
_PERSONAL = r"/home/[^/$]+/|/Users/[^/$]+/|/root/|/(?:[^/]*_ws|src)/|/opt/ros/|[A-Za-z]:[\\/]"
_PACKAGE = r"/(?:src|share)/(?:.*/)?(\w+)/((?:launch|config|params|param|cfg|urdf|maps|map)/.*)$"


class _Fault(NamedTuple):
    message: str
    note: str
    help: str
    severity: Severity | None = None
    cause: str = ""


def check(view: FileView) -> Iterator[Finding]:
    """Yield one finding for each file name that depends on the machine or the current directory."""
    document = view.document
    for element in document.elements:
        for name in _ATTRIBUTES.get(element.tag, ()):
            attribute = element.attributes.get(name)
            if attribute is None or not attribute.value or element.get("command") in ("dump", "delete"):
                continue
            fault = _fault(attribute.value, element.tag, view)
            if fault is not None:
                yield _finding(fault, Spot(document, element, attribute), _fix(fault, Spot(document, element, attribute)))
        for name in _TEXTS.get(element.tag, ()):
            attribute = element.attributes.get(name)
            if attribute is not None and ("/" in attribute.value or "\\" in attribute.value):
                fault = _home(attribute.value, view) or _out_of_package(attribute.value, view)
                if fault is not None:
                    yield _finding(fault, Spot(document, element, attribute), None)


def _finding(fault: _Fault, at: Spot, fix: Fix | None) -> Finding:
    span = at.element.start_span if at.attribute is None else at.attribute.shown_span
    return RULE.at(
        Place(at.document.source, span), fault.message, severity=fault.severity, label="not portable", notes=(fault.note,),
        help=fault.help, fix=fix, cause=fault.cause,
    )  # fmt: skip


def _home(text: str, view: FileView) -> _Fault | None:
    """A path below somebody's home directory in any text."""
    plain = re.sub(r"\$\([^()]*\)", "$", text)
    found = re.search(_HOME, plain)
    if found is not None and is_path_to_fill_in(found[0]):
        help = "fill it in, or make it an arg without a default"
        note = "it is a placeholder, which each user fills in"
        return _Fault(f"{found[0]}… is nobody's home directory", note, help, severity=Severity.INFO, cause=found[0])
    if found is not None and _is_in_container(found[0], view):
        return None
    if found is not None:
        help = "name files with $(find pkg)/…, others with $(env HOME)/… or an arg that each machine sets"
        return _Fault(f"{found[0]}… is somebody's home directory", "it is there on machines of that user only", help, cause=found[0])
    found = re.search(_TILDE, plain)
    if found is None:
        return None
    note = "roslaunch does not expand ~: it works only where the node does"
    return _Fault(f"{found[0]} begins with ~", note, "write $(env HOME)/…, which works for every node", Severity.INFO, "~")


def _is_in_container(path: str, view: FileView) -> bool:
    """Whether it lies in a home directory that a container of this workspace has: it is the same on each machine then."""
    found = re.match(r"/home/([\w.-]+)/", path)
    return found is not None and found[1] in view.packages.container_users()


def _out_of_package(text: str, view: FileView) -> _Fault | None:
    for found in re.finditer(r"\$\(\s*(?:find\s+[\w-]+|dirname)\s*\)[^$\s\"';,:]*", text):
        fault = _above(found[0], view)
        if fault is not None:
            known = fault.help != _ANY_PACKAGE
            start = "/".join(found[0].split("/")[:3])
            return fault._replace(severity=None if known else Severity.INFO, cause=f"{start} {fault.help if known else ''}")
    return None


def _fix(fault: _Fault, at: Spot) -> Fix | None:
    """The portable name, where the advice is one and no pattern; whether it leads to the same file is proved before it is written."""
    name = fault.help.removeprefix("write ")
    written = "" if at.attribute is None else at.attribute.value
    unseen = "…" in name or (written.startswith("/") and not exists(written))
    return None if unseen else fix(fault.help, set_value(at, name), safe=True)


def _fault(value: str, tag: str, view: FileView) -> _Fault | None:
    if value.startswith("~"):
        note = "roslaunch does not expand ~, and looks for a directory of that name"
        return _Fault(f"{value} begins with ~", note, "name the file with $(find pkg)/… or $(dirname)/…")
    if re.match(r"/|[A-Za-z]:[\\/]", value):
        return None if _is_in_container(value, view) else _absolute(value, tag)
    if value.startswith("$("):
        return _above(value, view)
    return _relative(value, view)


def _absolute(value: str, tag: str) -> _Fault | None:
    if re.match(_SYSTEM, value) or (tag != "include" and re.match(_PERSONAL, value) is None and "/src/" not in value):
        return None
    packaged = re.search(_PACKAGE, value)
    instead = f"$(find {packaged[1]})/{packaged[2]}" if packaged else "$(find pkg)/… or $(dirname)/…"
    return _Fault(f"{value} is an absolute path", "it is there on this machine only", f"write {instead}")


def _above(value: str, view: FileView) -> _Fault | None:
    """``..`` that leads out of the package the name begins in."""
    match = re.match(r"\$\(\s*(?:find\s+([\w-]+)|(dirname))\s*\)([^$]*)", value)
    if match is None or ".." not in match[3]:
        return None
    depth = 0
    if match[2]:
        file = posixpath.abspath(view.document.source.file)
        package = view.packages.package_of(file)
        if package is None:
            return None
        inside = posixpath.relpath(posixpath.dirname(file), package.directory)
        depth = 0 if inside == "." else inside.count("/") + 1
    for part in match[3].split("/"):
        depth += -1 if part == ".." else part not in ("", ".")
        if depth < 0:
            message = f"{value} leads out of its package"
            if _is_sibling(match, value, view):
                note = "it works as long as the packages lie side by side, in folders of their names"
                return _Fault(message, note, _beside(match, view), Severity.INFO)
            note = "packages lie side by side in a source workspace only, not once installed"
            foreign = match[1] is not None and not view.packages.has(match[1])
            return _Fault(message, note, _beside(match, view), Severity.INFO if foreign else None)
    return None


def _is_sibling(match: re.Match[str], value: str, view: FileView) -> bool:
    """Whether the name leads exactly one up, into a folder that bears the name of a package that is here, or that an arg decides on."""
    step = re.match(r"/\.\./+([^/]+)/(?!.*\.\.(?:/|\Z))", value[match.start(3) :]) if match[1] else None
    return step is not None and ("$(arg " in step[1] or view.packages.has(step[1]))


def _beside(match: re.Match[str], view: FileView) -> str:
    """How to name what a path with ``..`` leads to, where a package that is here holds it."""
    file = posixpath.abspath(view.document.source.file)
    start = posixpath.dirname(file) if match[2] else view.packages.find(match[1], file)
    if start is not None:
        target = posixpath.normpath(f"{start}/{match[3]}")
        package = view.packages.package_of(target)
        if package is None or not package.name or view.packages.find(package.name, file) != package.directory:
            return _ANY_PACKAGE
        inside = posixpath.relpath(target, package.directory)
        return f"write $(find {package.name})" + ("" if inside == "." else f"/{inside}")
    other = re.sub(r"^(?:\.\./)*", "", match[3].strip("/")).split("/", 1)
    return f"write $(find {other[0]})/{other[1]}" if len(other) == 2 and view.packages.has(other[0]) else _ANY_PACKAGE


def _relative(value: str, view: FileView) -> _Fault | None:
    if not exists(value.partition("$(")[0] or value):
        return None  # not found from here: LL401 and LL502 tell of that
    note = "a relative name counts from the directory roslaunch is started in, not from this file"
    return _Fault(f"{value} is a relative path", note, f"write {_instead(value, view)}")


def _instead(value: str, view: FileView) -> str:
    """The portable name of the file that the relative name means here."""
    if exists(posixpath.join(posixpath.dirname(posixpath.abspath(view.document.source.file)), value)):
        return f"$(dirname)/{value.removeprefix('./')}"
    package = view.packages.package_of(value)
    if package is None or not package.name or "$(" in value:
        return "$(find pkg)/… or $(dirname)/…"
    return f"$(find {package.name})/{posixpath.relpath(posixpath.abspath(value), package.directory)}"
