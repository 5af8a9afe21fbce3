"""Functions and members of the standard library and of boost that names, objects and callbacks go through."""

from __future__ import annotations

import re
from functools import lru_cache

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.naming import is_whole, template, together
from launchlint.extract.cpp.spelled_type import POINTERS, UNTYPED, Type
from launchlint.extract.cpp.values import (
    UNKNOWN,
    Callable,
    Cell,
    Either,
    Items,
    Number,
    Text,
    Thing,
    Value,
    choices,
    either,
    node_of,
    plain,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_THROUGH = frozenset(
    """std::move move std::forward boost::ref std::ref boost::cref std::cref boost::bind_ std::make_unique_ std::addressof
    boost::make_optional boost::algorithm::trim_copy std::as_const boost::implicit_cast ros::names::clean""".split()
)
_CASTS = frozenset(
    """static_cast dynamic_cast const_cast reinterpret_cast boost::static_pointer_cast std::static_pointer_cast
    boost::dynamic_pointer_cast std::dynamic_pointer_cast dynamic_pointer_cast static_pointer_cast boost::const_pointer_cast
    boost::numeric_cast boost::polymorphic_cast""".split()
)
_MAKERS = frozenset(
    """boost::make_shared std::make_shared std::make_unique make_shared make_unique absl::make_unique boost::make_unique""".split()
)
_TO_TEXT = frozenset("""std::to_string to_string boost::lexical_cast lexical_cast boost::str str std::string string QString""".split())
_BINDERS = frozenset(("boost::bind", "std::bind", "bind", "boost::mem_fn", "std::mem_fn"))
_NUMBERS = frozenset(("int", "double", "float", "bool", "size_t", "std::size_t", "uint32_t", "uint8_t", "unsigned"))
CHANGING = frozenset(("push_back", "emplace_back", "insert", "append", "resize", "clear", "assign", "emplace", "push_front", "str"))
"""Members that change a container or a text."""
_BRACES = re.compile(r"\{\{(\d{0,3})(:[^{}]*)?\}\}")
_OF_PARAMETERS = frozenset("as_string as_int as_double as_bool as_string_array as_integer_array get_value get get_parameter_value".split())
"""Members of rclcpp::Parameter that give its value."""
_MOST_ITEMS = 200
NPOS = 2**64 - 1
"""What a search gives that finds nothing: ``std::string::npos``."""
_FORMATS = re.compile(r"(?:^|::)(?:u?[Ff]ormat|[Ss]tr(?:ing)?_?[Ff]ormat|StringPrintf|stringf)$")
"""Functions of libraries that format as printf does, and give the text."""


_PRINTING = frozenset(("sprintf", "snprintf", "std::snprintf", "std::sprintf"))
_COPYING = frozenset(("strcpy", "std::strcpy", "strncpy"))
_OF_BOOST = frozenset(("boost::format", "format"))
_FUNCTIONS = frozenset(("boost::function", "std::function"))
_TUPLES = frozenset(("std::make_pair", "make_pair", "std::pair", "std::make_tuple"))
_KNOWN = _BINDERS | _MAKERS | _CASTS | _THROUGH | _TO_TEXT | _NUMBERS | _PRINTING | _COPYING | _OF_BOOST | _FUNCTIONS | _TUPLES


def function(asked: Call) -> Value | None:
    """The value of a call; None where the function is none of these."""
    name = asked.name
    if not _may_be_known(name):
        return None
    machine = asked.machine
    if name in _BINDERS:
        return _bound(asked)
    if name in _MAKERS and asked.types:
        return classes.construct(machine, asked.types[0], asked.arguments, asked.node, asked.frame)
    if name.endswith(("::make_shared", "::make_unique")) and not asked.types:
        return _made_by_class(asked)
    if name in _CASTS and asked.arguments:
        value = asked.value(0)
        return classes.converted(machine, value, asked.types[0], asked.frame) if asked.types and isinstance(value, Number) else value
    if name in _THROUGH and asked.arguments:
        return asked.value(0)
    if name in _TO_TEXT and asked.arguments:
        return _text(asked)
    if name in _NUMBERS and len(asked.arguments) == 1:
        return classes.converted(machine, asked.value(0), Type(name), asked.frame)
    if name in _PRINTING:
        return _printed(asked, 1 if name.endswith("sprintf") and "n" not in name.removeprefix("std::")[:2] else 2)
    if name in _COPYING and asked.cell(0) is not None:
        machine.write(asked.arguments[0].cell or Cell(UNKNOWN), asked.value(1))
        return UNKNOWN
    if name in _OF_BOOST and asked.arguments:
        thing = Thing(Type("boost::format"), None, 0)
        thing.fields["<text>"] = machine.cell(asked.value(0))
        return thing
    if len(asked.arguments) > 1 and _FORMATS.search(name) and isinstance(asked.value(0), Text):
        return _formatted(asked, 0)
    if name in _FUNCTIONS and asked.arguments:
        return asked.value(0)
    if name in _TUPLES:
        return Items(tuple(each.value for each in asked.arguments))
    return None


@lru_cache(maxsize=8192)
def _may_be_known(name: str) -> bool:
    """Whether :func:`function` knows anything of a function by its name."""
    return name in _KNOWN or name.endswith(("::make_shared", "::make_unique")) or _FORMATS.search(name) is not None


def _made_by_class(asked: Call) -> Value | None:
    """``Class::make_shared(…)``, which RCLCPP_SMART_PTR_DEFINITIONS gives a class."""
    from launchlint.extract.cpp import ros

    machine = asked.machine
    if machine.declarations.functions.get(asked.name):
        return None
    type_ = machine.names.resolve(Type(asked.name.rpartition("::")[0]), asked.frame)
    if machine.names.declared(type_) is None and not ros.is_made(machine, type_):
        return None
    return classes.construct(machine, type_, asked.arguments, asked.node, asked.frame)


def _bound(asked: Call) -> Value:
    found: list[tuple[str, Value]] = []
    rest: list[int | Value] = []
    for each in asked.arguments[1:]:
        text = each.node.text.rpartition("::")[2] if each.node is not None else ""
        rest.append(int(text[1:]) - 1 if text[:1] == "_" and text[1:].isdigit() and len(text) < 4 else each.value)
    for condition, value in choices(asked.value(0)):
        if isinstance(value, Callable) and value.bound is None:
            this, given = value.this, list(rest)
            if this is None and given and value.functions and value.functions[0].owner:
                first = given[0]
                if isinstance(first, Either):
                    first = first.choices[0][1]
                if isinstance(first, Thing):
                    this, given = first, given[1:]
            found.append((condition, Callable(value.functions, this, tuple(given), value.types)))
        else:
            found.append((condition, value))
    return either(found) if found else UNKNOWN


def _text(asked: Call) -> Value:
    value = asked.value(0)
    if asked.name.endswith("lexical_cast") and asked.types and asked.types[0].name != "std::string":
        return value if isinstance(value, Number) else UNKNOWN
    if isinstance(value, Thing):
        cell = value.fields.get("<text>")
        return cell.value if cell is not None else UNKNOWN
    if isinstance(value, (Text, Either)):
        return value
    return Text(plain(value) or "{any}") if isinstance(value, Number) else Text("{any}")


def _printed(asked: Call, position: int) -> Value:
    cell = asked.cell(0)
    if cell is not None:
        asked.machine.write(cell, _formatted(asked, position))
    return UNKNOWN


def _formatted(asked: Call, position: int) -> Value:
    """The format at ``position`` with the arguments behind it filled in."""
    from launchlint.extract.cpp.operators import LONGEST_TEXT, filled

    text = asked.value(position)
    if not isinstance(text, Text):
        return UNKNOWN
    if "{{" in text.template and asked.name.endswith("ormat"):
        given = [template(each.value) for each in asked.arguments[position + 1 :]]
        return Text(_in_braces(text.template, given)) if sum(map(len, given)) + len(text.template) <= LONGEST_TEXT else UNKNOWN
    done = text.template
    for each in asked.arguments[position + 1 : position + 12]:
        done = filled(done, template(each.value))
    return Text(done)


def _in_braces(text: str, given: list[str]) -> str:
    """A text in which ``{}``, ``{0}`` and ``{:x}`` stand for arguments, as std::format fills them in."""
    rest = iter(given)

    def one(match: re.Match[str]) -> str:
        number, specification = match[1], match[2]
        value = next(rest, "{any}") if not number else given[int(number)] if int(number) < len(given) else "{any}"
        return "{any}" if specification else value

    return _BRACES.sub(one, text)


def method(value: Value, asked: Call, cell: Cell | None) -> Value:
    """A member function of a text or a list."""
    name = asked.name
    machine = asked.machine
    if isinstance(value, Text):
        if name in ("c_str", "data", "str", "toStdString", "begin") or (name in _OF_PARAMETERS and value.param):
            return value
        if name in ("empty", "isEmpty", "size", "length") and is_whole(value):
            return Number(not value.template) if "mpty" in name else Number(len(value.template))
        if name in ("append", "push_back", "operator+=") and cell is not None:
            changed = together(value, asked.value(0))
            machine.write(cell, changed)
            return changed
        if name in ("assign", "operator=") and cell is not None:
            machine.write(cell, asked.value(0))
            return asked.value(0)
        if name in ("substr", "at", "front", "back"):
            return _part(value, asked)
        if name in ("find", "rfind", "starts_with", "ends_with", "contains"):
            return _searched(value, asked)
        if name in ("erase", "replace", "insert", "resize", "pop_back", "clear") and cell is not None:
            machine.write(cell, Text("") if name == "clear" else UNKNOWN)
        return UNKNOWN
    if isinstance(value, Items):
        if name in ("size", "length", "empty") and not value.items:
            return UNKNOWN  # code that is not followed may have filled it
        if name in ("size", "length"):
            return Number(len(value.items))
        if name == "empty":
            return Number(False)
        if name in ("push_back", "emplace_back", "insert", "emplace", "push_front") and cell is not None:
            made = _emplaced(asked, cell) if name == "emplace_back" else None
            if made is not None:
                machine.write(cell, Items((*value.items, made)) if len(value.items) < _MOST_ITEMS else UNKNOWN)
                return UNKNOWN
            if len(asked.arguments) == 1 and len(value.items) < _MOST_ITEMS:
                machine.write(cell, Items((*value.items, asked.value(0))))
            else:
                machine.write(cell, UNKNOWN)
            return UNKNOWN
        if name in ("at", "operator[]"):
            index = asked.value(0)
            if isinstance(index, Number) and isinstance(index.value, int) and 0 <= index.value < len(value.items):
                return value.items[index.value]
            return UNKNOWN
        if name in ("front", "back") and value.items:
            return value.items[0 if name == "front" else -1]
        if name == "clear" and cell is not None:
            machine.write(cell, Items(()))
        elif name == "resize" and cell is not None and _length(asked.value(0)) is not None:
            length = _length(asked.value(0)) or 0
            machine.write(cell, Items((*value.items[:length], *[UNKNOWN] * (length - len(value.items)))))
        elif name in ("resize", "assign", "erase", "pop_back", "swap") and cell is not None:
            machine.write(cell, UNKNOWN)
        return UNKNOWN
    if name == "emplace_back":
        _emplaced(asked, cell)
    return UNKNOWN


def _emplaced(asked: Call, cell: Cell | None) -> Thing | None:
    """The element that ``emplace_back(…)`` makes of its arguments. One of which nothing is known may talk where it is given a node."""
    machine, frame = asked.machine, asked.frame
    type_ = cell.type if cell is not None else UNTYPED
    spelled = type_.arguments and type_.name not in POINTERS
    if not spelled:
        type_ = machine.names.resolve(type_, frame)  # looks through pointers, which its elements may be, too
    single = asked.value(0) if len(asked.arguments) == 1 else UNKNOWN
    element = type_.arguments[0] if type_.arguments else UNTYPED
    declared = machine.names.declared(machine.names.resolve(element, frame)) if element.name else None
    if isinstance(single, Thing) and (declared is None or single.declared is None or classes.is_a(machine, single, declared.name)):
        return None  # an element that is made elsewhere
    certain = bool(spelled) or len(asked.arguments) > 1
    if element.name and certain and (declared is not None or not isinstance(asked.value(0), Thing)):
        made = classes.construct(machine, element, asked.arguments, asked.node, frame)
        if isinstance(made, Thing):
            return made
    if declared is None and len(asked.arguments) > 1 and any(node_of(each.value) is not None for each in asked.arguments):
        machine.doubt_all(f"{asked.name} makes what is not known of a node", frame.path, asked.node.line)
    return None


def _length(value: Value) -> int | None:
    known = value.value if isinstance(value, Number) else None
    return known if isinstance(known, int) and not isinstance(known, bool) and 0 <= known <= _MOST_ITEMS else None


def _searched(value: Text, asked: Call) -> Value:
    """Where a text has another one, from its beginning or its end; whether it begins or ends with it."""
    sought = asked.value(0)
    if len(asked.arguments) != 1 or not isinstance(sought, Text) or not is_whole(sought) or not is_whole(value):
        return UNKNOWN
    if asked.name in ("starts_with", "ends_with"):
        return Number(
            value.template.startswith(sought.template) if asked.name == "starts_with" else value.template.endswith(sought.template)
        )
    if asked.name == "contains":
        return Number(sought.template in value.template)
    at = value.template.find(sought.template) if asked.name == "find" else value.template.rfind(sought.template)
    return Number(at if at >= 0 else NPOS)


def _part(value: Text, asked: Call) -> Value:
    bounds = [each.value.value for each in asked.arguments if isinstance(each.value, Number) and isinstance(each.value.value, int)]
    if asked.name != "substr" or not is_whole(value) or len(bounds) != len(asked.arguments) or not bounds:
        return UNKNOWN
    start = bounds[0]
    if start < 0 or start > len(value.template):
        return UNKNOWN
    return Text(value.template[start : start + bounds[1]] if len(bounds) > 1 and bounds[1] >= 0 else value.template[start:])


def thing_method(value: Thing, asked: Call) -> Value | None:
    """A member function of a stream or a format."""
    cell = value.fields.get("<text>")
    if asked.name == "str":
        if asked.arguments:
            if cell is not None:
                asked.machine.write(cell, asked.value(0))
            return UNKNOWN
        if cell is not None:
            return cell.value
        return Text("") if value.type.last in ("stringstream", "ostringstream") else UNKNOWN
    return None
