"""A file is named in a way that works on one machine or from one directory only.

What it does: it looks at the files that `<include>`, `<rosparam>`, `textfile` and `binfile` name, as they are written. It speaks about
absolute paths of includes, about paths below a home directory or a source workspace, about `~`, which roslaunch does not expand, about `..`
that leads out of the package (an info where it leads just into the package beside it, since packages lie side by side once installed, too,
and where it begins in a package that is not here: how that lies, its own people know), and about relative names, which count from the
directory roslaunch is started in. Absolute names of system configuration (`/etc`, `/dev`, `/tmp` and the like) are passed over, and so is
all that begins with a substitution other than `$(find …)` and `$(dirname)`.

Directories that the containers of the workspace have (Dockerfiles, compose files, `docker run` in scripts) are passed over, and homes
of users that a `<machine>` of the file logs in as.

In the values of args and params, and in what nodes get as `args` or `env`, it speaks about paths below the home directory of one person
and about `..` that leads out of a package; that is an info where no package holds what is named, and so is `~`, which nodes expand or
do not. What stands in many places is told once, and so are all relative names. A name that leads nowhere besides (LL401, LL502) is told
once, too: by that rule where it is the worse.

In ROS 2 it speaks about absolute paths of includes, paths below a home directory and `~`: relative names are told by LL401 and LL502.
It is an info where a launch file in Python reads variables of the environment, with which it may take another path.

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
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Fix, Severity
from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.rules.edits import Spot, fix, set_value
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.made_file import cause_of
from launchlint.rules.judging.python_text import reads_environment
from launchlint.rules.judging.template import is_path_to_fill_in
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, of_ros2
from launchlint.rules.wording import Words, words_at
from launchlint.source import Place
from launchlint.syntax.parts import Literal, Parts, Substitution
from launchlint.syntax.ros1.substitutions import parse, parts_of
from launchlint.workspace.looking import exists
from launchlint.workspace.ros2_distributions import READ_AS

RULE = Rule("LL406", "non-portable-path", Severity.WARNING, fixable="safe")

_ATTRIBUTES = {"include": ("file",), "rosparam": ("file",), "param": ("textfile", "binfile")}
_TEXTS = {"arg": ("value", "default"), "param": ("value",), "node": ("args",), "test": ("args",), "env": ("value",)}
_ALIKE = "; the others alike"
_CHOSEN = "this launch file reads variables of the environment, with which it may take another one"
_HOME = r"(?<![\w.$/\\-])(?:/home/|/Users/)[\w.-]+/"
_TILDE = r"(?<![\w.$/\\-])~/(?:\.[\w-]|(?:[\w. -]+/)*[\w-]+\.[A-Za-z]\w{0,5}\b)[^\s\"';,:]*"
"""``~/.ros/x`` or ``~/maps/hall.yaml``; ``~/scan`` may well be a topic."""
_WORD = late(r"[^$\s\"';,:]*")
_ANY_NAME = "$(find pkg)/… or $(dirname)/…"
_SYSTEM = r"/(?:etc|dev|tmp|var|run|mnt|media|sys|proc|opt/(?!ros/))"
_PERSONAL = r"/home/[^/$]+/|/Users/[^/$]+/|/root/|/(?:[^/]*_ws|src)/|/opt/ros/|[A-Za-z]:[\\/]"
_ABOVE_PACKAGES = r"/(?:src|share)/(.*)"
_PACKAGE = r"(?s)(?:.*/)?(\w+)/((?:launch|config|params|param|cfg|urdf|maps|map)/.*)"


class _Fault(NamedTuple):
    message: str
    note: str
    help: str
    severity: Severity | None = None
    cause: str = ""
    instead: str = ""


def check(view: FileView) -> Iterator[Finding]:
    """Yield one finding for each file name that depends on the machine or the current directory."""
    if of_ros2(view):
        yield from _ros2(view)
        return
    document = view.document
    for element in document.elements:
        for name in _ATTRIBUTES.get(element.tag, ()):
            attribute = element.attributes.get(name)
            if attribute is None or not attribute.value or element.get("command") in ("dump", "delete"):
                continue
            fault = _fault(parts_of(attribute), element.tag, view)
            if fault is not None:
                yield _finding(fault, Spot(document, element, attribute), _fix(fault, Spot(document, element, attribute)))
        for name in _TEXTS.get(element.tag, ()):
            attribute = element.attributes.get(name)
            if attribute is not None and ("/" in attribute.value or "\\" in attribute.value):
                parts = parts_of(attribute)
                fault = _home(parts.beside("$"), view, None) or _out_of_package(parts, view)
                if fault is not None:
                    yield _finding(fault, Spot(document, element, attribute), None)


def _ros2(view: FileView) -> Iterator[Finding]:
    """Paths of one machine; how launch resolves relative ones LL401 and LL502 say, and they are there or not."""
    from launchlint.rules.judging.ros2_written import beside, command_lines, file_names, values

    for kind, _, text in (*file_names(view), *values(view), *command_lines(view)):
        plain, words = beside(text), words_at(text.place)
        share = f"{words.under('find-pkg-share', 'pkg', '…')} or {words.under('dirname', '', '…')}"
        fault = _home(plain, view, words)
        if fault is not None and text.place.source.file.endswith(".py") and fault.cause not in text.place.source.text:
            continue  # a program has read it from a file, where it may be a comment
        if fault is None and kind == "include" and plain.startswith("/") and not _is_in_container(plain, view):
            made = text.place.source.file.endswith(".py") and f"/{plain.split('/')[1]}/" not in text.place.source.text
            fault = None if made else _absolute(plain, kind)  # what begins with the HOME of who checks is written nowhere
            fault = None if fault is None else fault._replace(help=f"write {share}", instead="")
        if fault is not None:
            missing = (
                cause_of(plain, None) if kind == "include" and plain.startswith("/") and "$" not in plain and not exists(plain) else ""
            )
            chosen = reads_environment(text.place)
            yield RULE.at(
                text.place, fault.message, severity=Severity.INFO if chosen else fault.severity, label="not portable",
                notes=(fault.note, *((_CHOSEN,) if chosen else ())), help=fault.help, cause=fault.cause, shared_cause=missing,
            )  # fmt: skip


def _finding(fault: _Fault, at: Spot, fix: Fix | None) -> Finding:
    span = at.element.start_span if at.attribute is None else at.attribute.shown_span
    return RULE.at(
        Place(at.document.source, span), fault.message, severity=fault.severity, label="not portable", notes=(fault.note,),
        help=fault.help, fix=fix, cause=fault.cause, shared_cause=_missing(at),
    )  # fmt: skip


def together(findings: Sequence[Finding]) -> Finding:
    """The paths of one machine, each with a name of its own to write; that a file is not here either is no more than a note."""
    told = joined(findings)
    missing = (each for each in findings if each.rule != RULE.id and each.location == told.location and each.severity > Severity.INFO)
    told = told._replace(notes=tuple(dict.fromkeys((*told.notes, *(note for each in missing for note in each.notes[:1])))))
    several = len({each.help for each in findings if each.rule == RULE.id}) > 1
    return told._replace(help=f"{told.help.removesuffix(_ALIKE)}{_ALIKE}") if several else told


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for all paths of one person's home directory, also where some of the files are told to be missing."""
    homes: dict[object, list[Finding]] = {}
    for finding in findings:
        found = re.match(_HOME, finding.message)
        homes.setdefault((finding.severity, found[0]) if found else id(finding), []).append(finding)
    for several in homes.values():
        yield together(several) if len(several) > 1 else several[0]


