"""The edits that fixes are made of.

Each function gives the edits for one change of the text, or none where the change cannot be made there: what comes out of an internal
entity has no place of its own in the file, and is left alone.
"""

from __future__ import annotations

import re

from launchlint.finding import Edit, Fix
from launchlint.named_tuple import NamedTuple
from launchlint.rules.view import FileView, GraphView, LaunchView
from launchlint.source import Place, Source
from launchlint.syntax.ros1.substitutions import opens
from launchlint.syntax.tree import Attribute, Document, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

Edits: TypeAlias = "tuple[Edit, ...]"
LOADS = "roslaunch loads the file"
"""What changes where it refused the file before."""

LOADS2 = "ros2 launch does not stop here any more"
"""The same for ROS 2."""

_REFERENCES = {"&": "&amp;", "<": "&lt;", '"': "&quot;", "'": "&apos;", "\n": "&#10;", "\r": "&#13;", "\t": "&#9;"}


class Spot(NamedTuple):
    """The element in whose start tag a place lies, and its attribute there, if it lies in one."""

    document: Document
    element: Element
    attribute: Attribute | None

    @property
    def source(self) -> Source:
        """The file."""
        return self.document.source


MOST_ATTRIBUTES = 500
"""Of one element, among which the one at a place is looked for."""


def fix(message: str, edits: Edits, *, safe: bool, changes: str = "") -> Fix | None:
    """The fix made of ``edits``, None where there are none; ``changes`` as in :class:`~launchlint.finding.Fix`."""
    return Fix(message, safe, edits, changes) if edits else None


def spot(view: object, place: Place) -> Spot | None:
    """What stands at ``place``; None where it comes out of an entity, or in no start tag."""
    if isinstance(view, FileView):
        document: Document | None = view.document
    elif isinstance(view, (LaunchView, GraphView)):
        document = view.documents.get(place.source.path)
    else:
        return None
    if document is None or document.source is not place.source:
        return None
    at = place.span.start
    element = begun_before(document, at)
    if element is None or not _is_written(document, element) or not element.start_span.start <= at < element.start_span.end:
        return None
    if len(element.attributes) > MOST_ATTRIBUTES:
        return Spot(document, element, None)  # nobody has written it by hand; to look through all of them for each takes too long
    inside = (each for each in element.attributes.values() if each.span.start <= at < each.span.end and _has_name(document, each))
    return Spot(document, element, next(inside, None))


def begun_before(document: Document, at: int) -> Element | None:
    """The last element that begins at ``at`` or before: the one whose start tag, or whose text before any child, is there."""
    after = document.element_from(at + 1)
    index = (len(document.elements) if after is None else after.index) - 1
    return document.elements[index] if index >= 0 else None


def _is_written(document: Document, element: Element) -> bool:
    """Whether the element stands in the file itself, both its tags."""
    text = document.source.text
    opened = text.startswith(f"<{element.tag}", element.span.start)
    return opened and (element.self_closed or text.startswith(f"</{element.tag}", element.end_span.start))


def _has_name(document: Document, attribute: Attribute) -> bool:
    return document.source.text[slice(*attribute.name_span)] == attribute.name


def set_value(at: Spot | None, value: str, attribute: Attribute | None = None) -> Edits:
    """Replace the whole value of the attribute (of ``at``, if none is given)."""
    attribute = attribute or (None if at is None else at.attribute)
    if at is None or attribute is None or not _has_name(at.document, attribute):
        return ()
    start, end = attribute.value_span
    return (Edit(at.source.path, start, end, _escaped(value, at.source.text[start - 1])),)


def replace(at: Spot | None, place: Place, text: str) -> Edits:
    """Replace ``place``, which is all or part of the value of the attribute of ``at``."""
    if at is None or at.attribute is None:
        return ()
    start, end = at.attribute.value_span
    if not start <= place.span.start <= place.span.end <= end:
        return ()
    return (Edit(at.source.path, *place.span, _escaped(text, at.source.text[start - 1])),)


def rename_attribute(at: Spot | None, name: str) -> Edits:
    """Give the attribute of ``at`` another name; nothing where the element has an attribute of that name."""
    if at is None or at.attribute is None or name in at.element.attributes:
        return ()
    return (Edit(at.source.path, *at.attribute.name_span, name),)


