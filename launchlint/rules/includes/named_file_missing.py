"""A file that a node or a command is told to read is not there.

What it does: it looks for the files that the `args` of nodes and the `command` of params name, where they lie in a package of the
workspace. It is an error where roslaunch itself fails because of it: `command` runs a program that is not there, or lets xacro or cat read
the file. Files that are there to be written (behind `-o` or `>`, of a recorder) are passed over; logs, bags and the like, too, unless a
file of nearly that name is there. It is an info where a file is made: by a command of `CMakeLists.txt`, from a template that lies beside
it, by another node or another launch file of the package, or by what `.gitignore` keeps out of the repository; where its directory is there
and holds nothing but a README or the like: what belongs there is put there on each machine; where it lies in a git submodule that is not
checked out; where `CMakeLists.txt` installs a file to just this place; where the package has no file of that kind at all; where the arg
that is to be the name of the file is empty; where args make the name and it takes another value than a default; and where only the default
of an arg leads there that all launch files here override which include this one. Files that lie in one other directory, and those of one
kind that one directory lacks, are told of together. Silent it is where the name is made from an environment variable, also by way of args.
What LL401 or LL502 tells is not told again.

In ROS 2 it looks at the `args` of nodes, and is silent about what the build installs, or may install, to that place.

## Why it matters

roslaunch hands the name on. The node fails after the others are up, or goes on with something else: rviz shows an empty view, a map
server ends, and whatever waits for the map waits for ever.

## Example

```xml
<launch>
  <node pkg="rviz" type="rviz" name="rviz" args="-d $(find my_robot)/rviz/robots.rviz"/>
</launch>
```

```yaml rviz/robot.rviz
Panels: []
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>rviz</exec_depend>
</package>
```

## Use instead

```xml
<launch>
  <node pkg="rviz" type="rviz" name="rviz" args="-d $(find my_robot)/rviz/robot.rviz"/>
</launch>
```

```yaml rviz/robot.rviz
Panels: []
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>rviz</exec_depend>
</package>
```
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.model import Command, UnknownText
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.elsewhere import elsewhere
from launchlint.rules.judging.installed import installed_at, says_installed
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.made_file import cause_of, made
from launchlint.rules.judging.moved import lacking, moved, told_as_moved
from launchlint.rules.judging.other_file import is_inside, root_of, shown
from launchlint.rules.judging.python_text import reads_environment
from launchlint.rules.of_environment import hangs_on_environment
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.source import Origin
from launchlint.spelling import one_slip
from launchlint.syntax.ros1.substitutions import opens
from launchlint.workspace.looking import exists, names, walk
from launchlint.workspace.nearby import nearby_file

RULE = Rule("LL411", "named-file-missing", Severity.WARNING)

_WRITES = late(r"out|sav|log|record|writ|dump|export|result|report|store|dest|calib|generat|-[oOw]\Z", re.IGNORECASE)
_WRITTEN = frozenset(
    ".bag .log .csv .tsv .txt .db .db3 .pcd .ply .mp4 .avi .png .jpg .jpeg .out .pid .npy .npz .pkl .dot .pdf .bt .ot".split()
)
"""What programs write, as often as they read it."""
_FAIL_WITHOUT = frozenset(("xacro", "xacro.py", "cat"))
_ENDING = late(r"\.[A-Za-z]\w{0,7}")
_MOST_DIRECTORIES = 300
_LONGEST = 10_000


class _Use(NamedTuple):
    """What is handed to ``program`` as ``text``; ``command``: roslaunch runs that itself."""

    origin: Origin
    program: str
    text: str
    command: bool


class _Named(NamedTuple):
    """A file that is named: by which word of the line, whether as it is; ``doubtful``: it may be there to be written."""

    path: str
    position: int
    plain: bool
    doubtful: bool


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each file of a workspace's package that is named and not there."""
    root = root_of(view.launch.entry)
    for use in _uses(view):
        for named in _files(use):
            if is_inside(named.path, view.packages.workspaces) and not exists(named.path):
                yield from _tell(use, named, view, root)


def _uses(view: LaunchView) -> Iterator[_Use]:
    if of_ros2(view):
        yield from _uses_of_ros2(view)
        return
    for node in (*view.launch.nodes, *view.launch.tests):
        if node.knows("arguments") and "/" in node.arguments:
            yield _Use(Origin(node.places.get("arguments", node.origin.place), node.origin.step), node.executable, node.arguments, False)
    for setting in view.launch.parameter_settings:
        if isinstance(setting.value, Command) and "/" in setting.value.line:
            yield _Use(setting.origin, setting.value.line.split()[0], setting.value.line, True)


