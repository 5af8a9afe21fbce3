"""An included file does not exist or is no launch file.

What it does: it looks for the `file` of every `<include>` whose name can be worked out. A plain relative name is looked up where roslaunch
is started, not beside the including file. It is a warning where the answer hangs on this machine: for absolute names outside the workspace,
for relative names that do exist beside the including file, and for files that `CMakeLists.txt` may install. It is an info where only the
default of an arg leads there that all files which include this one override, or a default such as `none` that stands for no choice, for a
file that `CMakeLists.txt` installs to just this place (it is there from the install space only), for files of the robot (below `/etc`,
`/opt`, `/home` and the like, outside of the workspace), for those of a distribution of ROS (`/opt/ros/…`) that is not installed here, for
names made from an environment variable, whose value here says little, and for a file that is made: by a command of `CMakeLists.txt`, from a
template that lies beside it, by a node that gets its name (or the name of the launch file that it is made from) in another configuration,
or by what `.gitignore` keeps out of the repository; for one in a git submodule that is not checked out; for one that roslaunch is to find
in a package which is for ROS 2 here; in a package with a `manifest.xml`, which rosbuild builds, about a file of one that catkin builds
here; and in a launch file that is called a template. So it is where only a switch leads there that MoveIt's Setup Assistant writes into
every package, and that nothing here gives. A directory that is missing is told once, with all files that would be in it, and so is one in
which files are looked for that lie in another, and one that lacks several files which one launch file names. A name with a placeholder
(`__robot__`, `@ROBOT@`) is left alone, and so is an arg with `false` or `none` for a name.

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

## Fix

`--fix` writes `$(dirname)/` before a plain name that exists beside the including file: roslaunch finds it then wherever it is started.
`--unsafe-fixes` writes the name that the help proposes: a similar one beside it or in its package, or the file of that very name in another
package, where there is only one. Where the name is made from an arg it writes the right default of that. A file that is included
there anyhow is never proposed, nor one in a directory such as `old` or
`graveyard`, nor a test in place of a launch file, nor one that does not declare the args that are passed.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import IncludeNotFound, IncludeNotLoadable
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import fix, set_value, spot
from launchlint.rules.judging.default_to_correct import SENTINELS, correction, has_arg, unchosen
from launchlint.rules.judging.elsewhere import file_in_another_package
from launchlint.rules.judging.installed import installed_at, installed_from, says_installed
from launchlint.rules.judging.joined import joined, led_by
from launchlint.rules.judging.left_over import left_over_in
from launchlint.rules.judging.made_file import cause_of, made, malformed
from launchlint.rules.judging.moved import lacking, moved, told_as_moved
from launchlint.rules.judging.other_file import is_inside, root_of, shown
from launchlint.rules.judging.robot_file import ABSENT_ROS, INSTALL, is_of_absent_ros, is_robots
from launchlint.rules.judging.robot_file import advice as robots_advice
from launchlint.rules.judging.takes_args import is_alike, passed_at, takes
from launchlint.rules.judging.template import has_placeholder, is_called_template, is_template
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.rules.xml.malformed_xml import TEMPLATE
from launchlint.spelling import closest, same_digits, same_letters
from launchlint.syntax.ros1.substitutions import parse
from launchlint.workspace.looking import is_file, names, walk
from launchlint.workspace.put_aside import is_out_of_use

RULE = Rule("LL401", "include-not-found", Severity.ERROR, roslaunch="refuses", fixable="safe")

_LAUNCH_ENDS = (".launch", ".xml", ".test")
_MOST_DIRECTORIES = 300
_MOST_FILES = 5_000
_MOST_NAMED = 3
_CORRECT = "correct the name, or create the file"


def tell(problem: IncludeNotFound | IncludeNotLoadable, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``include-not-found`` and ``include-not-loadable`` (roslaunch.xmlloader._include_tag)."""
    if of_ros2(view):
        from launchlint.rules.judging import ros2_args as ros2_words

        yield from ros2_words.not_found(problem, RULE, view)
        return
    file = problem.file
    source = problem.place.source
    root = root_of(source)
    environment = problem.environment
    if has_placeholder(file):
        return
    if isinstance(problem, IncludeNotLoadable):
        if has_placeholder(source.text):
            return
        yield RULE.at(
            problem.origin, f"the included file {shown(file, root)} cannot be loaded: {problem.reason}",
            severity=Severity.INFO if environment else None, label="included here",
            notes=("roslaunch stops with: Invalid roslaunch XML syntax",), help="mend that file, or include another one",
            shared_cause="" if environment or not problem.malformed else malformed(file), about=(shown(file, root),),
        )  # fmt: skip
        return
    if file in SENTINELS and has_arg(problem.written):
        return
    reason = problem.reason
    relative = not posixpath.isabs(file)
    beside = relative and is_file(posixpath.join(posixpath.dirname(posixpath.abspath(source.file)), file))
    written = problem.written
    outside = written.startswith("/") and not is_inside(file, (*view.packages.workspaces, root or "/nowhere"))
    named = shown(file, root) if file and not relative else file
    notes = [f"roslaunch stops with: Invalid roslaunch XML syntax: [Errno 2] No such file or directory: '{named}'"]
    if reason != "there is no such file":
        notes = [f"{named}: {reason}"]
    if relative and file:
        notes.append("a relative name counts from the directory roslaunch is started in, not from this file")
    if environment:
        notes.append("the name hangs on an environment variable, which may be another one on the robot")
    placed = installed_at(file, view.packages) if file and not relative and not environment else None
    installed = placed or (installed_from(file, view.packages) if not relative and not environment else None)
    maker = made(file, view, root) if not relative and not environment and installed is None else None
    if maker is not None:
        notes.append(maker.why)
    if installed is not None and placed is None:
        notes.append("it is there only where CMakeLists.txt installs it to this place, and the package is installed")
    severity = Severity.WARNING if beside or outside or installed is not None else None
    meant = f"$(dirname)/{file}"
    advice = f'write file="{meant}"'
    if not beside:
        advice, meant = _suggestion(file, problem, written, view, root)
    repair = None if environment else _fix(problem, view, written, meant, sure=beside)
    if not beside and has_arg(written) and meant and not _keeps_args(written, meant):
        advice, repair = _correct_arg(problem, written, meant, view)
    if maker is not None:
        severity, advice = Severity.INFO, maker.help
    elif outside and installed is None and is_robots(file, view.packages, root):
        severity, advice = Severity.INFO, robots_advice(file)
    elif outside and is_of_absent_ros(file):
        severity, advice = Severity.INFO, INSTALL
        notes.append(ABSENT_ROS)
    choice = unchosen(problem, written, view) if maker is None and installed is None and not relative and not environment else None
    if choice is not None:
        severity, advice, repair = Severity.INFO, choice[1], None
        notes.append(choice[0])
    if severity is None and problem.origin.step is None and is_template(source.path):
        severity = Severity.INFO
        what = "is called a template" if is_called_template(source.path) else "lies among templates"
        notes.append(f"this file {what}: people copy it, and start the copy")
    home = None if relative or not file else view.packages.package_of(file)
    if home is not None and home.manifest is not None and home.manifest.is_ament and not home.manifest.is_catkin:
        severity, repair = Severity.INFO, None
        notes.append(
            f"{shown(home.directory, root)} is a package for ROS 2: where roslaunch starts this file, another {home.name} is found"
        )
    if placed is not None:
        severity, repair = Severity.INFO, None
        note, advice = says_installed(placed, view.packages, root or "")
        notes.append(note)
    if environment:
        severity = Severity.INFO
        advice = "give the variable the value it has on the robot, under env: in .launchlint.yaml, or correct the path"
    yield RULE.at(
        problem.origin,
        f"the included file {named} does not exist" if file else "the name of the included file is empty",
        severity=severity,
        label="found only beside this file" if beside else "not here" if maker is not None else "not found",
        notes=tuple(notes),
        help=advice,
        fix=repair,
        shared_cause=(_BESIDE if beside else left_over_in(file, view))
        or (moved(file, meant) if severity is None and repair is not None else "")
        or (lacking(file) if severity is None and advice.startswith(_CORRECT) and not relative and installed is None else "")
        or ("" if relative or environment or installed is not None else cause_of(file, maker)),
        about=(named,) if file else (),
    )


