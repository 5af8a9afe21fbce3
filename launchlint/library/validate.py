"""Whether a JSON document is a library. Everything below relies on it: a library is untrusted input."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

from launchlint.late import late
from launchlint.library.condition import QUESTIONS, pattern_of
from launchlint.library.format import (
    DEEPEST_CONDITION,
    INTERFACES,
    INTERFACES_2,
    LIBRARIES,
    LIBRARY,
    LISTS,
    PACKAGE,
    PACKAGE_2,
    PROGRAM,
    PROGRAM_2,
    VARIANT,
    VARIANT_2,
)
from launchlint.library.shapes import LONGEST_NAME, Amount, Choice, Entries, Flag, Items, Keys, Number, Plain, Rule, Shape, Text
from launchlint.library.template import TemplateError, is_template, parse
from launchlint.model import ROS1, ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.spelling import did_you_mean

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

Path = tuple[str | int, ...]

_OF_ROS2 = PACKAGE_2.shapes[ROS2]
_COUNTERPARTS = (
    *((INTERFACES[each], INTERFACES_2[each]) for each in LISTS),
    (VARIANT, VARIANT_2),
    (PROGRAM, PROGRAM_2),
    (PACKAGE, _OF_ROS2),
    (PACKAGE_2.shapes[ROS1], _OF_ROS2),
)
"""The shapes of one thing in ROS 1 and in ROS 2."""
_INSTEAD = {
    "latched": '; here `qos` has "durability": "transient_local"',
    "queue": "; here `qos` has a `depth`",
    "nodelets": "; here there are `components`",
}

DEEPEST_VALUE = 50
"""Levels of lists and mappings in a param's default."""
MOST_PROBLEMS = 100
"""Problems told about one library."""

_NAME = late(r"[~/]?[A-Za-z0-9_][\w/]*|~|/", re.ASCII)
_TYPE = late(r"[A-Za-z]\w*/[A-Za-z]\w*", re.ASCII)
_TYPE_2 = late(r"[A-Za-z]\w*/(?:msg|srv|action)/[A-Za-z]\w*", re.ASCII)
_PARAM_2 = late(r"~[^\s~/{}][^\s~{}]*")
_NODE = late(r"[A-Za-z_]\w*", re.ASCII)
_FRAME = late(r"[^\s/~{}][^\s~{}]*")
_MD5 = late(r"[0-9a-f]{32}|\*")


class Fault(NamedTuple):
    """Something that is not as the format wants it: the path of keys and indices to it, and what is wrong."""

    path: Path
    message: str


def faults(document: Any) -> list[Fault]:
    """What is wrong with a library, in the order of the document; at most :data:`MOST_PROBLEMS`."""
    found: list[Fault] = []
    for fault in _walk(_library(document), document, ()):
        found.append(fault)
        if len(found) == MOST_PROBLEMS:
            break
    return found


def _library(document: Any) -> Keys:
    """The shape that a document shall have: that of the version that it is of, or says to be of."""
    said = document.get("version") if isinstance(document, dict) else None
    return LIBRARIES.get(said, LIBRARY) if isinstance(said, int) else LIBRARY


def _walk(shape: Shape, value: Any, path: Path) -> Iterator[Fault]:
    if isinstance(shape, Choice):
        shape = shape.of(value)
    if isinstance(shape, Keys):
        yield from _keys(shape, value, path)
    elif isinstance(shape, Text):
        fault = _text(shape, value)
        if fault:
            yield Fault(path, fault)
    elif isinstance(shape, Items):
        if not isinstance(value, list):
            yield Fault(path, f"this must be a list, and is {_said(value)}")
        else:
            for index, item in enumerate(value):
                yield from _walk(shape.each, item, (*path, index))
    elif isinstance(shape, Entries):
        if not isinstance(value, dict):
            yield Fault(path, f"this must be a mapping from each {shape.named} to what it is, and is {_said(value)}")
        else:
            for key, item in value.items():
                if not key or len(key) > LONGEST_NAME:
                    yield Fault((*path, key), f"the name of the {shape.named} is {'empty' if not key else 'too long'}")
                yield from _walk(shape.each, item, (*path, key))
    else:
        yield from _leaf(shape, value, path)


