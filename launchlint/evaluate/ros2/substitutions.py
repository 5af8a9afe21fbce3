"""What each substitution of ROS 2 launch is replaced by (launch.substitutions, launch_ros.substitutions).

How many words each takes is a matter of how the file is written (:mod:`launchlint.syntax.ros2`); where it is wrong, that has been told.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable

from launchlint.evaluate.problems import EnvUnset, PackageNotFound, UndeclaredArg
from launchlint.evaluate.ros2.comparing import note_equals, note_expression
from launchlint.evaluate.ros2.context import Setting, Value
from launchlint.evaluate.ros2.elsewhere import set_elsewhere
from launchlint.evaluate.ros2.names import absolute, prefixed
from launchlint.evaluate.ros2.parameters import GlobalParameter
from launchlint.evaluate.ros2.performing import SHARE, Failure, Perform, Performer
from launchlint.evaluate.ros2.problems import (
    CommandOption,
    DirectoryOfAnother,
    InvalidPackageName,
    NoDirectory,
    NotABoolean,
    ParameterNotSet,
)
from launchlint.evaluate.session import WRITTEN
from launchlint.late import late
from launchlint.model import StandIn, Unknown
from launchlint.syntax.ros2.description import AS_BOOL, CALLED, FULL_NAME, HAS_PARAMS, NOT_KNOWN, REPLACED, REWRITTEN, Substitution
from launchlint.syntax.ros2.live import Stopped
from launchlint.syntax.ros2.looping import FOR_VARIABLE, INDEX_OF_LOOP

_FOLD = str.maketrans(".-:", "___")
_PACKAGE = late(r"[a-zA-Z0-9][a-zA-Z0-9_-]+")
_STDERR = ("fail", "ignore", "warn", "capture")
_LONGEST_NUMBER = 400
UNREAD = "an included launch file that is not read may set it"
"""Why something that is set nowhere is not known."""
CHARACTERS_PER_KNOWN = 50
"""What a name that is set costs where another one is not: it is compared with that, to tell what was meant."""


class _Unknown(Exception):
    """A word of the substitution is not known."""

    def __init__(self, value: Unknown) -> None:
        super().__init__(value)
        self.value = value


def _known(performer: Performer, substitution: Substitution, index: int) -> str:
    """The word at ``index`` as a string; _Unknown where it is not known, or not there."""
    if index >= len(substitution.arguments):
        raise _Unknown(Unknown(substitution.place.text, "the substitution lacks a word"))
    value = performer.perform(substitution.arguments[index])
    if isinstance(value, Unknown):
        raise _Unknown(Unknown(substitution.place.text, value.reason))
    return value


def _of_known(function: Callable[[Performer, Substitution], Value]) -> Perform:
    def perform(performer: Performer, substitution: Substitution) -> Value:
        try:
            return function(performer, substitution)
        except _Unknown as unknown:
            return unknown.value

    return perform


def _var(performer: Performer, substitution: Substitution) -> Value:
    """``$(var name default)``: the default is performed only where it is needed."""
    name = _known(performer, substitution, 0)
    setting = performer.context.get(name)
    if setting is not None:
        performer.steer |= setting.steer
        performer.outside |= setting.outside
        way = performer.way
        if way and (setting.way[: len(way)] != way or (setting.how == "passed" and setting.way == way)):
            performer.foreign.append((way, name, performer.where(substitution.place), setting))
        return setting.value
    performer.steer.add(name)  # giving it a value would be enough
    if len(substitution.arguments) > 1:
        return performer.perform(substitution.arguments[1])
    if performer.context.unread:
        return Unknown(substitution.place.text, UNREAD)
    known = performer.context.names()
    performer.spend(CHARACTERS_PER_KNOWN * len(known), substitution.place)
    origin = performer.where(substitution.place)
    raise Failure(
        UndeclaredArg(
            origin=origin,
            refused=True,
            name=name,
            known=known,
            entry=origin.step is None,
            skipped=(),
            in_expression=False,
            elsewhere=set_elsewhere(performer.session, origin.place.source, name),
        )
    )


def _of_loop(performer: Performer, substitution: Substitution) -> Value:
    """``$(for-var NAME default)`` and ``$(index NAME)`` that no loop around them in the file has given a value
    (:mod:`launchlint.syntax.ros2.loops`); one around an include may have.
    """
    name, origin = _known(performer, substitution, 0), performer.where(substitution.place)
    if any(step is not origin.step for step in performer.context.turning):
        return Unknown(substitution.place.text, f"a loop around the include may give {name} a value")
    if substitution.name == FOR_VARIABLE and len(substitution.arguments) > 1:
        return performer.perform(substitution.arguments[1])
    from launchlint.syntax.ros2.python.problems import StopsWithError

    what = f"there is no value for {name}"
    raise Failure(
        StopsWithError(origin=origin, refused=True, error="RuntimeError", what=what, stated=False, called=True, action=substitution.name)
    )


def _env(performer: Performer, substitution: Substitution) -> Value:
    """``$(env NAME default)``: the default is performed first, needed or not."""
    default = performer.perform(substitution.arguments[1]) if len(substitution.arguments) > 1 else None
    name = _known(performer, substitution, 0)
    performer.outside = True
    value = performer.context.environment.get(name)
    if value is not None:
        return value
    if default is not None:
        return default
    if performer.context.unread_environment:
        return Unknown(substitution.place.text, UNREAD)
    raise Failure(EnvUnset(origin=performer.where(substitution.place), refused=True, variable=name))


def is_package_name(name: str) -> bool:
    """Whether anything can be a package of that name."""
    return _PACKAGE.fullmatch(name) is not None


def package_directory(performer: Performer, name: str, substitution: Substitution) -> str:
    """The share directory of a package: that of its sources. Raises Failure (ament_index_python.packages.get_package_share_directory)."""
    origin = performer.where(substitution.place)
    if not is_package_name(name):
        raise Failure(InvalidPackageName(origin=origin, refused=True, package=name))
    directory = performer.session.packages.colcon.find(name, performer.entry)
    if directory is None:
        raise Failure(PackageNotFound(origin=origin, refused=True, package=name, near=performer.entry))
    return directory


def prefix(performer: Performer) -> str:
    """Where everything is said to be installed."""
    return f"/opt/ros/{performer.rules.distro}"


def _share(performer: Performer, substitution: Substitution) -> Value:
    return package_directory(performer, _known(performer, substitution, 0), substitution)


def _prefix(performer: Performer, substitution: Substitution) -> Value:
    package_directory(performer, _known(performer, substitution, 0), substitution)
    return prefix(performer)


def _program(performer: Performer, substitution: Substitution) -> Value:
    executable, package = _known(performer, substitution, 0), _known(performer, substitution, 1)
    package_directory(performer, package, substitution)
    return os.path.join(prefix(performer), "lib", package, executable)


def _executable(performer: Performer, substitution: Substitution) -> Value:
    return "/usr/bin/" + _known(performer, substitution, 0)


def _command(performer: Performer, substitution: Substitution) -> Value:
    """Never run: only the command line is known."""
    line = performer.perform(substitution.arguments[0]) if substitution.arguments else ""
    if len(substitution.arguments) > 1:
        option = _known(performer, substitution, 1)
        if option not in _STDERR:
            raise Failure(CommandOption(origin=performer.where(substitution.place), refused=True, value=option, known=_STDERR))
    is_known = isinstance(line, StandIn) or (isinstance(line, str) and WRITTEN not in line)
    made = StandIn if is_known else Unknown
    return made(f"$(command {line if isinstance(line, str) else line.text})", "it is the output of a command, which is not run")


def _directory(performer: Performer, substitution: Substitution) -> Value:
    own = os.path.dirname(os.path.abspath(substitution.place.source.file))
    return _judged(performer, substitution, performer.context.directory, own)


def _file(performer: Performer, substitution: Substitution) -> Value:
    return _judged(performer, substitution, performer.context.file, os.path.abspath(substitution.place.source.file))


def _judged(performer: Performer, substitution: Substitution, means: Value | None, own: str) -> Value:
    """What it means, which is told where that is not what stands for it in its ``own`` file."""
    if means is None:
        raise Failure(NoDirectory(origin=performer.where(substitution.place), refused=True, substitution=substitution.name))
    if isinstance(means, Unknown):
        return means
    if means != own and performer.session.is_launch_file(substitution.place.source.file):
        origin = performer.where(substitution.place)
        performer.notice(DirectoryOfAnother(origin=origin, substitution=substitution.name, means=performer.session.shown(means)))
    return means


def _log_directory(performer: Performer, substitution: Substitution) -> Value:
    home = performer.session.variable("HOME")  # of the start: launch makes the directory before it executes anything
    performer.outside = True
    return (
        f"{home}/.ros/log/launch" if isinstance(home, str) else Unknown(substitution.place.text, "the log directory is made at the start")
    )


def _anonymous(performer: Performer, substitution: Substitution) -> Value:
    """A name that is made once, and kept as a launch configuration: so it is another one again behind the group that it was made in."""
    name = _known(performer, substitution, 0)
    context = performer.context
    setting = context.get("anon" + name)
    if setting is None:
        performer.anonymous += 1
        made = f"{name.translate(_FOLD)}_anon{performer.anonymous}"
        setting = Setting(made, performer.where(substitution.place), "anonymous")
        context.set("anon" + name, setting)
    return setting.value


def _truth(performer: Performer, substitution: Substitution, index: int) -> bool:
    value = _known(performer, substitution, index)
    truth = performer.boolean(value)
    if truth is None:
        place = substitution.place
        raise Failure(
            NotABoolean(origin=performer.where(place), refused=True, substitution=substitution.name, value=value, text=place.text)
        )
    return truth


def _said(truth: bool) -> str:
    return "true" if truth else "false"


def _not(performer: Performer, substitution: Substitution) -> Value:
    return _said(not _truth(performer, substitution, 0))


def _and(performer: Performer, substitution: Substitution) -> Value:
    left, right = _truth(performer, substitution, 0), _truth(performer, substitution, 1)
    return _said(left and right)


def _or(performer: Performer, substitution: Substitution) -> Value:
    left, right = _truth(performer, substitution, 0), _truth(performer, substitution, 1)
    return _said(left or right)


def _equal(performer: Performer, substitution: Substitution) -> bool:
    """Truth values as such, then numbers, else texts (launch.substitutions.EqualsSubstitution)."""
    left, right = _known(performer, substitution, 0), _known(performer, substitution, 1)
    truths = [{"true": True, "1": True, "false": False, "0": False}.get(each.lower()) for each in (left, right)]
    if None not in truths:
        return truths[0] == truths[1]
    numbers = [_number(each) for each in (left, right)]
    if numbers[0] is not None and numbers[1] is not None:
        return math.isclose(numbers[0], numbers[1])
    return left == right


def _number(text: str) -> float | None:
    if len(text) > _LONGEST_NUMBER:
        return None
    try:
        return float(text)
    except ValueError:
        return None


def _equals(performer: Performer, substitution: Substitution) -> Value:
    note_equals(performer, substitution)
    return _said(_equal(performer, substitution))


def _not_equals(performer: Performer, substitution: Substitution) -> Value:
    note_equals(performer, substitution)
    return _said(not _equal(performer, substitution))


def _if(performer: Performer, substitution: Substitution) -> Value:
    """``$(if condition then else)``: only the one that is taken is performed."""
    taken = 1 if _truth(performer, substitution, 0) else 2
    return performer.perform(substitution.arguments[taken]) if taken < len(substitution.arguments) else ""


def _parameter(performer: Performer, substitution: Substitution) -> Value:
    name = _known(performer, substitution, 0)
    for each in performer.context.parameters or ():
        if isinstance(each, GlobalParameter) and each.name == name:
            return each.text
    if len(substitution.arguments) > 1:
        return performer.perform(substitution.arguments[1])
    if performer.context.unread_parameters:
        return Unknown(substitution.place.text, UNREAD)
    raise Failure(ParameterNotSet(origin=performer.where(substitution.place), refused=True, name=name))


def _content(performer: Performer, substitution: Substitution) -> Value:
    outside, performer.outside = performer.outside, False
    file = _known(performer, substitution, 0)
    environment = performer.outside
    performer.outside |= outside
    read = performer.session.read(file)
    if read.data is None:
        from launchlint.evaluate.missing_file import missing_file  # only a file that is not there pays for it

        origin = performer.where(substitution.place)
        raise Failure(missing_file(performer.session, origin, "file-content", file, read.reason, environment=environment, refused=True))
    return re.sub("\r\n?", "\n", read.data.decode("utf-8", "replace"))


def _path(performer: Performer, substitution: Substitution) -> Value:
    """Parts joined as by os.path.join (launch.substitutions.PathJoinSubstitution)."""
    parts = [performer.perform(each) for each in substitution.arguments]
    unknown = next((each for each in parts if isinstance(each, Unknown)), None)
    if unknown is not None:
        return Unknown(substitution.place.text, unknown.reason)
    whole = os.path.join("", *(each for each in parts if isinstance(each, str)))
    performer.spend(len(whole), substitution.place)
    pieces = substitution.arguments[0].pieces if substitution.arguments else ()
    starts_in_package = bool(pieces) and isinstance(pieces[0], Substitution) and pieces[0].name == SHARE
    return performer.session.placed(whole) if starts_in_package else whole


def _eval(performer: Performer, substitution: Substitution) -> Value:
    from launchlint.evaluate.ros2.evaluating import evaluate

    note_expression(performer, substitution)
    return evaluate(performer, substitution, _known(performer, substitution, 0), _modules(performer, substitution))


def _modules(performer: Performer, substitution: Substitution) -> tuple[str, ...]:
    if len(substitution.arguments) < 2:
        return ("math",)
    return tuple(name.strip() for name in _known(performer, substitution, 1).split(",") if name.strip())


def _not_known(performer: Performer, substitution: Substitution) -> Value:
    """What a program has put there, nobody knows."""
    reason = _known(performer, substitution, 0)
    if len(substitution.arguments) > 1:
        return StandIn(_known(performer, substitution, 1), reason)
    return Unknown(substitution.place.text, reason)


def _called(performer: Performer, substitution: Substitution) -> Value:
    """What a substitution of a program's own gives."""
    if performer.live is None or substitution.call is None:
        return Unknown(substitution.place.text, "it is asked before the launch runs")
    try:
        return substitution.call(performer.live(substitution.place))
    except Stopped as stopped:
        raise Failure(stopped.problem.but(origin=performer.where(stopped.problem.place))) from None


