"""The problems of a single element, each made in one place.

The validator makes them from literal values, the evaluator from resolved ones: same kind, same place, same fields, so that
what both notice is one problem. ``refused`` is what roslaunch does if it looks at the element at all.
"""

from __future__ import annotations

from launchlint.source import Origin, Span
from launchlint.syntax.problems import (
    ArgValueAndDefault,
    ConflictingAttributes,
    DeprecatedConstruct,
    IfAndUnless,
    IneffectiveAttribute,
    InvalidValue,
    MisplacedTag,
    MissingAttribute,
    StrayText,
    UnknownAttribute,
    UnknownTag,
    WrongDialect,
)
from launchlint.syntax.ros1.dialect import OWNERS, TagRule
from launchlint.syntax.ros1.domains import Domain
from launchlint.syntax.tree import Document, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    from launchlint.syntax.problems import Conflict, Ineffective


def _at(document: Document, span: Span) -> Origin:
    return Origin(document.place(span))


def unknown_tag(document: Document, element: Element, parent: str, known: tuple[str, ...], ignored: bool) -> UnknownTag:
    """``element``, a tag that nobody knows, in ``parent``, which may have ``known`` ones."""
    return UnknownTag(origin=_at(document, element.name_span), tag=element.tag, parent=parent, known=known, ignored=ignored)


def misplaced_tag(document: Document, element: Element, parent: str, reported: bool) -> MisplacedTag:
    """``element``, which does not belong in ``parent``."""
    return MisplacedTag(
        origin=_at(document, element.name_span),
        tag=element.tag,
        name=element.get("name") or element.get("from") or "",
        parent=parent,
        within=-1 if element.parent is None else element.parent.span.start,
        reported=reported,
    )


def unknown_attribute(document: Document, element: Element, rule: TagRule, name: str) -> UnknownAttribute:
    """The attribute ``name``, which the tag of ``rule`` does not have."""
    return UnknownAttribute(
        origin=_at(document, element.attributes[name].name_span),
        tag=rule.tag,
        attribute=name,
        known=tuple(other for other in rule.known if other not in element.attributes),
        owners=OWNERS.get(name, ()),
        silent=rule.tag == "launch",
    )


def missing_attribute(document: Document, element: Element, name: str, *, refused: bool = True) -> MissingAttribute:
    """The attribute ``name``, which is not there; at the tag name."""
    return MissingAttribute(origin=_at(document, element.name_span), refused=refused, tag=element.tag.lower(), attribute=name)


def invalid_value(document: Document, element: Element, name: str, value: str, domain: Domain) -> InvalidValue:
    """The resolved ``value`` of the attribute ``name``, which is not in ``domain``; at the value."""
    return InvalidValue(
        origin=_at(document, element.attributes[name].shown_span),
        refused=True,
        tag=element.tag.lower(),
        attribute=name,
        value=value,
        expected=domain.expected,
        choices=domain.choices,
    )


def if_and_unless(document: Document, element: Element) -> IfAndUnless:
    """Both conditions on ``element``; at the second of the two."""
    first, second = sorted((element.attributes["if"].name_span, element.attributes["unless"].name_span))
    related = ((document.place(first), "the other condition"),)
    return IfAndUnless(origin=_at(document, second), refused=True, related=related, tag=element.tag.lower())


def conflicting_attributes(
    document: Document, element: Element, reason: Conflict, attributes: tuple[str, ...], *, environment: bool = False
) -> ConflictingAttributes:
    """``attributes`` of ``element`` that exclude each other; at the last of them (the tag name if none)."""
    spans = sorted(
        (element.attributes[name].span if reason == "empty-ns" else element.attributes[name].name_span, name) for name in attributes
    )
    return ConflictingAttributes(
        origin=_at(document, spans[-1][0] if spans else element.name_span),
        refused=True,
        related=tuple((document.place(span), f"with {name}") for span, name in spans[:-1]),
        tag=element.tag.lower(),
        attributes=attributes,
        reason=reason,
        environment=environment,
    )


def arg_value_and_default(document: Document, element: Element) -> ArgValueAndDefault:
    """Both on an ``<arg>``; at the second of the two."""
    first, second = sorted((element.attributes["value"].name_span, element.attributes["default"].name_span))
    related = ((document.place(first), "the other one"),)
    return ArgValueAndDefault(origin=_at(document, second), refused=True, related=related, name=element.get("name") or "")


def ineffective_attribute(document: Document, element: Element, reason: Ineffective, name: str) -> IneffectiveAttribute:
    """The attribute ``name``, or all of ``element`` if that is empty, which does nothing."""
    span = element.attributes[name].name_span if name else element.name_span
    return IneffectiveAttribute(origin=_at(document, span), tag=element.tag.lower(), attribute=name, reason=reason)


def deprecated_construct(document: Document, span: Span, construct: str, instead: str, *, refused: bool = False) -> DeprecatedConstruct:
    """``construct`` at ``span``, which ROS has given up."""
    return DeprecatedConstruct(origin=_at(document, span), refused=refused, construct=construct, instead=instead)


def wrong_dialect(
    document: Document,
    element: Element,
    span: Span,
    what: Literal["tag", "attribute", "substitution"],
    construct: str,
    instead: str,
    *,
    refused: bool = False,
) -> WrongDialect:
    """``construct`` at ``span`` of ``element``, which belongs to ROS 2."""
    return WrongDialect(origin=_at(document, span), refused=refused, tag=element.tag, what=what, construct=construct, instead=instead)


def stray_text(document: Document, span: Span, text: str, parent: str, because: str) -> StrayText:
    """``text`` at ``span``, which nobody reads."""
    behind = document.source.text.endswith("/>", 0, span.start)
    return StrayText(origin=_at(document, span), text=text, parent=parent, because=because, behind_tag=behind)
