"""Parameter rules: ``[node:]name:=value``, as ``-p`` takes them.

Source: ``rcl/src/rcl/arguments.c`` (``_rcl_parse_param_rule``) and ``rcl_yaml_param_parser/src/parse.c`` (``parse_value_events``).
"""

from __future__ import annotations

from functools import lru_cache

from launchlint.named_tuple import NamedTuple
from launchlint.rcl import lexer
from launchlint.rcl.lexer import Lexemes
from launchlint.rcl.parameter_files import LISTS, TYPES
from launchlint.rcl.parameter_value import Value, scalar
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import ANY, Table
from launchlint.source import Span
from launchlint.yaml import events
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.rcl.parameter_value import Scalar, ScalarValue


class _Rule(NamedTuple):
    """What a rule says: the ``key`` in front of the ``name``, where the ``value`` stands, and what the parameter is ``given``, in order."""

    node: str
    key: Span
    name: Span
    value: Span
    given: tuple[Value | ScalarValue, ...]


def add(text: str, table: Table) -> Refused | None:
    """Set in ``table`` what the rule ``text`` sets, or say why rcl refuses it."""
    rule = _read(text)
    if isinstance(rule, Refused):
        return rule
    key = table.key(rule.node, None, rule.key)
    written = table.written(None, rule.name)._replace(value=rule.value)
    parameter = key.parameters[key.place(text[rule.name.start : rule.name.end], written)]
    for value in rule.given:
        parameter.give(value)
    return None


@lru_cache(maxsize=4096)
def _read(text: str) -> _Rule | Refused:
    """The rule that is written, or why rcl refuses it. A launch gives one and the same to all of its nodes (``<set_parameter>``)."""
    lexemes = Lexemes(text)
    node = ANY
    if lexemes.kind == lexer.TOKEN and lexemes.following() == lexer.COLON:
        node = lexemes.take()
        lexemes.take()
    start = lexemes.at
    while True:
        if lexemes.kind not in (lexer.TOKEN, lexer.SLASH):
            return _refused(lexemes, _no_name(lexemes))
        while lexemes.accept(lexer.TOKEN, lexer.SLASH):
            pass
        if lexemes.kind == lexer.SEPARATOR:
            break
        if not lexemes.accept(lexer.DOT):
            return _refused(lexemes, _no_name(lexemes))
    name = Span(start, lexemes.at)
    lexemes.take()
    value = text[lexemes.at :]
    if not value:
        return _refused(lexemes, "the value is empty")
    given = _value(value, lexemes.at)
    return given if isinstance(given, Refused) else _Rule(node, Span(0, start), name, Span(lexemes.at, len(text)), given)


def _value(text: str, start: int) -> tuple[Value | ScalarValue, ...] | Refused:
    given: list[Value | ScalarValue] = []
    in_list, list_type = False, ""
    values: list[Scalar] = []
    try:
        for event in events.read(text, "rcl"):
            span = Span(start + event.start, start + event.end)
            if event.kind == events.SCALAR:
                if not event.value and not event.quoted:
                    return Refused("a value is missing", span)
                value = scalar(event.value, event.quoted, event.tag)
                if not in_list:
                    given.append(value)
                elif list_type and list_type != value.type:
                    first, this = TYPES[list_type], TYPES[value.type]
                    return Refused(f"all items of a list must be of one type: the first is {first}, this is {this}", span)
                else:
                    list_type = value.type
                    values.append(value.data)
            elif event.kind == events.SEQUENCE_START:
                in_list, list_type, values = True, "", []
            elif event.kind == events.SEQUENCE_END:
                in_list = False
                if list_type:
                    given.append(Value(LISTS[list_type], tuple(values)))
            else:
                return Refused("the value can be no mapping and no alias", span)
    except YamlError as error:
        return Refused(error.message, Span(start + error.offset, start + error.offset))
    except YamlBeyond as beyond:
        return Refused(beyond.message, Span(start, start + len(text)))
    return tuple(given)


def _no_name(lexemes: Lexemes) -> str:
    if lexemes.kind == lexer.END:
        return ":= and a value are missing"
    if lexemes.kind == lexer.SEPARATOR:
        return "a parameter's name is missing" if lexemes.at == 0 else "a parameter's name cannot end with a point"
    character = lexemes.text[lexemes.at]
    if character.isdigit():
        return "no part of a parameter's name can begin with a digit here"
    return f"a parameter's name cannot hold {'a blank' if character == ' ' else repr(character)} here"


def _refused(lexemes: Lexemes, reason: str) -> Refused:
    return Refused(reason, Span(lexemes.at, len(lexemes.text)))
