"""A file is named in a way that works on one machine or from one directory only.

What it does: it looks at the files that `<include>`, `<rosparam>`, `textfile` and `binfile` name, as they are written. It speaks
about absolute paths of includes, about paths below a home directory or a source workspace, about `~`, which roslaunch does not
expand, about `..` that leads out of the package, and about relative names, which count from the directory roslaunch is started
in. Absolute names of system configuration (`/etc`, `/dev`, `/tmp` and the like) are passed over, and so is all that begins with a
substitution other than `$(find …)` and `$(dirname)`.

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
from launchlint.rules.view import FileView
from launchlint.source import Place
from launchlint.workspace.looking import exists

RULE = Rule("LL406", "non-portable-path", Severity.WARNING, fixable="safe")

_ATTRIBUTES = {"include": ("file",), "rosparam": ("file",), "param": ("textfile", "binfile")}
_SYSTEM = r"/(?:etc|dev|tmp|var|run|mnt|media|sys|proc|opt/(?!ros/))"
_PERSONAL = r"/home/[^/$]+/|/Users/[^/$]+/|/root/|/(?:[^/]*_ws|src)/|/opt/ros/|[A-Za-z]:[\\/]"
_PACKAGE = r"/(?:src|share)/(?:.*/)?(\w+)/((?:launch|config|params|param|cfg|urdf|maps|map)/.*)$"


class _Fault(NamedTuple):
    message: str
    note: str
    help: str


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
                place = Place(document.source, attribute.shown_span)
                yield RULE.at(
                    place,
                    fault.message,
                    label="not portable",
                    notes=(fault.note,),
                    help=fault.help,
                    fix=_fix(fault, Spot(document, element, attribute)),
                )


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
        return _absolute(value, tag)
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
            rest = re.sub(r"^(?:\.\./)*", "", match[3].strip("/"))
            other = rest.split("/", 1)
            help = f"write $(find {other[0]})/{other[1]}" if len(other) == 2 and re.fullmatch(r"\w+", other[0]) else "write $(find pkg)/…"
            return _Fault(
                f"{value} leads out of its package", "packages lie side by side in a source workspace only, not once installed", help
            )
    return None


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
