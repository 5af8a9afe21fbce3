"""A file that a parameter is read from is not there.

That is the `file` of a `<rosparam>`, and the `textfile` or `binfile` of a `<param>`; in ROS 2 the `from` of a `<param>`, and the `filename`
of `<set_parameters_from_file>`. The path is checked as it is after substitution, and the file has to be readable UTF-8 text (but for
`binfile`).

## Why it matters

roslaunch refuses the launch file, and with it every launch file that includes it. `ros2 launch` only warns where a node has the file, and
starts it without its params: a warning here, too. It is also a warning where the file may well be there on the robot: a path outside of all
packages, a relative one, and one that `CMakeLists.txt` may install. It is an info where a system keeps its own files (`/etc`, `/opt`,
`/var`, `/usr/local`, `/media`, `/mnt`, `/dev`, `/home`) or development containers have theirs (`/workspaces`), outside of the workspace; in
`/tmp`, where programs write while they run; in a distribution of ROS (`/opt/ros/…`) that is not installed here; where an arg gives a
relative path; where, in ROS 2, a relative path leads to a file of the workspace from there, unless one package is all of it, or from a
directory around it (`src/robot/config/arm.yaml`); where the path is made from an environment variable, whose value here says little; and
where the file is made: by a command of `CMakeLists.txt`, from a template that lies beside it, by a node that writes it, also one of another
launch file of the package, or by what `.gitignore` keeps out of the repository; where it lies in a git submodule that is not checked out,
or in a directory with nothing but a README; where `CMakeLists.txt` installs a file to just this place, so that it is there from the install
space only; where only the default of an arg leads there that all files which include this one override; where that default is `none` or the
like and files for other values are there; and in a package with a `manifest.xml`, which rosbuild builds, about a file of one that catkin
builds here. A directory that is missing is told once, with all files that would be in it, and so is one in which files are looked for that
lie elsewhere, and one that lacks several files which one launch file names.

## Example

```xml
<launch>
  <rosparam file="$(dirname)/config/wheels.yaml"/>
</launch>
```

```yaml config/wheel.yaml
radius: 0.1
```

## Use instead

```xml
<launch>
  <rosparam file="$(dirname)/config/wheel.yaml"/>
</launch>
```

```yaml config/wheel.yaml
radius: 0.1
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import ParamFileMissing
from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.model import ROS1, ROS2
from launchlint.rules.judging.default_to_correct import SENTINELS, has_arg, unchosen
from launchlint.rules.judging.elsewhere import elsewhere, in_another_package
from launchlint.rules.judging.installed import installed_at, installed_from, says_installed
from launchlint.rules.judging.joined import led_by
from launchlint.rules.judging.left_over import left_over_in
from launchlint.rules.judging.made_file import cause_of, made
from launchlint.rules.judging.moved import lacking, moved, told_as_moved
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.judging.out_of_share import leads_out, where
from launchlint.rules.judging.python_text import reads_environment
from launchlint.rules.judging.robot_file import ABSENT_ROS, INSTALL, advice, is_of_absent_ros, is_robots, is_temporary
from launchlint.rules.judging.template import asks_for, is_path_to_fill_in, is_template
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at
from launchlint.workspace.looking import is_file

RULE = Rule("LL502", "param-file-missing", Severity.ERROR, roslaunch="refuses")
_DEEPEST = 12
_MARKUP = late(r"\A\s{0,100}<[?!\w]|>\s{0,100}\Z")
"""How a description of a robot begins or ends, which is written where the name of a file is asked for."""


def tell(problem: ParamFileMissing, view: LaunchView) -> Iterator[Finding]:
    """Say why it cannot be read and which file is near."""
    path, missing = problem.shown, problem.missing
    if path in SENTINELS:
        return
    launcher = view.dialect.launcher
    text = missing and problem.place.source.path.endswith(".py") and _MARKUP.search(path) is not None
    notes = [f"{launcher} stops, since it finds no file {path}" if missing else f"{launcher} refuses the launch file"]
    if not problem.refused:
        notes = [f"{launcher} warns, and starts the node without these params"]
    if problem.relative and not text:
        notes.append(f"a relative path is looked up where {launcher} is started, not beside this file")
    elif problem.environment:
        notes.append("the path is made from an environment variable, which may be another one on the robot")
    elif problem.elsewhere:
        notes.append("it is in no package that is here, so that it may be there on the robot")
    name = path if posixpath.dirname(path) == "/" else posixpath.basename(path) or path
    slashed = path.startswith("/") and "." not in name and problem.place.source.path.endswith(".py")
    if missing and view.dialect.name == ROS2 and (slashed or text):
        notes.append("a text among the parameters of a node is the name of a file; params stand in a dictionary")
    severity = None
    installed = (
        installed_from(problem.file, view.packages) if missing and not problem.relative and not _is_built(problem.file, view) else None
    )
    if installed is not None and view.dialect.name == ROS2:
        return  # what is launched in ROS 2 is what is installed, and nothing is here that says what that is
    placed = installed_at(problem.file, view.packages) if missing and view.dialect.name == ROS1 and not problem.relative else None
    installed = installed or placed
    look = missing and not problem.relative and not problem.environment and installed is None
    maker = made(problem.file, view, root_of(problem.place.source)) if look else None
    perhaps = _may_be_installed(problem.file, view) if look and maker is None else ""
    if perhaps:
        severity = Severity.WARNING
        notes.append(f"the build may install it to this place: {perhaps}")
    if not problem.refused:
        severity = Severity.WARNING
    if (path and problem.environment) or not (path or problem.refused):
        severity = Severity.INFO  # an empty name is how people say that there is no file
    elif placed is not None:
        severity = Severity.INFO
        notes.append(says_installed(placed, view.packages, root_of(problem.place.source))[0])
    elif installed is not None:
        severity = Severity.WARNING
        notes.append("it is there only where CMakeLists.txt installs it to this place, and the package is installed")
    elif maker is not None:
        severity = Severity.INFO
        notes.append(maker.why)
    elif path and (problem.relative or "None" in name) and view.dialect.name == ROS2 and reads_environment(problem.place):
        severity = Severity.INFO
        notes.append("this launch file makes paths of environment variables, which may be set elsewhere")
    elif path and problem.relative and "(" not in path and has_arg(problem.place.text):
        severity = Severity.INFO
        notes.append("an arg says which file, so that this one may stand for any")
    elif path and problem.relative and (there := _below_workspace(path, view)):
        severity = Severity.INFO
        notes.append(f"it is there as {there}, for who starts it from {'there' if there == path else 'a directory around that'}")
    elif path and (problem.relative or problem.elsewhere) and not left_over_in(problem.file, view):
        severity = Severity.WARNING
    left = leads_out(problem.file, problem.place, view.packages) if missing and view.dialect.name == ROS2 else ""
    if left:
        severity = Severity.INFO
        notes.append(where(left))
    robots = missing and maker is None and look and is_robots(problem.file, view.packages, root_of(problem.place.source))
    temporary = missing and look and is_temporary(problem.file, view.packages, root_of(problem.place.source))
    if robots or temporary:
        severity = Severity.INFO
    absent = missing and is_of_absent_ros(problem.file)
    if absent:
        severity = Severity.INFO
        notes.append(ABSENT_ROS)
    if temporary:
        notes.append("what lies in /tmp is written while something runs, and gone after a restart")
    choice = unchosen(problem, problem.place.text, view) if look and maker is None else None
    if choice is not None:
        severity = Severity.INFO
        notes.append(choice[0])
    placeholder = missing and (is_path_to_fill_in(path) or _is_asked_for(problem, view))
    if placeholder:
        severity = Severity.INFO
        notes.append("the path is a placeholder, which each user fills in")
    if missing and problem.origin.step is None and is_template(problem.place.source.path):
        severity = Severity.INFO
        notes.append("this file is called a template: people copy it, and start the copy")
    near = _near(problem, view) if installed is None else shown(installed, root_of(problem.place.source))
    if not path:
        message = "the name of the file is empty"
    else:
        message = (
            "a text in XML is given as the name of a file of params"
            if text
            else f"the file {name} does not exist"
            if missing
            else f"the file {name} cannot be read: {problem.reason}"
        )
    yield RULE.at(
        problem.origin,
        message,
        severity=severity,
        label="no name of a file" if text else f"no file {name}" if missing and problem.no_directory else "no such file" if missing else "",
        related=problem.related,
        notes=tuple(notes),
        help="give it as a param: {'robot_description': …}"
        if text
        else "fill in the path, or make it an arg without a default"
        if placeholder
        else "install the file with a package, and start the path with its share directory"
        if left
        else maker.help
        if maker is not None
        else advice(path)
        if robots or temporary
        else INSTALL
        if absent
        else choice[1]
        if choice is not None
        else says_installed(placed, view.packages, root_of(problem.place.source))[1]
        if placed is not None and not problem.environment
        else _advice(problem, near, view),
        shared_cause=left_over_in(problem.file, view)
        or (f"relative in {problem.place.source.path}" if path and problem.relative and severity is Severity.WARNING else "")
        or (moved(problem.file, near) if severity is None and near is not None and missing else "")
        or (lacking(problem.file) if look and severity is None and near is None else "")
        or (cause_of(problem.file, maker) if look and path and not placeholder else ""),
        about=(name,) if path and not text else (),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """One for all: text that was meant to be replaced is told before the names of files that have it."""
    return told_as_moved(led_by(findings, "LL215"), findings, RULE.id, "files")


def _is_built(file: str, view: LaunchView) -> bool:
    """Whether it is known what of the package of ``file`` is installed where: in ROS 2 that is all there is to find."""
    if view.dialect.name == ROS1:
        return False
    from launchlint.workspace.ament.shares import is_built

    return is_built(view.packages, file)


def _may_be_installed(file: str, view: LaunchView) -> str:
    if view.dialect.name == ROS1:  # where packages are not looked for in what is installed, but in the sources
        return ""
    from launchlint.workspace.ament.shares import may_be_installed

    return may_be_installed(view.packages, file)


def _below_workspace(path: str, view: LaunchView) -> str:
    """The file that a relative path with directories means in ROS 2, where it counts from a workspace or around it; empty if none."""
    parts = posixpath.normpath(path).split("/")
    if view.dialect.name == ROS1 or parts[0] == ".." or not 1 < len(parts) <= _DEEPEST:
        return ""
    ends = ["/".join(parts[at:]) for at in range(len(parts) - 1)]
    return next((end for end in ends for place in view.packages.workspaces if _is_there(place, end, view)), "")


def _is_there(place: str, end: str, view: LaunchView) -> bool:
    """Whether a workspace has the file, as more than a package that is the whole of it: that is started from anywhere."""
    file = posixpath.join(place, end)
    package = view.packages.package_of(file) if is_file(file) else None
    return is_file(file) and (package is None or package.directory != place or end.count("/") > 1)


def _is_asked_for(problem: ParamFileMissing, view: LaunchView) -> bool:
    """Whether a comment in the line asks people to put a name in the place of what stands there, which is no name of a file."""
    name, source = posixpath.basename(problem.place.text.rstrip("/")), problem.place.source
    document = view.documents.get(source.path)
    if document is None or "." in name or "$" in name:
        return False
    line = source.position(problem.place.span.start).line
    beside = (each.text for each in document.comments if source.position(each.span.start).line == line)
    return any(asks_for(each, name) for each in beside)


def _near(problem: ParamFileMissing, view: LaunchView) -> str | None:
    """The file that was probably meant: around the place, else anywhere in its package."""
    if problem.near is not None or problem.relative or not problem.missing:
        return problem.near
    package = view.packages.package_of(problem.file)
    return None if package is None else elsewhere(posixpath.normpath(problem.file), package, view)


def _find(view: LaunchView) -> str:
    return "find" if view.dialect.name == ROS1 else "find-pkg-share"


def _advice(problem: ParamFileMissing, near: str | None, view: LaunchView) -> str:
    if problem.environment:
        return "give the variable the value it has on the robot, under env: in .launchlint.yaml, or correct the path"
    if near is not None:
        return f"did you mean {near}?"
    if problem.relative:
        words = words_at(problem.origin)
        return f"start the path with {words.call(_find(view), 'PACKAGE')} or {words.call('dirname')}"
    if not problem.missing:
        return "give the path of a text file in UTF-8"
    package = view.packages.package_of(problem.file)
    other = "" if package is None else in_another_package(problem.file, package, view.packages)
    if package is not None and other:
        return f"did you mean {words_at(problem.origin).under(_find(view), other, posixpath.relpath(problem.file, package.directory))}?"
    if problem.no_directory:
        return f"correct the path: there is no directory {problem.no_directory} either"
    return "correct the path, or add the file"
