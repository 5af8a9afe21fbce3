"""An included file does not exist or is no launch file.

What it does: it looks for the `file` of every `<include>` whose name can be worked out. A plain relative name is looked up where
roslaunch is started, not beside the including file. It is an error, except where the answer hangs on this machine: for absolute
names outside the workspace, and for relative names that do exist beside the including file.

## Why it matters

roslaunch reads every include before it starts the first node, and stops at one that it cannot read.

## Example

```xml
<launch>
  <include file="$(dirname)/sensor.launch"/>
</launch>
```

```xml sensors.launch
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/sensors.launch"/>
</launch>
```

```xml sensors.launch
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
</launch>
```
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.other_file import is_inside, root_of, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Source
from launchlint.spelling import closest

RULE = Rule("LL401", "include-not-found", Severity.ERROR, roslaunch="refuses")

_LAUNCH_ENDS = (".launch", ".xml", ".test")
_MOST_DIRECTORIES = 300
_MOST_FILES = 5_000


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``include-not-found`` and ``include-not-loadable`` (roslaunch.xmlloader._include_tag)."""
    file = problem.facts["file"]
    source = problem.place.source
    root = root_of(source)
    if problem.kind == "include-not-loadable":
        yield RULE.at(
            problem.origin, f"the included file {shown(file, root)} cannot be loaded: {problem.facts['reason']}", label="included here",
            notes=("roslaunch stops with: Invalid roslaunch XML syntax",), help="mend that file, or include another one",
        )  # fmt: skip
        return
    reason = problem.facts["reason"]
    relative = not os.path.isabs(file)
    beside = relative and os.path.isfile(os.path.join(os.path.dirname(os.path.abspath(source.file)), file))
    elsewhere = problem.facts["written"].startswith("/") and not is_inside(file, (*view.packages.workspaces, root or "/nowhere"))
    notes = [f"roslaunch stops with: Invalid roslaunch XML syntax: [Errno 2] No such file or directory: '{file}'"]
    if reason != "there is no such file":
        notes = [f"{shown(file, root)}: {reason}"]
    if relative and file:
        notes.append("a relative name counts from the directory roslaunch is started in, not from this file")
    named = shown(file, root) if file and not relative else file
    yield RULE.at(
        problem.origin,
        f"the included file {named} does not exist" if file else "the name of the included file is empty",
        severity=Severity.WARNING if (beside or elsewhere) else None,
        label="found only beside this file" if beside else "not found",
        notes=tuple(notes),
        help=f'write file="$(dirname)/{file}"' if beside else _suggestion(file, source, problem.facts["written"], view, root),
    )


def _suggestion(file: str, source: Source, written: str, view: LaunchView, root: str) -> str:
    """A launch file of that or a similar name: in the same directory, else in the same package, else beside the including file."""
    absolute = os.path.abspath(file) if os.path.isabs(file) else os.path.join(os.path.dirname(os.path.abspath(source.file)), file)
    directory, base = os.path.split(absolute)
    near = closest(base, _launch_files(directory))
    if near is not None and written.endswith(base):
        return f"did you mean {written[: -len(base)]}{near}?"
    package = view.packages.package_of(directory)
    if package is None or not is_inside(directory, (os.path.dirname(package.directory),)):
        return "correct the name, or create the file"
    found = _below(package.directory)
    same = sorted(each for each in found if os.path.basename(each) == base)
    if not same:
        nearest = closest(base, sorted({os.path.basename(each) for each in found}))
        same = sorted(each for each in found if os.path.basename(each) == nearest)
    if not same:
        return "correct the name, or create the file"
    if package.name and view.packages.find(package.name, source.file) == package.directory:
        return f"did you mean $(find {package.name})/{os.path.relpath(same[0], package.directory).replace(os.sep, '/')}?"
    return f"did you mean {shown(same[0], root)}?"


def _launch_files(directory: str) -> list[str]:
    try:
        names = sorted(os.listdir(directory))
    except OSError:
        return []
    return [name for name in names[:_MOST_FILES] if name.endswith(_LAUNCH_ENDS)]


def _below(directory: str) -> list[str]:
    """The launch files of a package, as far as they are found in the first directories."""
    found: list[str] = []
    for visited, (parent, directories, names) in enumerate(os.walk(directory)):
        if visited >= _MOST_DIRECTORIES or len(found) >= _MOST_FILES:
            break
        directories[:] = sorted(name for name in directories if not name.startswith("."))
        found += [os.path.join(parent, name) for name in names if name.endswith(_LAUNCH_ENDS) and name != "package.xml"]
    return found