def _missing(at: Spot) -> str:
    """What LL401 tells, too: that the file which an include names so is not there."""
    name = "" if at.attribute is None or at.element.tag != "include" or at.attribute.name != "file" else at.attribute.value
    return cause_of(name, None) if name.startswith("/") and "$" not in name and not exists(name) else ""


def _home(plain: str, view: FileView, words: Words | None) -> _Fault | None:
    """A path below somebody's home directory in any text; ``words`` are those of ROS 2."""
    pkg = "$(find pkg)/…" if words is None else words.under("find-pkg-share", "pkg", "…")
    home = "$(env HOME)/…" if words is None else words.under("env", "HOME", "…")
    launcher = view.dialect.launcher
    found = re.search(_HOME, plain)
    if found is not None and is_path_to_fill_in(found[0]):
        help = "fill it in, or make it an arg without a default"
        note = "it is a placeholder, which each user fills in"
        return _Fault(f"{found[0]}… is nobody's home directory", note, help, severity=Severity.INFO, cause=found[0])
    if found is not None and (_is_in_container(found[0], view) or _logs_in(found[0], view)):
        return None
    if found is not None:
        help = f"name files with {pkg}, others with {home} or an arg that each machine sets"
        return _Fault(f"{found[0]}… is somebody's home directory", "it is there on machines of that user only", help, cause=found[0])
    found = re.search(_TILDE, plain)
    if found is None:
        return None
    note = f"{launcher} does not expand ~: it works only where the node does"
    return _Fault(f"{found[0]} begins with ~", note, f"write {home}, which works for every node", Severity.INFO, "~")