_BESIDE = "a relative name, found only beside the file"


def together(findings: Sequence[Finding]) -> Finding:
    """One for all: the mistake in the file, or in its name, is told before the includes that it breaks."""
    broken = next((each for each in findings if each.rule == "LL101"), None)
    if broken is not None and broken.topic == TEMPLATE:  # one that is filled in later is no mistake of who includes it
        return led_by(findings, "LL101")._replace(severity=broken.severity)
    if broken is not None:
        return led_by(findings, "LL101")
    told = led_by(findings, "LL215")
    if told.help == _CORRECT:  # the place that shows what was meant speaks for those that do not
        same = (each for each in findings if each.rule == RULE.id and each.message == findings[0].message)
        near = next((each for each in same if each.help.startswith("did you mean")), None)
        told = told if near is None else joined(findings, near)
    told = told_as_moved(told, findings, RULE.id, "included files")
    portable = next((each for each in findings if each.rule == "LL406"), None)  # the same name, as it is written
    return told if portable is None or told.help != _CORRECT else told._replace(help=portable.help)


def _keeps_args(written: str, meant: str) -> bool:
    """Whether ``meant`` holds all args of ``written``: then other callers get what they ask for."""
    parts = parse(written)
    return parts.expression is None and all(part.text in meant for part in parts.substitutions("arg"))


