"""``<param>``: a name with a value, or with further params in it, or a file.

Source: ``launch_ros.actions.Node.parse_nested_parameters``.
"""

from __future__ import annotations

from launchlint.source import Origin
from launchlint.syntax.ros2 import complaints
from launchlint.syntax.ros2.description import Parameter, ParameterFile, Substitution, Text, TypedValue
from launchlint.syntax.ros2.problems import BrokenInFrontend, ParameterForm, WrongValue
from launchlint.syntax.ros2.tables import PARAMETER, PARAMETER_TYPES
from launchlint.syntax.ros2.values import literal_fits
from launchlint.syntax.ros2.words import EXPECTED

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from launchlint.source import Place
    from launchlint.syntax.ros2.description import ParameterSource
    from launchlint.syntax.ros2.entity import Entity, Value
    from launchlint.syntax.ros2.parsing import Parser
    from launchlint.syntax.ros2.problems import Form
    from launchlint.syntax.ros2.values import Plain, Scalar


def parameters(parser: Parser, entity: Entity) -> tuple[ParameterSource, ...]:
    """The params of a node, in order."""
    found: list[ParameterSource] = []
    for each in entity.named("param", parser.problems) or ():
        file = each.value("from", "str", parser.problems)
        substitute = each.value("allow_substs", "bool", parser.problems)
        name = each.value("name", "str", parser.problems)
        if file is not None and name is not None:
            _form(parser, "from-and-name", max(file.place, name.place, key=lambda place: place.span))
        if file is not None:
            found.append(_file(parser, each, file, substitute))
        elif name is not None:
            if substitute is not None:
                _form(parser, "substs-without-from", each.attribute_place("allow_substs"))
            found.extend(_nested(parser, [each]))
        elif not each.has("from") and not each.has("name"):
            _form(parser, "neither", each.name_place)
    return tuple(found)


def _file(parser: Parser, entity: Entity, file: Value, substitute: Value | None) -> ParameterFile:
    allowed = False
    if substitute is not None and isinstance(substitute.plain, str):
        _no_flag(parser, substitute, substitute.plain)
    elif substitute is not None:
        allowed = bool(substitute.plain)
    complaints.unread(parser, entity, PARAMETER, ())
    return ParameterFile(parser.text(file.text), allowed, entity.place)


def _no_flag(parser: Parser, value: Value, written: str) -> None:
    """``allow_substs`` is a text: launch parses it for substitutions, and then takes nothing but a truth value (ParameterFile)."""
    origin, name = Origin(value.place), "allow_substs"
    if parser.text(value.text).literal is None:
        parser.problems.append(BrokenInFrontend(origin=origin, refused=True, what="flag", name=name))
    else:
        parser.problems.append(
            WrongValue(origin=origin, refused=True, tag="param", attribute=name, value=written, expected=EXPECTED["bool"])
        )


def _nested(parser: Parser, entities: Iterable[Entity]) -> list[Parameter]:
    """The params that have a name, and those in them."""
    found: list[Parameter] = []
    problems = parser.problems
    for entity in entities:
        value = entity.value("name", "str", problems)
        if value is None and not entity.has("name"):
            complaints.lacks(parser, entity, "name")
        name = parser.text(value.text) if value is not None else Text((Substitution("", (), entity.place),), entity.place)
        kind = _type(parser, entity)
        given = entity.value("value", kind or "yaml", problems)
        inner = entity.named("param", problems) or ()
        complaints.unread(parser, entity, PARAMETER, ("param",))
        if inner and entity.has("value"):
            _form(parser, "value-and-nested", entity.attribute_place("value"))
        elif inner and kind is not None and kind != "yaml":
            _form(parser, "type-and-nested", entity.attribute_place("type"))
        if given is not None:
            found.append(Parameter(name, typed(parser, entity.tag, given, kind), (), entity.place))
        elif inner:
            found.append(Parameter(name, None, tuple(_nested(parser, inner)), entity.place))
        elif not entity.has("value"):
            _form(parser, "empty", entity.name_place)
    return found


def _type(parser: Parser, entity: Entity) -> str | None:
    """What ``type`` says; None for nothing."""
    value = entity.value("type", "yaml", parser.problems)
    if value is None:
        return None
    if isinstance(value.plain, str) and value.plain in PARAMETER_TYPES:
        return value.plain
    said = value.plain if isinstance(value.plain, str) else value.place.text
    parser.problems.append(
        WrongValue(
            origin=Origin(value.place),
            refused=True,
            tag=entity.tag,
            attribute="type",
            value=said,
            expected=f"one of {', '.join(PARAMETER_TYPES)}",
            choices=PARAMETER_TYPES,
        )
    )
    return None


def typed(parser: Parser, tag: str, value: Value, kind: str | None) -> TypedValue:
    """A value, as far as it is known without computing anything. What does not fit ``kind`` is told of."""
    kind = None if kind == "yaml" else kind
    if not isinstance(value.plain, list):
        if not isinstance(value.plain, str):
            return TypedValue(Text((_shown(value.plain),), value.place), kind, _fitting(parser, tag, value.place, value.plain, kind))
        text = parser.text(value.text)
        if text.literal is None:
            return TypedValue(text, kind)
        return TypedValue(text, kind, _fitting(parser, tag, value.place, text.literal, kind))
    texts: list[Text] = []
    plain: list[Scalar | None] = []
    for each, written in zip(value.plain, value.items, strict=True):
        text = Text((_shown(each),), value.place) if written is None else parser.text(written)
        texts.append(text)
        plain.append(each if written is None else text.literal)
    known = [each for each in plain if each is not None]
    if len({type(each) for each in known}) > 1:
        _misfit(parser, tag, value.place, "a list of values of one type")
    elif _fits(parser, tag, value.place, known, len(known) < len(plain), kind):
        return TypedValue(tuple(texts), kind, tuple(plain))
    as_text = value.place.text
    return TypedValue(Text((as_text,), value.place), kind, as_text)  # it is told of: whoever evaluates it has nothing to add


def _fitting(parser: Parser, tag: str, place: Place, plain: Scalar, kind: str | None) -> Scalar:
    _fits(parser, tag, place, plain, False, kind)
    return plain


def _fits(parser: Parser, tag: str, place: Place, plain: Plain, computed: bool, kind: str | None) -> bool:
    if literal_fits(plain, computed, kind):
        return True
    _misfit(parser, tag, place, EXPECTED[kind or "yaml"])
    return False


def _misfit(parser: Parser, tag: str, place: Place, expected: str) -> None:
    parser.problems.append(WrongValue(origin=Origin(place), refused=True, tag=tag, attribute="value", value=place.text, expected=expected))


def _shown(plain: Scalar) -> str:
    return str(plain).lower() if isinstance(plain, bool) else str(plain)


def _form(parser: Parser, form: Form, place: Place) -> None:
    parser.problems.append(ParameterForm(origin=Origin(place), refused=True, form=form))
