"""What the attributes of roslaunch's XML take as values: small named objects, each with exactly roslaunch's check.

The functions are the checks themselves; the evaluator uses them on resolved values, the validator on literal ones, the
RelaxNG schema and did-you-mean use ``choices``.
"""

from __future__ import annotations

from collections.abc import Callable

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

PARAM_TYPES = ("auto", "str", "string", "int", "double", "bool", "boolean", "yaml")


class Domain(NamedTuple):
    """A set of values. ``expected`` says in words what is in it, ``choices`` lists them where they can be listed (in canonical spelling).

    ``parse`` gives the Python value of a text or raises ValueError with a message in plain words.
    """

    name: str
    expected: str
    parse: Callable[[str], Any]
    choices: tuple[str, ...] = ()

    def problem(self, value: str) -> str | None:
        """What is wrong with the literal ``value``; ``None`` if nothing is."""
        try:
            self.parse(value)
        except ValueError as error:
            return str(error)
        return None


def parse_condition(value: str) -> bool:
    """The truth of an ``if`` or ``unless`` (``roslaunch.loader.convert_value`` with type bool).

    true, false, 1 or 0 in any case, blanks around it ignored. Raises ValueError.
    """
    folded = value.lower().strip()
    if folded in ("true", "1"):
        return True
    if folded in ("false", "0"):
        return False
    raise ValueError("must be true, false, 1 or 0" + _instead_of(value))


def parse_flag(value: str) -> bool:
    """The truth of ``required``, ``respawn``, ``pass_all_args``, ``subst_value`` (``roslaunch.xmlloader._bool_attr``).

    true or false in any case; no 1 or 0, no blanks. Raises ValueError.
    """
    folded = value.lower()
    if folded == "true":
        return True
    if folded == "false":
        return False
    raise ValueError("must be true or false" + _instead_of(value))


def parse_optional_flag(value: str) -> bool:
    """The truth of ``clear_params`` (``XmlLoader._ns_clear_params_attr``): as :func:`parse_flag`, but nothing means false."""
    return parse_flag(value) if value else False


def parse_number(value: str) -> float:
    """``respawn_delay`` in seconds (``roslaunch.xmlloader._float_attr``): whatever Python's float() takes, negative numbers too."""
    try:
        return float(value)
    except ValueError:
        raise ValueError("must be a number" + _instead_of(value)) from None


def parse_timeout(value: str) -> float:
    """``timeout`` of a machine in seconds (``XmlLoader._machine_tag``): a number above 0."""
    number = parse_number(value)
    if number <= 0.0:
        raise ValueError("must be greater than 0" + _instead_of(value))
    return number


def parse_time_limit(value: str) -> float | None:
    """``time-limit`` of a test in seconds (``XmlLoader._test_attrs``): a number above 0; nothing means the default."""
    return parse_timeout(value) if value else None


def parse_integer(value: str) -> int | None:
    """``retry`` of a test and ``ssh-port`` of a machine: whatever Python's int() takes; nothing means the default."""
    if not value:
        return None
    try:
        return int(value)
    except ValueError:
        raise ValueError("must be a whole number" + _instead_of(value)) from None


def parse_output(value: str) -> str:
    """``output`` of a node (``roslaunch.core.Node``): log or screen, in small letters."""
    return _one_of(value, ("log", "screen"))


def parse_cwd(value: str) -> str:
    """``cwd`` of a node (``roslaunch.core.Node``): node or ROS_HOME; ros_home is taken for ROS_HOME."""
    if value == "ros_home":
        return "ROS_HOME"
    return _one_of(value, ("ROS_HOME", "node"))


def parse_command(value: str) -> str:
    """``command`` of a rosparam (``roslaunch.loader.Loader.load_rosparam``): load, dump or delete; nothing means load."""
    return _one_of(value, ("load", "dump", "delete")) if value else "load"


def parse_machine_default(value: str) -> str:
    """``default`` of a machine (``XmlLoader._machine_tag``): true, false or never, any case; nothing means false."""
    return _one_of(value.lower(), ("true", "false", "never")) if value else "false"


def parse_param_type(value: str) -> str:
    """``type`` of a param (``XmlLoader._param_tag``): any case, blanks around it ignored, nothing means auto.

    ``$(…)`` is not resolved in it.
    """
    return _one_of((value or "auto").lower().strip(), PARAM_TYPES)


def parse_filled(value: str) -> str:
    """``pkg`` and ``type`` of a node (``roslaunch.core.Node``): anything but blanks."""
    if not value.strip():
        raise ValueError("must not be empty")
    return value


def parse_nonempty(value: str) -> str:
    """``name`` of an env (``roslaunch.loader.Loader.load_env``): anything but nothing."""
    if not value:
        raise ValueError("must not be empty")
    return value


def parse_text(value: str) -> str:
    """Any text."""
    return value


def _instead_of(value: str) -> str:
    return f", not {value!r}" if value else ", not empty"


def _one_of(value: str, choices: tuple[str, ...]) -> str:
    if value in choices:
        return value
    raise ValueError("must be " + ", ".join(choices[:-1]) + " or " + choices[-1] + _instead_of(value))


TEXT = Domain("text", "any text", parse_text)
FILLED = Domain("filled", "a name", parse_filled)
NONEMPTY = Domain("nonempty", "a name", parse_nonempty)
CONDITION = Domain("condition", "true, false, 1 or 0", parse_condition, ("true", "false", "1", "0"))
FLAG = Domain("flag", "true or false", parse_flag, ("true", "false"))
OPTIONAL_FLAG = Domain("optional-flag", "true or false", parse_optional_flag, ("true", "false"))
NUMBER = Domain("number", "a number of seconds", parse_number)
TIMEOUT = Domain("timeout", "a number of seconds greater than 0", parse_timeout)
TIME_LIMIT = Domain("time-limit", "a number of seconds greater than 0", parse_time_limit)
INTEGER = Domain("integer", "a whole number", parse_integer)
OUTPUT = Domain("output", "log or screen", parse_output, ("log", "screen"))
CWD = Domain("cwd", "ROS_HOME or node", parse_cwd, ("ROS_HOME", "node"))
COMMAND = Domain("command", "load, dump or delete", parse_command, ("load", "dump", "delete"))
MACHINE_DEFAULT = Domain("machine-default", "true, false or never", parse_machine_default, ("true", "false", "never"))
PARAM_TYPE = Domain("param-type", "auto, str, int, double, bool or yaml", parse_param_type, PARAM_TYPES)