def _correct_arg(problem: IncludeNotFound, written: str, meant: str, view: LaunchView) -> tuple[str, Fix | None]:
    """Help and fix where the name is made from args: the value is mended at its place, never what other callers fill in otherwise."""
    right = correction(problem, written, meant, view)
    if right is None:
        return f"{_CORRECT}; there is {meant}", None
    if right.default is None:
        return f"give the arg {right.arg} the value {right.value}: {meant} is there", None
    edits = set_value(right.default, right.value)
    changes = f"{meant} is included where {right.arg} is not given"
    return (
        f"give the arg {right.arg} the default {right.value}: {meant} is there",
        fix(f'write default="{right.value}" for {right.arg}', edits, safe=False, changes=changes),
    )


def _fix(problem: IncludeNotFound, view: LaunchView, written: str, name: str, *, sure: bool) -> Fix | None:
    if not name or problem.place.text != written or (sure and "$" in written):
        return None
    changes = "roslaunch finds it wherever it is started" if sure else f"{name} is included"
    return fix(f'write file="{name}"', set_value(spot(view, problem.place), name), safe=sure, changes=changes)


def _suggestion(file: str, problem: IncludeNotFound, written: str, view: LaunchView, root: str) -> tuple[str, str]:
    """A launch file of that or a similar name: in the same directory, else in the same package; else one of that name elsewhere.

    What to do, and the name that is proposed, where it is one that can be written into any file.

    Not one that the same file includes anyhow, nor one that was put aside, nor one that refuses the args that are passed.
    """
    source = problem.place.source
    passed = passed_at(problem, view)
    absolute = posixpath.abspath(file) if posixpath.isabs(file) else posixpath.join(posixpath.dirname(posixpath.abspath(source.file)), file)
    directory, base = posixpath.split(absolute)
    taken = {posixpath.abspath(source.file), *view.included_by.get(source, ())}
    beside = [name for name in _launch_files(directory) if posixpath.join(directory, name) not in taken and is_alike(base, name)]
    near = _close(base, beside) or _longer(base, beside) or same_letters(base, beside)
    if near is not None and not takes(posixpath.join(directory, near), passed):
        near = None
    package = view.packages.package_of(directory)
    below = [] if package is None else _below(package.directory)
    found = [each for each in below if each not in taken and not is_out_of_use(each, absolute) and is_alike(base, each)]
    alike = [each for each in found if posixpath.basename(each) == base]
    same = [each for each in alike if takes(each, passed)]
    if near is not None and not same and written.endswith(base):
        name = f"{written[: -len(base)]}{near}"
        return f"did you mean {name}?", name if name.startswith("$(") else ""
    if not alike:
        nearest = _close(base, sorted({posixpath.basename(each) for each in found}))
        same = [each for each in found if posixpath.basename(each) == nearest and takes(each, passed)]
    if not same:
        others = view.packages.launch_files(base)
        same = [each for each in others if each not in taken and not is_out_of_use(each, absolute) and takes(each, passed)]
        if not others and package is not None and (other := file_in_another_package(absolute, package, view.packages)) is not None:
            same = [other] if other not in taken and not is_out_of_use(other, absolute) and takes(other, passed) else []
        package = view.packages.package_of(same[0]) if len(same) == 1 else None
    if len(same) > 1:
        listed = ", ".join(shown(each, root) for each in same[:_MOST_NAMED]) + (" …" if len(same) > _MOST_NAMED else "")
        return _CORRECT if posixpath.basename(same[0]) != base else f"{_CORRECT}; there are {listed}", ""
    if not same:
        return _CORRECT, ""
    if package is not None and package.name and view.packages.find(package.name, source.file) == package.directory:
        name = f"$(find {package.name})/{posixpath.relpath(same[0], package.directory)}"
        return f"did you mean {name}?", name
    return f"did you mean {shown(same[0], root)}?", ""


def _close(base: str, names: list[str]) -> str | None:
    """The most similar of ``names``, endings left aside; files that differ in a digit stand for different things."""
    stems: dict[str, str] = {}
    for name in names:
        if same_digits(name, base) and name != base:
            stems.setdefault(_stem(name), name)
    wanted = _stem(base)
    return stems.get(wanted) or stems.get(closest(wanted, stems) or "")


def _longer(base: str, names: list[str]) -> str | None:
    """The only one of ``names`` that begins with the wanted one, and ends as it does."""
    stem, end = posixpath.splitext(base)
    found = [name for name in names if name.startswith((f"{stem}_", f"{stem}-")) and name.endswith(end) and same_digits(name, base)]
    return found[0] if len(found) == 1 else None


def _stem(name: str) -> str:
    return name.partition(".")[0]


def _launch_files(directory: str) -> list[str]:
    return [name for name in names(directory)[:_MOST_FILES] if name.endswith(_LAUNCH_ENDS)]


def _below(directory: str) -> list[str]:
    """The launch files of a package, as far as they are found in the first directories."""
    found: list[str] = []
    for parent, listed in walk(directory, _MOST_DIRECTORIES):
        if len(found) >= _MOST_FILES:
            break
        found += [posixpath.join(parent, name) for name in listed if name.endswith(_LAUNCH_ENDS) and name != "package.xml"]
    return found