def _is_in_container(path: str, view: FileView) -> bool:
    """Whether it lies in a home directory, or another one, that a container of this workspace has: it is the same on each machine then."""
    found = re.match(r"/home/([\w.-]+)/", path)
    if found is not None:
        return found[1] in view.packages.container_users()
    first = re.match(r"/[\w.-]+(?=/)", path)
    return first is not None and first[0] in view.packages.container_directories()


def _logs_in(path: str, view: FileView) -> bool:
    """Whether it lies in the home directory of the user that a ``<machine>`` of the file logs in as: it is a path of that machine."""
    found = re.match(r"/(?:home|Users)/([\w.-]+)/", path)
    machines = (each for each in view.document.elements if each.tag == "machine")
    return found is not None and any(each.get("user") == found[1] for each in machines)


def _out_of_package(parts: Parts, view: FileView) -> _Fault | None:
    for part in parts.substitutions():
        behind = _WORD.match(parts.text, part.end)
        path = None if behind is None else _path(part, behind[0])
        fault = None if path is None else _above(path, view)
        if path is not None and fault is not None:
            known = bool(fault.instead)
            start = "/".join(path.text.split("/")[:3])
            return fault._replace(severity=None if known else Severity.INFO, cause=f"{start} {fault.help if known else ''}")
    return None


def _fix(fault: _Fault, at: Spot) -> Fix | None:
    """The portable name, where the advice is one and no pattern; whether it leads to the same file is proved before it is written."""
    written = "" if at.attribute is None else at.attribute.value
    if not fault.instead or (written.startswith("/") and not exists(written)):
        return None
    return fix(fault.help, set_value(at, fault.instead), safe=True)


def _fault(parts: Parts, tag: str, view: FileView) -> _Fault | None:
    value = parts.text
    if value.startswith("~"):
        note = "roslaunch does not expand ~, and looks for a directory of that name"
        return _Fault(f"{value} begins with ~", note, "name the file with $(find pkg)/… or $(dirname)/…")
    if re.match(r"/|[A-Za-z]:[\\/]", value):
        return None if _is_in_container(value, view) else _absolute(value, tag)
    first = parts.parts[0]
    if isinstance(first, Literal):
        return _relative(parts, first.text, view)
    path = _path(first, value[first.end :]) if isinstance(first, Substitution) else None
    return None if path is None else _above(path, view)


def _absolute(value: str, tag: str) -> _Fault | None:
    if re.match(_SYSTEM, value) or (tag != "include" and re.match(_PERSONAL, value) is None and "/src/" not in value):
        return None
    above = re.search(_ABOVE_PACKAGES, value)
    packaged = None if above is None else re.fullmatch(_PACKAGE, above[1])
    instead = f"$(find {packaged[1]})/{packaged[2]}" if packaged else ""
    home = re.search(_HOME, value)
    start = "/".join(value.split("/")[:3]) if home is None else home[0]
    ros = re.match(r"/opt/ros/(\w+)/", value)
    note = "it is there on this machine only" if ros is None else f"it is there where {ros[1]} is installed only"
    help = f"write {instead or _ANY_NAME}"
    if ros is not None and ros[1] in READ_AS:  # nothing else in the file says that it is for ROS 2
        help, instead = f"write {(instead or _ANY_NAME).replace('$(find ', '$(find-pkg-share ')}", ""
    return _Fault(f"{value} is an absolute path", note, help, cause=start, instead=instead)