def _uses_of_ros2(view: LaunchView) -> Iterator[_Use]:
    """The same in ROS 2, where a command that launch runs makes a value that is not known."""
    from shlex import join

    for node in view.launch.nodes:
        words = node.process.arguments if node.process is not None and node.knows("arguments") else ()
        if any("/" in word for word in words) and not any(isinstance(word, UnknownText) for word in words):
            yield _Use(Origin(node.places.get("arguments", node.origin.place), node.origin.step), node.executable, join(words), False)


def _files(use: _Use) -> Iterator[_Named]:
    """The absolute names of files in what is handed over."""
    words = _words(use.text)
    saver = _WRITES.search(posixpath.basename(use.program)) is not None
    for position, word in enumerate(words):
        match = re.search(r"(?:^|[=:,;])(/[^=:,;]+)\Z", word)
        before = words[position - 1] if position else ""
        ending = posixpath.splitext(word)[1]
        if match is None or not _ENDING.fullmatch(ending) or re.search(r"[*?\[\]{}$<>|&]", word):
            continue
        option = word[: match.start(1)] or (before if before.startswith(("-", ">")) else "")
        if saver or option.startswith(">") or _WRITES.search(option) is not None:
            continue
        yield _Named(posixpath.normpath(match[1]), position, match.start(1) == 0, ending.lower() in _WRITTEN)


def _words(text: str) -> list[str]:
    import shlex

    try:
        return shlex.split(text[:_LONGEST])
    except ValueError:
        return text[:_LONGEST].split()


def _tell(use: _Use, named: _Named, view: LaunchView, root: str) -> Iterator[Finding]:
    path, near = named.path, nearby_file(named.path)
    directory, name = posixpath.split(path)
    package = view.packages.package_of(path)
    if of_ros2(view) and _is_installed(path, view):
        return
    written = use.origin.place.text
    if package is None or (named.doubtful and one_slip(name, names(directory)) is None) or _hangs_on_environment(use.origin, view):
        return
    ending = posixpath.splitext(path)[1]
    placed = None if of_ros2(view) else installed_at(path, view.packages)
    maker = made(path, view, root) if placed is None else None
    reads = named.plain and posixpath.basename(use.program) in _FAIL_WITHOUT
    fails = use.command and (named.position == 0 or reads)
    severity, notes = (Severity.ERROR, ["roslaunch runs the command, and stops where it fails"]) if fails else (None, [])
    if placed is not None:
        severity, notes = Severity.INFO, [*notes, says_installed(placed, view.packages, root)[0]]
    elif maker is not None:
        severity, notes = Severity.INFO, [*notes, maker.why]
    elif view.launch.given and (opens(written) or of_ros2(view)):
        severity, notes = Severity.INFO, [*notes, "the name is made from args, and these values are only one choice"]
    elif name.startswith(".") and f"){name}" in written:
        severity, notes = (
            Severity.INFO,
            [*notes, "the arg that is to be the name of the file is empty: whoever starts this gives it a value"],
        )
    elif near is None and not _has_any(package.directory, ending):
        severity, notes = Severity.INFO, [*notes, f"no {ending} file at all is in {package.name}: it may be made, or come from elsewhere"]
    near = near or elsewhere(path, package, view)
    advice = f"did you mean {near}?" if near is not None else "correct the path, or add the file"
    yield RULE.at(
        use.origin,
        f"the file {shown(path, root)} does not exist",
        severity=severity,
        label=f"named here for {posixpath.basename(use.program)}",
        notes=tuple(notes),
        help=says_installed(placed, view.packages, root)[1] if placed is not None else advice if maker is None else maker.help,
        topic=shown(path, root),
        shared_cause=("" if severity is Severity.INFO else lacking(path) if near is None else moved(path, near)) or cause_of(path, maker),
        about=(shown(path, root),),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """What is missing for one reason, by the names of the files."""
    return told_as_moved(joined(findings), findings, RULE.id, "files")


def _hangs_on_environment(origin: Origin, view: LaunchView) -> bool:
    if of_ros2(view):
        return "env" in origin.place.text or reads_environment(origin.place)
    return hangs_on_environment(origin.place.text, origin, view)


def _is_installed(path: str, view: LaunchView) -> bool:
    """Whether the build puts, or may put, a file to where ``path`` would be."""
    from launchlint.workspace.ament.shares import installed_source, may_be_installed

    return installed_source(view.packages, path) is not None or bool(may_be_installed(view.packages, path))


def _has_any(directory: str, ending: str) -> bool:
    return any(name.endswith(ending) for _, listed in walk(directory, _MOST_DIRECTORIES) for name in listed)