def _keys(shape: Keys, value: Any, path: Path) -> Iterator[Fault]:
    if not isinstance(value, dict):
        yield Fault(path, f"{shape.name} must be a mapping, and is {_said(value)}")
        return
    for key, item in value.items():
        inner = shape.keys.get(key)
        if inner is None:
            hint = _of_another(shape, key) or did_you_mean(key, shape.keys) or f"there are {', '.join(shape.keys)}"
            yield Fault((*path, key), f"{shape.name} has no key {json.dumps(key[:80], ensure_ascii=False)}: {hint}")
        elif isinstance(inner, Text):  # most of a library is words: no generator for each of them
            fault = _text(inner, item)
            if fault:
                yield Fault((*path, key), fault)
        else:
            yield from _walk(inner, item, (*path, key))
    for key in shape.required:
        if key not in value:
            yield Fault(path, f"{shape.name} lacks the key {json.dumps(key)}")


def _leaf(shape: Shape, value: Any, path: Path) -> Iterator[Fault]:
    if isinstance(shape, Number):
        if isinstance(value, bool) or not isinstance(value, int) or value < shape.least:
            yield Fault(path, f"this must be a whole number, at least {shape.least}, and is {_said(value)}")
        elif path == ("version",) and value not in LIBRARIES:
            known = " and ".join(map(str, LIBRARIES))
            yield Fault(
                path, f"this launchlint reads the versions {known} of the format, and this is version {value}: use a newer launchlint"
            )
    elif isinstance(shape, Amount):
        fault = _amount(shape, value)
        if fault:
            yield Fault(path, fault)
    elif isinstance(shape, Flag):
        if not isinstance(value, bool):
            yield Fault(path, f"this must be true or false, and is {_said(value)}")
    elif isinstance(shape, Plain):
        if _depth(value) > DEEPEST_VALUE:
            yield Fault(path, f"this is nested deeper than {DEEPEST_VALUE} levels")
    elif isinstance(shape, Rule):
        yield from _condition(value, path, 0) if shape.grammar == "condition" else _each(value, path)


def _text(shape: Text, value: Any) -> str:
    """What is wrong with a string, or nothing."""
    if not isinstance(value, str):
        return f"this must be a string, and is {_said(value)}"
    if len(value) > shape.longest:
        return f"this is longer than {shape.longest} characters"
    if shape.templates and is_template(value):
        return _template(value)
    if shape.one_of and value not in shape.one_of:
        hint = did_you_mean(value, shape.one_of)
        return f"{_said(value)} is not one of {', '.join(shape.one_of)}{'; ' + hint if hint else ''}"
    return _SYNTAX[shape.syntax](value) if shape.syntax else ""


def _amount(shape: Amount, value: Any) -> str:
    """What is wrong with a number, or nothing."""
    if isinstance(value, str) and (value in shape.words or is_template(value)):
        return "" if value in shape.words else _template(value)
    wanted = int if shape.whole else (int, float)
    if isinstance(value, bool) or not isinstance(value, wanted) or value < 0:
        what = " or ".join([f"a {'whole ' if shape.whole else ''}number, at least 0", *map(json.dumps, shape.words), "a template"])
        return f"this must be {what}, and is {_said(value)}"
    return ""


def _of_another(shape: Keys, key: str) -> str:
    """Where a key that a shape lacks is one of the other middleware's, what to do; else nothing."""
    for one, other in _COUNTERPARTS:
        if shape is one and key in other.keys:
            return 'that is said of packages of ROS 2: "version": 2, and "middleware": "ros2" in the package'
        if shape is other and key in one.keys:
            return f"that is said of packages of ROS 1{_INSTEAD.get(key, '')}"
    return ""


def _name(value: str) -> str:
    if not is_template(value):
        return "" if _NAME.fullmatch(value) else f"{_said(value)} is no ROS name: letters, digits, _ and /, after a / or ~ at most"
    return _template(value)


def _template(value: str) -> str:
    try:
        parse(value)
    except TemplateError as error:
        return f"{_said(value)} is no template: {error}"
    return ""


def _spelled(value: str, pattern: re.Pattern[str], fault: str) -> str:
    """Why ``value`` is neither a template nor spelled as ``pattern`` has it; empty where it is one of them."""
    if is_template(value):
        return _template(value)
    return "" if pattern.fullmatch(value) else f"{_said(value)} is {fault}"


def _frame(value: str) -> str:
    return _spelled(value, _FRAME, "no frame: it has no blanks, no ~ and no / before it")


def _type(value: str) -> str:
    return "" if value == "*" else _spelled(value, _TYPE, "no type: it is written package/Type")


def _param_2(value: str) -> str:
    return _spelled(value, _PARAM_2, "no param: in ROS 2 each is a node's own, and written ~name, ~name.inner")


