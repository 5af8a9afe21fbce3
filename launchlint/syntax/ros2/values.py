"""What launch's front ends make of a value where a type is wanted: XML's texts are converted, YAML's values only looked at.

Both keep a text that does not fit, since it may hold a substitution (``can_be_str`` in launch): whether it does is seen later, where
something is made of the value. Source: ``launch.utilities.type_utils``.
"""

from __future__ import annotations

import re

from launchlint.late import late

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeAlias

Scalar: TypeAlias = "bool | int | float | str"
Plain: TypeAlias = "Scalar | list[Scalar]"

SCALARS = (bool, int, float, str)

_PLAIN_TEXT = late(r"[A-Za-z_/$][\w/.(){}$+-]*(?<!:)", re.ASCII)
_YAML_WORDS = frozenset(("y", "n", "yes", "no", "on", "off", "true", "false", "null"))


LONGEST = 50_000
"""Characters of a value that are looked into; a longer one, which nobody writes, is taken for a text."""


class Misfit(Exception):
    """The value does not become what is wanted."""


def as_yaml(text: str) -> Any:
    """What PyYAML makes of ``text`` (``yaml.safe_load``).

    Raises:
        Misfit: PyYAML refuses it.
    """
    if not text or len(text) > LONGEST or (_PLAIN_TEXT.fullmatch(text) is not None and text.lower() not in _YAML_WORDS):
        return text
    from launchlint.yaml.refusals import YamlError
    from launchlint.yaml.tree import Reader, YamlBeyond
    from launchlint.yaml.values import load

    try:
        return load(text, Reader("launch", longest=LONGEST))
    except (YamlError, YamlBeyond) as error:  # launch, too, takes whatever happens here for "not to be converted"
        raise Misfit(error.message) from None


def is_value(value: object) -> bool:
    """Whether ``value`` is one that launch passes on: a scalar, or a list of scalars of one type, with texts among them."""
    if not isinstance(value, list):
        return isinstance(value, SCALARS)
    kind = next((type(each) for each in value if type(each) is not str), str)
    return kind in SCALARS and all(isinstance(each, (kind, str)) for each in value)


def fits(value: object, wanted: str, *, texts: bool) -> bool:
    """Whether a value that has a type already is one of the type ``wanted``, or ``yaml`` for any; ``texts``: or a text."""
    kind, is_list = _TYPES[wanted]
    if kind is None:
        return is_value(value) if texts else _is_uniform(value)
    kinds = (kind, str) if texts else (kind,)
    if not is_list:
        return isinstance(value, kinds)
    return isinstance(value, list) and all(isinstance(each, kinds) for each in value)


def converted(text: str, wanted: str, *, digits_are_flags: bool) -> Plain:
    """``text`` as the type ``wanted``, or the text itself where that cannot be had.

    Raises:
        Misfit: launch refuses it.
    """
    kind, is_list = _TYPES[wanted]
    if is_list:
        value = as_yaml(text)
        if not isinstance(value, list) or not fits(value, wanted, texts=True):
            raise Misfit(text)
        return value
    if kind is str:
        return text
    if kind is int or kind is float:
        try:
            number: Scalar = kind(text)
        except ValueError:
            return text
        return number
    if kind is bool and digits_are_flags and text in ("0", "1"):
        return text == "1"
    try:
        value = as_yaml(text)
    except Misfit:
        return text
    if not is_value(value) or (kind is bool and not isinstance(value, (str, bool))):
        raise Misfit(text)
    plain: Plain = value
    return plain


def list_converted(texts: list[str], wanted: str, *, digits_are_flags: bool) -> list[Scalar]:
    """As :func:`converted`, for a text that a separator has split."""
    kind, is_list = _TYPES[wanted]
    if kind is not None and not is_list:
        raise Misfit(wanted)
    item = wanted.removeprefix("list_of_")
    value = [converted(each, item, digits_are_flags=digits_are_flags) for each in texts]
    if not is_value(value):
        raise Misfit(wanted)
    return value  # type: ignore[return-value]  # is_value has seen that no item is a list


_TYPES: dict[str, tuple[type | None, bool]] = {
    "str": (str, False),
    "bool": (bool, False),
    "int": (int, False),
    "float": (float, False),
    "list_of_str": (str, True),
    "list_of_bool": (bool, True),
    "list_of_int": (int, True),
    "list_of_float": (float, True),
    "yaml": (None, False),
}


def _is_uniform(value: object) -> bool:
    if not isinstance(value, list):
        return isinstance(value, SCALARS)
    kind = next((type(each) for each in value if type(each) is not str), str)
    return kind in SCALARS and all(isinstance(each, kind) for each in value)


def literal_fits(value: Plain, computed: bool, wanted: str | None) -> bool:
    """Whether launch takes a value without a type of its own, or with one, for a parameter.

    ``value`` holds what is not computed; ``computed`` says that there are substitutions beside these in a list. Source:
    ``launch.utilities.type_utils.normalize_typed_substitution``.
    """
    kind, is_list = _TYPES[wanted or "yaml"]
    if not isinstance(value, list):
        return fits(value, wanted or "yaml", texts=False)
    if kind is not None and not is_list:
        return False
    kinds = {type(each) for each in value}
    if not kinds and computed:
        return True
    if kinds <= {str}:
        return kind in (None, str)
    if kinds == {bool} or kinds == {int}:
        return kind is None or kinds == {kind}
    return kinds <= {int, float} and kind in (None, float)