def remove_attribute(at: Spot | None) -> Edits:
    """Take the attribute of ``at`` out, and the blanks before it."""
    if at is None or at.attribute is None:
        return ()
    start, end = at.attribute.span
    text = at.source.text
    while text[start - 1] in " \t\r\n":
        start -= 1
    return (Edit(at.source.path, start, end, ""),)


def add_attribute(at: Spot | None, name: str, value: str) -> Edits:
    """Write one more attribute behind the one of ``at``, or behind the tag name."""
    if at is None or name in at.element.attributes:
        return ()
    end = at.element.name_span.end if at.attribute is None else at.attribute.span.end
    return (Edit(at.source.path, end, end, f' {name}="{_escaped(value, chr(34))}"'),)


def rename_tag(at: Spot | None, name: str) -> Edits:
    """Give the element another tag, at its start and at its end."""
    if at is None:
        return ()
    edits = [Edit(at.source.path, *at.element.name_span, name)]
    if not at.element.self_closed:
        start = at.element.end_span.start + len("</")
        edits.append(Edit(at.source.path, start, start + len(at.element.tag), name))
    return tuple(edits)


def remove_element(at: Spot | None) -> Edits:
    """Take the element out; where it has its lines for itself, these too."""
    if at is None or at.element.parent is None:
        return ()
    return (Edit(at.source.path, *at.source.with_lines(at.element.span), ""),)


def move_before(at: Spot | None, other: Element) -> Edits:
    """Move the element of ``at``, with its lines, above ``other``, an earlier sibling; both have their lines for themselves."""
    if at is None or other.parent is not at.element.parent or not _is_written(at.document, other):
        return ()
    span, target = at.source.with_lines(at.element.span), at.source.with_lines(other.span)
    if span == at.element.span or target == other.span or target.start >= span.start:
        return ()
    text = at.source.text[span.start : span.end]
    if not text.endswith(("\n", "\r")):
        return ()
    return (Edit(at.source.path, target.start, target.start, text), Edit(at.source.path, *span, ""))


def append_child(at: Spot | None, child: str) -> Edits:
    """Write the element ``child`` as the last one inside the element of ``at``, in a line of its own where there are lines."""
    if at is None:
        return ()
    element, source = at.element, at.source
    own = _indentation(source, element.span.start)
    newline = "\r\n" if "\r\n" in source.text else "\n"
    if element.self_closed:
        end = element.span.end
        start = end - len("/>")
        while source.text[start - 1] in " \t\r\n":
            start -= 1
        return (Edit(source.path, start, end, f">{newline}{own}  {child}{newline}{own}</{element.tag}>"),)
    end = element.end_span.start
    if element.children and "\n" in source.text[element.start_span.end : end]:
        last = element.children[-1].span
        return (Edit(source.path, last.end, last.end, f"{newline}{_indentation(source, last.start)}{child}"),)
    return (Edit(source.path, end, end, child),)


def _indentation(source: Source, offset: int) -> str:
    line = source.line(source.position(offset).line)
    return line[: len(line) - len(line.lstrip(" \t"))]


def write_over(place: Place, written: str, text: str) -> Edits:
    """Write ``text`` over ``place``, where ``written`` stands there as it is: in XML or YAML, and nothing that had to be escaped."""
    if place.text != written or any(each in _REFERENCES for each in text):
        return ()
    return (Edit(place.source.path, *place.span, text),)


def is_literal(place: Place, value: str) -> bool:
    """Whether what is written at ``place`` is ``value`` itself, not a substitution or a reference that comes to it."""
    return place.text == value and not opens(value) and "&" not in value


def _escaped(value: str, quote: str) -> str:
    """``value`` as it is written between two of ``quote``."""
    other = "'" if quote == '"' else '"'
    return re.sub(r"[&<\"'\n\r\t]", lambda match: match[0] if match[0] == other else _REFERENCES[match[0]], value)


def passed_under(view: LaunchView, place: Place, name: str, near: str | None, before: str = "") -> Fix | None:
    """The arg ``name`` that an include passes at ``place`` goes by the name ``near``, where nothing else is passed under that one.

    ``before`` is what changes besides the value of ``near``.
    """
    at = spot(view, place)
    if near is None or at is None or at.element.parent is None or not is_literal(place, name):
        return None
    if any(each.get("name") == near for each in at.element.parent.children):
        return None
    return fix(f"pass {near}", set_value(at, near), safe=False, changes=f"{before}the value is that of {near}")