def _type_2(value: str) -> str:
    return "" if value == "*" else _spelled(value, _TYPE_2, "no type: in ROS 2 it is written package/msg/Type (srv, action)")


def _node(value: str) -> str:
    if is_template(value):
        return _template(value)
    return "" if _NODE.fullmatch(value) else f"{_said(value)} is no node's name: letters, digits and _, no digit first"


def _md5(value: str) -> str:
    return "" if _MD5.fullmatch(value) else f"{_said(value)} is no MD5 sum: 32 digits of 0-9 a-f"


_SYNTAX = {"name": _name, "frame": _frame, "type": _type, "type2": _type_2, "param2": _param_2, "node": _node, "md5": _md5}
_COMPARISONS = ("is", "in", "set", "default")


def _condition(value: Any, path: Path, depth: int) -> Iterator[Fault]:
    kinds = (*QUESTIONS, "not", "all", "any", "text")
    asked = [key for key in kinds if isinstance(value, dict) and key in value]
    if len(asked) != 1 or depth > DEEPEST_CONDITION:
        said = (
            f"is nested deeper than {DEEPEST_CONDITION} levels" if depth > DEEPEST_CONDITION else f"has one of the keys {', '.join(kinds)}"
        )
        yield Fault(path, f"a condition {said}")
        return
    kind = asked[0]
    inner = value[kind]
    if kind == "not":
        yield from _condition(inner, (*path, kind), depth + 1)
    elif kind in ("all", "any"):
        if not isinstance(inner, list) or not inner:
            yield Fault((*path, kind), "this must be a list of conditions")
        else:
            for index, each in enumerate(inner):
                yield from _condition(each, (*path, kind, index), depth + 1)
    elif kind == "arg":
        yield from _position((*path, kind), inner)
    elif not isinstance(inner, str) or not inner or len(inner) > LONGEST_NAME:
        yield Fault((*path, kind), "this must be a string")
    allowed = {kind, *(_COMPARISONS if kind in ("param", "arg", "option") else ())}
    for key in value:
        if key not in allowed:
            yield Fault((*path, key), f"a condition on {kind} has no key {json.dumps(key[:80], ensure_ascii=False)}")
    if "in" in allowed and not isinstance(value.get("in", []), list):
        yield Fault((*path, "in"), "this must be a list of values")
    if "set" in allowed and not isinstance(value.get("set", True), bool):
        yield Fault((*path, "set"), "this must be true or false")
    if _depth(value) > DEEPEST_VALUE:
        yield Fault(path, f"this is nested deeper than {DEEPEST_VALUE} levels")


def _each(value: Any, path: Path) -> Iterator[Fault]:
    kinds = ("args", "param", "words")
    asked = [key for key in kinds if isinstance(value, dict) and key in value]
    if len(asked) != 1:
        yield Fault(path, f"`each` has one of the keys {', '.join(kinds)}")
        return
    kind = asked[0]
    if kind == "args":
        yield from _position((*path, kind), value[kind])
        like = value.get("like", "{x}")
        if not isinstance(like, str) or len(like) > LONGEST_NAME or pattern_of(like) is None:
            yield Fault((*path, "like"), "this must be names in braces, each once, with something between them: {topic}@{type}")
    elif not isinstance(value[kind], str) or not value[kind] or len(value[kind]) > LONGEST_NAME:
        yield Fault((*path, kind), "this must be the name of a param")
    for key in value:
        if key not in (kind, "like" if kind == "args" else "default"):
            yield Fault((*path, key), f"`each` over {kind} has no key {json.dumps(key[:80], ensure_ascii=False)}")
    default = value.get("default", [])
    if not isinstance(default, list) or not all(isinstance(item, str) for item in default):
        yield Fault((*path, "default"), "this must be a list of strings")


def _position(path: Path, value: Any) -> Iterator[Fault]:
    if isinstance(value, bool) or not isinstance(value, int) or value == 0 or abs(value) > 9_999:
        yield Fault(path, "this must be the number of an argument, counted from 1 or from -1")


def _depth(value: Any) -> int:
    """Levels of lists and mappings, without recursion; stops when it is too deep anyway."""
    level, here = 0, [value]
    while here and level <= DEEPEST_VALUE:
        here = [inner for each in here if isinstance(each, (dict, list)) for inner in (each.values() if isinstance(each, dict) else each)]
        level += 1
    return level


def _said(value: Any) -> str:
    """How a value is named in a message: briefly."""
    if isinstance(value, (dict, list)):
        return "a mapping" if isinstance(value, dict) else "a list"
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 60 else f"{text[:57]}…"
