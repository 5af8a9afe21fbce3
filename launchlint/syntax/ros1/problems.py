"""The problems of a single element, each made in one place.

The validator makes them from literal values, the evaluator from resolved ones: same kind, same place, same facts, so that
what both notice is one problem. ``refused`` is what roslaunch does if it looks at the element at all; ``step`` is the
include that led to the file.
"""

from __future__ import annotations

from launchlint.problem import Problem
from launchlint.source import IncludeStep, Origin, Place, Span
from launchlint.syntax.ros1.dialect import OWNERS, TagRule
from launchlint.syntax.ros1.domains import Domain
from launchlint.syntax.tree import Document, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

Related = tuple[tuple[Place, str], ...]


def _problem(
    kind: str, document: Document, span: Span, facts: dict[str, Any], step: IncludeStep | None, refused: bool = False, related: Related = ()
) -> Problem:
    return Problem(kind, Origin(Place(document.source, span), step), facts, refused, related)


def unknown_tag(
    document: Document, element: Element, parent: str, known: tuple[str, ...], ignored: bool, step: IncludeStep | None = None
) -> Problem:
    """``unknown-tag``: facts ``tag``, ``parent``, ``known`` (tags allowed there), ``ignored`` (roslaunch says nothing at all)."""
    return _problem(
        "unknown-tag", document, element.name_span, {"tag": element.tag, "parent": parent, "known": known, "ignored": ignored}, step
    )


def misplaced_tag(
    document: Document, element: Element, parent: str, reported: bool, refused: bool = False, step: IncludeStep | None = None
) -> Problem:
    """``misplaced-tag``: facts ``tag``, ``name``, ``parent``, ``within`` (where that starts), ``reported`` (roslaunch warns)."""
    facts = {
        "tag": element.tag,
        "name": element.get("name") or element.get("from") or "",
        "parent": parent,
        "within": -1 if element.parent is None else element.parent.span.start,
        "reported": reported,
    }
    return _problem("misplaced-tag", document, element.name_span, facts, step, refused)


def unknown_attribute(document: Document, element: Element, rule: TagRule, name: str, step: IncludeStep | None = None) -> Problem:
    """``unknown-attribute``: facts ``tag``, ``attribute``, ``known``, ``owners``, ``silent``.

    ``known`` are the attributes of the tag that are not given yet, ``owners`` the tags that have this attribute; ``silent``
    says that roslaunch never checks it (attributes of ``<launch>``).
    """
    known = tuple(other for other in rule.known if other not in element.attributes)
    facts = {"tag": rule.tag, "attribute": name, "known": known, "owners": OWNERS.get(name, ()), "silent": rule.tag == "launch"}
    return _problem("unknown-attribute", document, element.attributes[name].name_span, facts, step)


def missing_attribute(document: Document, element: Element, name: str, step: IncludeStep | None = None, *, refused: bool = True) -> Problem:
    """``missing-attribute`` at the tag name: facts ``tag``, ``attribute``."""
    return _problem("missing-attribute", document, element.name_span, {"tag": element.tag.lower(), "attribute": name}, step, refused)


def invalid_value(document: Document, element: Element, name: str, value: str, domain: Domain, step: IncludeStep | None = None) -> Problem:
    """``invalid-value`` at the value of ``name``: facts ``tag``, ``attribute``, ``value`` (resolved), ``expected``, ``choices``."""
    facts = {"tag": element.tag.lower(), "attribute": name, "value": value, "expected": domain.expected, "choices": domain.choices}
    return _problem("invalid-value", document, element.attributes[name].shown_span, facts, step, refused=True)


def if_and_unless(document: Document, element: Element, step: IncludeStep | None = None) -> Problem:
    """``if-and-unless`` at the second of the two: facts ``tag``."""
    first, second = sorted((element.attributes["if"].name_span, element.attributes["unless"].name_span))
    related = ((document.place(first), "the other condition"),)
    return _problem("if-and-unless", document, second, {"tag": element.tag.lower()}, step, refused=True, related=related)


