"""Texts that may be numbers or booleans, and values that cannot be known."""

from __future__ import annotations

#: Python refuses longer decimal numbers (sys.int_info.default_max_str_digits of the Python roslaunch runs on).
MOST_INTEGER_DIGITS = 4300


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


def automatic(text: str) -> bool | int | float | str:
    """What roslaunch makes of a text without a type, of args in ``$(eval …)`` too (roslaunch.loader.convert_value, ``auto``)."""
    try:
        if "." in text:
            return float(text)
        if "_" not in text:  # 1_000 is a number to Python, but roslaunch keeps it as text
            return integer(text)
    except ValueError:
        pass
    return {"true": True, "false": False}.get(text.lower(), text)


def integer(text: str) -> int:
    """``int(text)`` with the limit on length that only newer Python versions have: roslaunch's Python does have it."""
    if len(text) > MOST_INTEGER_DIGITS and sum(map(str.isdigit, text)) > MOST_INTEGER_DIGITS:
        raise ValueError(f"more than {MOST_INTEGER_DIGITS} digits")
    return int(text)


def shown(text: str) -> str:
    """``text`` in quotes, for a message: without control characters, and not too long."""
    return repr(text if len(text) <= 60 else text[:57] + "...")
