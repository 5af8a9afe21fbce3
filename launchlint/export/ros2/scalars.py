"""Values as YAML has them, written so that PyYAML reads the same again."""

from __future__ import annotations

import math
import re

from launchlint.export.ros2.texts import CannotWrite

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.export.ros2.tree import Plain

_SIMPLE = re.compile(r"[A-Za-z_/$][\w/.(){}$+-]*(?: [\w/.($+][\w/.()$+-]*)*", re.ASCII)
_SIMPLE_IN_LIST = re.compile(r"[A-Za-z_/$][\w/.()$+-]*(?: [\w/.($+][\w/.()$+-]*)*", re.ASCII)
_WORDS = frozenset(("y", "n", "yes", "no", "on", "off", "true", "false", "null"))
_PLAIN = re.compile(r"[\x21-\x7e](?:[\x20-\x7e]*[\x21-\x7e])?")
_QUOTABLE = re.compile("[\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]*")
_SHORT = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t", "\r": "\\r"}
_LONGEST_LOOKED_AT = 2_000


def yaml(value: Plain) -> str:
    """``value`` in one line. Raises CannotWrite."""
    if isinstance(value, list):
        return f"[{', '.join(_scalar(each, in_list=True) for each in value)}]"
    return _scalar(value, in_list=False)


def number(value: float) -> str:
    """A number with a point as YAML 1.1 has it."""
    if math.isnan(value):
        return ".nan"
    if math.isinf(value):
        return ".inf" if value > 0 else "-.inf"
    text = repr(value)
    if "e" in text and "." not in text:
        text = text.replace("e", ".0e")
    return text


def _scalar(value: bool | int | float | str, *, in_list: bool) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return number(value)
    return _text(value, in_list=in_list)


def _text(text: str, *, in_list: bool) -> str:
    simple = _SIMPLE_IN_LIST if in_list else _SIMPLE
    if simple.fullmatch(text) is not None and text.lower() not in _WORDS:
        return text
    if _stays(text, in_list=in_list):
        return text
    if _QUOTABLE.fullmatch(text) is not None and "\u2028" not in text and "\u2029" not in text and "\ufeff" not in text:
        return "'" + text.replace("'", "''") + "'"
    return '"' + "".join(map(_escaped, text)) + '"'


def _stays(text: str, *, in_list: bool) -> bool:
    """Whether PyYAML reads the text as it is."""
    if _PLAIN.fullmatch(text) is None or len(text) > _LONGEST_LOOKED_AT or (in_list and any(char in text for char in ",[]{}")):
        return False
    import yaml as pyyaml

    try:
        read: object = pyyaml.safe_load(f"[{text}]" if in_list else f"a: {text}")
    except Exception:  # PyYAML lets more than YAMLError out of hostile text
        return False
    return read == ([text] if in_list else {"a": text})


def _escaped(char: str) -> str:
    if char in _SHORT:
        return _SHORT[char]
    code = ord(char)
    if 0x20 <= code <= 0x7E or (code >= 0xA0 and char not in "\u2028\u2029\ufeff" and not 0xD800 <= code <= 0xDFFF and code < 0xFFFE):
        return char
    if 0xD800 <= code <= 0xDFFF:
        raise CannotWrite("it holds half of a character")
    if code <= 0xFF:
        return f"\\x{code:02X}"
    return f"\\u{code:04X}" if code <= 0xFFFF else f"\\U{code:08X}"