class _Path(NamedTuple):
    """A path as written: it begins in ``package`` (empty: in the directory of the file). ``behind`` is all that follows, ``inside`` what
    of that stands before the next substitution.
    """

    package: str
    inside: str
    behind: str
    text: str


def _path(start: Substitution, behind: str) -> _Path | None:
    """The path that begins with ``start``; None where that stands for no directory."""
    package = start.only if start.command == "find" else ""
    if not package and start.command != "dirname":
        return None
    return _Path(package, behind.partition("$")[0], behind, start.text + behind)


def _above(path: _Path, view: FileView) -> _Fault | None:
    """``..`` that leads out of the package the name begins in."""
    if ".." not in path.inside:
        return None
    depth = 0
    if not path.package:
        file = posixpath.abspath(view.document.source.file)
        package = view.packages.package_of(file)
        if package is None:
            return None
        inside = posixpath.relpath(posixpath.dirname(file), package.directory)
        depth = 0 if inside == "." else inside.count("/") + 1
    for part in path.inside.split("/"):
        depth += -1 if part == ".." else part not in ("", ".")
        if depth < 0:
            instead, severity = _beside(path, view), None
            note = "packages lie side by side in a source workspace only, not once installed"
            if _is_sibling(path, view):
                note, severity = "it works as long as the packages lie side by side, in folders of their names", Severity.INFO
            elif path.package and not view.packages.has(path.package):
                severity = Severity.INFO
            help = f"write {instead}" if instead else "keep it in a package, and write $(find pkg)/…"
            return _Fault(f"{path.text} leads out of its package", note, help, severity, instead=instead)
    return None


def _is_sibling(path: _Path, view: FileView) -> bool:
    """Whether the name leads exactly one up, into a folder that bears the name of a package that is here, or that an arg decides on."""
    step = re.match(r"/\.\./+([^/]+)/(?!.*\.\.(?:/|\Z))", path.behind) if path.package else None
    return step is not None and (any(parse(step[1]).substitutions("arg")) or view.packages.has(step[1]))


def _beside(path: _Path, view: FileView) -> str:
    """The name of what a path with ``..`` leads to, where a package that is here holds it; else empty."""
    file = posixpath.abspath(view.document.source.file)
    start = view.packages.find(path.package, file) if path.package else posixpath.dirname(file)
    if start is not None:
        target = posixpath.normpath(f"{start}/{path.inside}")
        package = view.packages.package_of(target)
        if package is None or not package.name or view.packages.find(package.name, file) != package.directory:
            return ""
        inside = posixpath.relpath(target, package.directory)
        return f"$(find {package.name})" + ("" if inside == "." else f"/{inside}")
    other = re.sub(r"^(?:\.\./)*", "", path.inside.strip("/")).split("/", 1)
    return f"$(find {other[0]})/{other[1]}" if len(other) == 2 and view.packages.has(other[0]) else ""


def _relative(parts: Parts, start: str, view: FileView) -> _Fault | None:
    value = parts.text
    if not exists(start):
        return None  # not found from here: LL401 and LL502 tell of that
    note = "a relative name counts from the directory roslaunch is started in, not from this file"
    instead = _instead(parts, view)
    return _Fault(f"{value} is a relative path", note, f"write {instead or _ANY_NAME}", cause="relative", instead=instead)


def _instead(parts: Parts, view: FileView) -> str:
    """The portable name of the file that the relative name means here; empty where there is none."""
    value = parts.text
    if exists(posixpath.join(posixpath.dirname(posixpath.abspath(view.document.source.file)), value)):
        return f"$(dirname)/{value.removeprefix('./')}"
    package = view.packages.package_of(value)
    if package is None or not package.name or parts.computed:
        return ""
    return f"$(find {package.name})/{posixpath.relpath(posixpath.abspath(value), package.directory)}"
