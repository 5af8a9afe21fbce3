"""Text to typed value, as roslaunch does it for ``<param type=…>``."""

from __future__ import annotations

from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.ros1.values import automatic, integer, shown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

#: The parameter types roslaunch knows, as people write them (any case).
PARAMETER_TYPES = ("auto", "str", "string", "int", "double", "bool", "boolean", "yaml")

_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}


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
        return automatic(text)
    if wanted in ("str", "string"):
        return text
    if wanted == "int":
        try:
            return integer(text)
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


def _yaml(text: str, angles: bool) -> Any:
    from launchlint.evaluate.ros1.rosparam import YamlError, load

    try:
        value = load(text, unroll=False, angles=angles).data
    except YamlError as error:
        raise ValueError(f"{shown(text)} is not the YAML that type='yaml' needs: {error.message}") from None
    if isinstance(value, UnknownValue):
        raise value
    return value
