"""Parameter rules: ``[node:]name:=value``, as ``-p`` takes them.

Source: ``rcl/src/rcl/arguments.c`` (``_rcl_parse_param_rule``) and ``rcl_yaml_param_parser/src/parse.c`` (``parse_value_events``).
"""

from __future__ import annotations

from launchlint.rcl import lexer
from launchlint.rcl.lexer import Lexemes
from launchlint.rcl.parameter_files import LISTS, TYPES
from launchlint.rcl.parameter_value import Value, scalar
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import ANY, Parameter, Table
from launchlint.source import Span
from launchlint.yaml import events
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.rcl.parameter_value import Scalar


def add(text: str, table: Table) -> Refused | None:
    """Set in ``table`` what the rule ``text`` sets, or say why rcl refuses it."""
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
    key = table.key(node, None, Span(0, start))
    written = table.written(None, name)._replace(value=Span(lexemes.at, len(text)))
    parameter = key.parameters[key.place(text[name.start : name.end], written)]
    return _value(value, lexemes.at, parameter)


def _value(text: str, start: int, parameter: Parameter) -> Refused | None:
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
                    parameter.give(value)
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
                    parameter.give(Value(LISTS[list_type], tuple(values)))
            else:
                return Refused("the value can be no mapping and no alias", span)
    except YamlError as error:
        return Refused(error.message, Span(start + error.offset, start + error.offset))
    except YamlBeyond as beyond:
        return Refused(beyond.message, Span(start, start + len(text)))
    return None


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
