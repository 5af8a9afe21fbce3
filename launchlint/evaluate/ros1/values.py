"""Text to typed value, as roslaunch does it for ``<param type=…>`` and for the args of ``$(eval …)``."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


#: The parameter types roslaunch knows, as people write them (any case).
PARAMETER_TYPES = ("auto", "str", "string", "int", "double", "bool", "boolean", "yaml")

#: Python refuses longer decimal numbers (sys.int_info.default_max_str_digits of the Python roslaunch runs on).
MOST_INTEGER_DIGITS = 4300

_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}


class UnknownValue(Exception):
    """The value cannot be known without running something, or lies beyond our bounds: never an error of the file.

    ``reason`` says in plain words why.
    """

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


def convert_value(text: str, type_: str, *, angles: bool = False) -> Any:
    """The value roslaunch makes of ``text`` for a parameter of type ``type_`` (roslaunch.loader.convert_value).

    ``type_`` is one of :data:`PARAMETER_TYPES` in any case. ``text`` is taken as it is: roslaunch strips the blanks of ``value=`` but
    not of a text file before it converts. ``angles`` says whether YAML knows ``deg(…)`` and ``rad(…)``: it does as soon as roslaunch has
    loaded one ``<rosparam>``. The result is a bool, int, float or str, and for ``yaml`` whatever the YAML text says.

    Raises ``ValueError``, whose text is plain words for the user, where roslaunch stops; and :class:`UnknownValue` for YAML beyond
    our bounds.
    """
    wanted = type_.lower()
    if wanted == "auto":
        return _automatic(text)
    if wanted in ("str", "string"):
        return text
    if wanted == "int":
        try:
            return _integer(text)
        except ValueError:
            raise ValueError(f"{shown(text)} is not a whole number, which type='int' needs") from None
    if wanted == "double":
        try:
            return float(text)
        except ValueError:
            raise ValueError(f"{shown(text)} is not a number, which type='double' needs") from None
    if wanted in ("bool", "boolean"):
        boolean = _BOOLEANS.get(text.lower().strip())
        if boolean is None:
            raise ValueError(f"{shown(text)} is neither true, false, 1 nor 0, which type='{wanted}' needs")
        return boolean
    if wanted == "yaml":
        return _yaml(text, angles)
    raise ValueError(f"{shown(type_)} is not a parameter type; roslaunch knows {', '.join(PARAMETER_TYPES)}")


def type_name(value: object) -> str:
    """The word for the type of a parameter value in our output: bool int double str list dict null, or Python's own for the rest."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "bool"
    if isinstance(value, float):
        return "double"
    if isinstance(value, (list, tuple)):
        return "list"
    if isinstance(value, bytes):
        return "binary"
    for known in (int, str, dict):
        if isinstance(value, known):
            return known.__name__
    return type(value).__name__


def _automatic(text: str) -> bool | int | float | str:
    try:
        if "." in text:
            return float(text)
        if "_" not in text:  # 1_000 is a number to Python, but roslaunch keeps it as text
            return _integer(text)
    except ValueError:
        pass
    return {"true": True, "false": False}.get(text.lower(), text)


def _integer(text: str) -> int:
    """``int(text)`` with the limit on length that only newer Python versions have: roslaunch's Python does have it."""
    if len(text) > MOST_INTEGER_DIGITS and sum(map(str.isdigit, text)) > MOST_INTEGER_DIGITS:
        raise ValueError(f"more than {MOST_INTEGER_DIGITS} digits")
    return int(text)


def _yaml(text: str, angles: bool) -> Any:
    from launchlint.evaluate.ros1.rosparam import YamlError, load

    try:
        value = load(text, unroll=False, angles=angles).data
    except YamlError as error:
        raise ValueError(f"{shown(text)} is not the YAML that type='yaml' needs: {error.message}") from None
    if isinstance(value, UnknownValue):
        raise value
    return value


def shown(text: str) -> str:
    """``text`` in quotes, for a message: without control characters, and not too long."""
    return repr(text if len(text) <= 60 else text[:57] + "...")
