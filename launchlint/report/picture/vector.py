"""A drawing as an SVG file of its own: it shows in a browser, in a comment and on paper, in a light and in a dark page."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.report.escape import visible
from launchlint.report.graph.drawing import Box, Drawing
from launchlint.report.picture.layers import Point, Size
from launchlint.report.picture.sheet import Name, sheet

MARGIN = 28
LONGEST_TITLE = 110
LONGEST_LABEL = 30
"""Characters; what is longer is cut in its middle."""
CHANNELS = ("topic", "service", "action")
STRAIGHT = 3
"""Pixels up or down that need no curve."""
LARGE, SMALL = 7.4, 6.1
"""Pixels that a character takes, in a bold label and in what stands below."""
LEGEND = (("added", "new"), ("removed", "gone"), ("changed", "changed"))

_LIGHT = (
    "--ground:#fff;--box:#fff;--line:#8b99a8;--text:#17212b;--muted:#566474;--soft:#f4f7fa;"
    "--added:#1a7f37;--removed:#cf222e;--changed:#9a6700"
)
_DARK = (
    "--ground:#0d1117;--box:#171d24;--line:#6c7b8a;--text:#e4ebf2;--muted:#a3b0bd;--soft:#1f272f;"
    "--added:#3fb950;--removed:#ff7b72;--changed:#d29922"
)
_STYLE = f"""\
svg{{{_LIGHT}}}
@media (prefers-color-scheme:dark){{svg{{{_DARK}}}}}
text{{font-family:system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif;fill:var(--text)}}
.title{{font-size:17px;font-weight:600}}.sub,.left{{font-size:13px;fill:var(--muted)}}
.ground{{fill:var(--ground)}}.box{{fill:var(--box);stroke:var(--line);stroke-width:1.2}}
.label{{font-size:13px;font-weight:600}}.detail,.name{{font-size:11px;fill:var(--muted)}}
.folded,.others{{fill:var(--soft)}}.unknown{{stroke-dasharray:2 3}}.conditional{{stroke-dasharray:6 4}}
.line{{fill:none;stroke:var(--line);stroke-width:1.3}}.head{{fill:var(--line)}}.back{{fill:var(--ground)}}
.added{{stroke:var(--added);stroke-width:2}}.removed{{stroke:var(--removed);stroke-width:2;stroke-dasharray:6 4}}
.changed{{stroke:var(--changed);stroke-width:2}}
.t-added{{fill:var(--added)}}.t-removed{{fill:var(--removed);text-decoration:line-through}}.t-changed{{fill:var(--changed)}}
.h-added{{fill:var(--added)}}.h-removed{{fill:var(--removed)}}.h-changed{{fill:var(--changed)}}
"""


class Section(NamedTuple):
    """One drawing of a picture: its title, and lines that stand below the title."""

    title: str
    said: Sequence[str]
    drawing: Drawing


def svg(sections: Sequence[Section], *, compared: bool = False, more: int = 0) -> str:
    """The file: all sections, one below the other. With ``compared`` it says what the colours mean; ``more`` are not shown."""
    marks = {mark for each in sections for mark in _marks(each.drawing)}
    legend = [each for each in LEGEND if compared and each[0] in marks]
    out: list[str] = []
    top, width = float(MARGIN), 420.0
    if legend:
        out += _legend(legend, top + 8)
        top += 30
    for each in sections:
        drawn, high, wide = _section(each, top)
        out += drawn
        top, width = top + high, max(width, wide)
    if more:
        out.append(_text(MARGIN, top + 4, f"and {counted(more, 'more launch file')}", "sub"))
        top += 22
    extent = f'width="{width + 2 * MARGIN:.0f}" height="{top:.0f}"'
    box = f'viewBox="0 0 {width + 2 * MARGIN:.0f} {top:.0f}"'
    head = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {extent} {box} role="img">',
        f"<title>{_escape('; '.join(_cut(visible(each.title), LONGEST_TITLE) for each in sections))}</title>",
        f"<style>{_STYLE}</style>",
        f'<rect class="ground" {extent}/>',
    ]
    return "\n".join([*head, *out, "</svg>"]) + "\n"


def _section(section: Section, top: float) -> tuple[list[str], float, float]:
    """What is drawn of one section from ``top`` on, how high and how wide it is."""
    drawing = section.drawing
    placed = sheet(drawing, _size, _name_size)
    said = [_cut(visible(each), LONGEST_TITLE + 30) for each in section.said]
    title = _cut(visible(section.title), LONGEST_TITLE)
    notes = [_cut(visible(drawing.left_out), LONGEST_TITLE + 30)] if drawing.left_out else []
    notes += [] if placed.boxes else ["Nothing to draw."]
    down = top + 34 + 20 * len(said)
    out = [
        _text(MARGIN, top + 14, title, "title"),
        *(_text(MARGIN, top + 36 + 20 * number, each, "sub") for number, each in enumerate(said)),
        f'<g transform="translate({MARGIN} {down:.1f})">',
    ]
    for arrow, points, ends in placed.lines:
        classes = f"line{' conditional' if arrow.conditional or arrow.kind == 'service' else ''}{' ' + arrow.mark if arrow.mark else ''}"
        out.append(f'<path class="{classes}" d="{curve(points, short=ends)}"/>')
        if ends:
            out.append(_head(points, arrow.mark))
    for name, (x, y), (wide, high) in placed.names:
        out.append(f'<rect class="back" x="{x:.1f}" y="{y:.1f}" width="{wide:.1f}" height="{high:.1f}"/>')
        looks = f"name{' t-' + name.mark if name.mark else ''}"
        for number, line in enumerate(name.lines):
            out.append(_text(x + wide / 2, y + 12 + 14 * number, _short(visible(line)), looks, anchor="middle"))
    for box, place, size in placed.boxes:
        out += _box(box, place, size)
    out.append("</g>")
    bottom = down + placed.height + 20
    out += [_text(MARGIN, bottom + 8 + 20 * number, each, "left") for number, each in enumerate(notes)]
    widest = max(placed.width, len(title) * 9.0, *(len(each) * 7.0 for each in (*said, *notes)), 0.0)
    return out, bottom + 20 * len(notes) + MARGIN - top, widest


def _marks(drawing: Drawing) -> set[str]:
    return {box.mark for box in drawing.boxes} | {arrow.mark for arrow in drawing.arrows}


def _legend(legend: Sequence[tuple[str, str]], y: float) -> list[str]:
    found = []
    for number, (mark, word) in enumerate(legend):
        x = MARGIN + 96 * number
        found.append(f'<path class="line {mark}" d="M{x} {y - 4}h26"/>')
        found.append(_text(x + 32, y, word, "detail"))
    return found


def curve(points: Sequence[Point], *, short: bool) -> str:
    """A smooth line through points; with ``short`` it leaves room for a head at its end."""
    (x, y), *rest = points
    if short and rest:
        end_x, end_y = rest[-1]
        rest[-1] = (end_x - (7 if end_x >= (rest[-2][0] if len(rest) > 1 else x) else -7), end_y)
    path = [f"M{x:.1f} {y:.1f}"]
    for to_x, to_y in rest:
        if abs(to_y - y) < STRAIGHT:
            path.append(f"L{to_x:.1f} {to_y:.1f}")
        else:
            middle = (x + to_x) / 2
            path.append(f"C{middle:.1f} {y:.1f} {middle:.1f} {to_y:.1f} {to_x:.1f} {to_y:.1f}")
        x, y = to_x, to_y
    return "".join(path)


def _head(points: Sequence[Point], mark: str) -> str:
    (before, _), (x, y) = points[-2:]
    back = -8 if x >= before else 8
    return f'<path class="head{" h-" + mark if mark else ""}" d="M{x:.1f} {y:.1f}l{back} -4.5v9z"/>'


def _lines(box: Box) -> tuple[str, str, str]:
    """What stands above its name, the name, and what stands below."""
    around = box.parent.partition(" ")[2]
    label = _short(visible(box.label))
    if box.kind == "folded":
        return _short(around), label, counted(box.members, "node")
    if box.kind == "node":
        return _short(visible(around)), label, _short(visible(box.detail))
    return "", label, _short(visible(box.detail))


def _size(box: Box) -> Size:
    above, label, below = _lines(box)
    width = max(len(label) * LARGE, len(above) * SMALL, len(below) * SMALL) + 26
    return max(width, 90.0), 16.0 + 18 + (14 if above else 0) + (15 if below else 0)


def _name_size(name: Name) -> Size:
    return max(len(_short(visible(each))) for each in name.lines) * SMALL + 10, 4.0 + 14 * len(name.lines)


def _box(box: Box, place: Point, size: Size) -> list[str]:
    (x, y), (width, height) = place, size
    above, label, below = _lines(box)
    unknown, conditional = " unknown" if box.unknown else "", " conditional" if box.conditional else ""
    round_ = height / 2 if box.kind in CHANNELS else 8
    out = []
    if box.kind == "folded":
        out.append(f'<rect class="box folded" x="{x + 4:.1f}" y="{y + 4:.1f}" width="{width:.1f}" height="{height:.1f}" rx="8"/>')
    kind = " others" if box.kind == "others" else " folded" if box.kind == "folded" else ""
    looks = f"box{kind}{unknown}{conditional}{' ' + box.mark if box.mark else ''}"
    out.append(f'<rect class="{looks}" x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" rx="{round_:.0f}"/>')
    at = y + 9
    for text, step, name in ((above, 12, "detail"), (label, 16, f"label{' t-' + box.mark if box.mark else ''}"), (below, 15, "detail")):
        if text:
            at += step
            out.append(_text(x + width / 2, at, text, name, anchor="middle"))
            at += 2 if step == 12 else 0
    return out


def _text(x: float, y: float, text: str, looks: str, *, anchor: str = "") -> str:
    middle = f' text-anchor="{anchor}"' if anchor else ""
    return f'<text class="{looks}" x="{x:.1f}" y="{y:.1f}"{middle}>{_escape(text)}</text>'


def _short(text: str) -> str:
    if len(text) <= LONGEST_LABEL:
        return text
    return f"{text[: LONGEST_LABEL // 3]}…{text[1 + LONGEST_LABEL // 3 - LONGEST_LABEL :]}"


def _cut(text: str, longest: int) -> str:
    return text if len(text) <= longest else f"{text[: longest - 1]}…"


def _escape(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")