def conflicting_attributes(
    document: Document, element: Element, reason: str, attributes: tuple[str, ...], step: IncludeStep | None = None
) -> Problem:
    """``conflicting-attributes``: facts ``tag``, ``attributes``, ``reason``; at the last of ``attributes`` (the tag name if none).

    Reasons, all refused by roslaunch: ``respawn-and-required``, ``param-sources`` (``attributes`` are those given, none or several),
    ``empty-ns`` (the evaluator adds ``environment``: an unset variable made it empty), ``clear-params-without-ns``,
    ``clear-params-without-name``, ``test-attribute``, ``delete-with-file``.
    """
    facts = {"tag": element.tag.lower(), "attributes": attributes, "reason": reason}
    if not attributes:
        return _problem("conflicting-attributes", document, element.name_span, facts, step, refused=True)
    spans = sorted(
        (element.attributes[name].span if reason == "empty-ns" else element.attributes[name].name_span, name) for name in attributes
    )
    related = tuple((document.place(span), f"with {name}") for span, name in spans[:-1])
    return _problem("conflicting-attributes", document, spans[-1][0], facts, step, refused=True, related=related)


def arg_value_and_default(document: Document, element: Element, step: IncludeStep | None = None) -> Problem:
    """``arg-value-and-default`` at the second of the two: facts ``name`` (as written)."""
    first, second = sorted((element.attributes["value"].name_span, element.attributes["default"].name_span))
    related = ((document.place(first), "the other one"),)
    return _problem("arg-value-and-default", document, second, {"name": element.get("name") or ""}, step, refused=True, related=related)


def ineffective_attribute(document: Document, element: Element, reason: str, name: str, step: IncludeStep | None = None) -> Problem:
    """``ineffective-attribute``: accepted and without effect. Facts ``tag``, ``attribute`` (empty if it is about the element), ``reason``.

    Reasons: ``respawn-delay-without-respawn``, ``negative-respawn-delay``, ``required-on-test``, ``condition-on-launch``, ``empty-group``,
    ``empty-rosparam``.
    """
    span = element.attributes[name].name_span if name else element.name_span
    return _problem("ineffective-attribute", document, span, {"tag": element.tag.lower(), "attribute": name, "reason": reason}, step)


def deprecated_construct(
    document: Document,
    element: Element,
    span: Span,
    construct: str,
    instead: str,
    step: IncludeStep | None = None,
    *,
    refused: bool = False,
) -> Problem:
    """``deprecated-construct``: facts ``tag``, ``construct``, ``instead``.

    Constructs: ``<master>``, ``machine env``, ``machine ros-root`` (and the other ros-*), ``rosparam ns``, ``xacro.py``.
    """
    return _problem(
        "deprecated-construct", document, span, {"tag": element.tag.lower(), "construct": construct, "instead": instead}, step, refused
    )


def wrong_dialect(
    document: Document,
    element: Element,
    span: Span,
    what: str,
    construct: str,
    instead: str,
    step: IncludeStep | None = None,
    *,
    refused: bool = False,
) -> Problem:
    """``wrong-dialect``: facts ``tag``, ``what``, ``construct``, ``instead``.

    ``what`` is ``tag``, ``attribute`` or ``substitution``; ``instead`` the ROS 1 way (may be empty).
    """
    facts = {"tag": element.tag, "what": what, "construct": construct, "instead": instead}
    return _problem("wrong-dialect", document, span, facts, step, refused)


def stray_text(document: Document, span: Span, text: str, parent: str, because: str, step: IncludeStep | None = None) -> Problem:
    """``stray-text``: facts ``text``, ``parent``, ``because``.

    ``because`` is ``tag`` where the tag takes no text at all, or what makes this rosparam ignore its text: ``file``, ``dump``, ``delete``.
    """
    return _problem("stray-text", document, span, {"text": text, "parent": parent, "because": because}, step)
