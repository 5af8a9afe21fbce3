"""The file is not in normal form.

Judged is what can be told from the text: blanks at line ends, mixed line ends, a missing last line end, two blank
lines in a row, tabs, an indentation that is not two blanks for each level, several elements in one line, and empty
elements with an end tag. There is one finding for a file, at the first such place. This rule is off until it is
selected.

## Why it matters

Files in one form are easier to read, and changes of them show what has changed and nothing else.

## Example

```xml
<launch>
    <arg name="robot"></arg>
  <group ns="$(arg robot)">
    <node pkg="amcl" type="amcl" name="amcl"/>
  </group>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="robot"/>
  <group ns="$(arg robot)">
    <node pkg="amcl" type="amcl" name="amcl"/>
  </group>
</launch>
```
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView
from launchlint.source import Span
from launchlint.syntax.tree import Document, Element

RULE = Rule("LL801", "not-formatted", Severity.INFO, default=False)

INDENT = "  "
_LINE_END = re.compile(r"\r\n|\n|\r")
_BLANKS = re.compile(r"[ \t]{0,2000}")


def check(view: FileView) -> Iterator[Finding]:
    """Find the first place that is not in normal form, and count the others."""
    document = view.document
    found = sorted({*_in_lines(document), *_in_elements(document)})
    if not found:
        return
    start, end, reason = found[0]
    more = len(found) - 1
    others = f", and {more} other {'place is' if more == 1 else 'places are'} not in normal form" if more else ""
    yield RULE.at(document.place(Span(start, end)), f"{reason}{others}", help="bring the file into normal form")


def _in_lines(document: Document) -> Iterator[tuple[int, int, str]]:
    """What is wrong with lines, outside of comments, YAML and attribute values, which are nobody else's business."""
    source, text = document.source, document.source.text
    kept = _Kept(document)
    ends = {match.group() for match in _LINE_END.finditer(text)}
    if len(ends) > 1:
        last = next(match for match in _LINE_END.finditer(text) if match.group() != "\n")
        yield last.start(), last.end(), "the file mixes line ends of Unix and Windows"
    if text and not text.endswith(("\n", "\r")):
        yield len(text), len(text), "the last line has no line end"
    blank = 0
    for number in range(1, len(source.line_starts) + (0 if text.endswith(("\n", "\r")) else 1)):
        line, start = source.line(number), source.line_starts[number - 1]
        stripped = line.rstrip()
        if stripped != line and not kept.covers(start + len(stripped)):
            yield start + len(stripped), start + len(line), "there are blanks at the end of this line"
        blank = blank + 1 if not stripped and not kept.covers(start) else 0
        if blank == 2:
            yield start, start, "there is more than one blank line in a row"


def _in_elements(document: Document) -> Iterator[tuple[int, int, str]]:
    """What is wrong with the places of tags and comments."""
    text = document.source.text
    for element in document.elements:
        start, end = element.start_span
        if not text.startswith("<", start):
            continue  # out of an entity
        yield from _indented(document, start, element.depth, f"<{element.tag}>")
        if element.self_closed or element.end_span.start == element.end_span.end:
            continue
        if _is_empty(document, element):
            yield start, end, f"<{element.tag}> is empty and has an end tag"
        elif not any(part.value.strip() for part in element.texts):
            yield from _indented(document, element.end_span.start, element.depth, f"</{element.tag}>")
    for comment in document.comments:
        if text.startswith("<!--", comment.span.start):
            depth = 0 if comment.parent is None else comment.parent.depth + 1
            yield from _indented(document, comment.span.start, depth, "this comment", may_follow=True)


def _is_empty(document: Document, element: Element) -> bool:
    return not element.children and not document.source.text[element.start_span.end : element.end_span.start].strip()


def _indented(document: Document, start: int, depth: int, what: str, *, may_follow: bool = False) -> Iterator[tuple[int, int, str]]:
    """Check that what starts at ``start`` is the first in its line, behind the blanks of its depth."""
    source = document.source
    line_start = source.line_starts[source.position(start).line - 1]
    blanks = _BLANKS.match(source.text, line_start)
    before = blanks[0] if blanks is not None else ""
    if line_start + len(before) != start:
        if not may_follow:
            yield start, start + 1, f"{what} does not begin a line"
    elif "\t" in before:
        yield line_start, start, f"{what} is indented with tabs"
    elif before != INDENT * depth:
        yield line_start, start, f"{what} is indented by {_blanks(len(before))} instead of {len(INDENT) * depth}"


def _blanks(count: int) -> str:
    return "1 blank" if count == 1 else f"{count} blanks"


class _Kept:
    """The stretches that keep their form: comments, text that is no mere white space, and attribute values of several lines."""

    def __init__(self, document: Document) -> None:
        spans = [comment.span for comment in document.comments]
        for element in document.elements:
            spans += [part.span for part in element.texts if part.value.strip()]
            spans += [each.value_span for each in element.attributes.values() if "\n" in each.raw or "\r" in each.raw]
        self.spans = sorted(spans)
        self.starts = [span.start for span in self.spans]

    def covers(self, offset: int) -> bool:
        index = bisect_right(self.starts, offset) - 1
        return index >= 0 and offset < self.spans[index].end