def _full_name(performer: Performer, substitution: Substitution) -> Value:
    """The full name of a container: as it was when that was executed, or else as it would be now."""
    performer.context.uses.open = True
    known = dict(performer.containers).get(substitution.place.key)
    if known is not None:
        return known
    namespace, name = _known(performer, substitution, 0), _known(performer, substitution, 1)
    base = performer.context.namespace
    if isinstance(base, Unknown):
        return Unknown(substitution.place.text, base.reason)
    return prefixed(absolute(prefixed(base, namespace)) or "/", name) or name


def _of_library(name: str) -> Perform:
    """A substitution that a library brings, whose room is read only where it is met."""

    def perform(performer: Performer, substitution: Substitution) -> Value:
        from launchlint.evaluate.ros2 import library_substitutions

        made: Perform = getattr(library_substitutions, name)
        return made(performer, substitution)

    return perform


PERFORM: dict[str, Perform] = {
    name: _of_known(perform)
    for name, perform in {
        "var": _var,
        FOR_VARIABLE: _of_loop,
        INDEX_OF_LOOP: _of_loop,
        "env": _env,
        "find-pkg-share": _share,
        "find-pkg-prefix": _prefix,
        "exec-in-pkg": _program,
        "find-exec": _executable,
        "command": _command,
        "dirname": _directory,
        "filename": _file,
        "log_dir": _log_directory,
        "launch_log_dir": _log_directory,
        "anon": _anonymous,
        "not": _not,
        "and": _and,
        "or": _or,
        "equals": _equals,
        "not-equals": _not_equals,
        "if": _if,
        "param": _parameter,
        "file-content": _content,
        "eval": _eval,
        "path-join": _path,
        NOT_KNOWN: _not_known,
        FULL_NAME: _full_name,
        CALLED: _called,
        AS_BOOL: _of_library("as_bool"),
        REWRITTEN: _of_library("rewritten"),
        REPLACED: _of_library("replaced"),
        HAS_PARAMS: _of_library("has_params"),
    }.items()
}
