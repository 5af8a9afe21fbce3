"""A drawing as big as a card: boxes and lines without a word, so that the shape of a system is seen. It takes the colours of its page."""

from __future__ import annotations

from launchlint.report.graph.drawing import Box, Drawing
from launchlint.report.picture.layers import Size
from launchlint.report.picture.sheet import sheet
from launchlint.report.picture.vector import curve

MOST = 24
"""Boxes, and arrows, of a drawing that is still a picture at this size."""
WIDTH, HEIGHT = 300, 108
MARGIN = 6
LARGEST_SCALE = 1.0


def thumbnail(drawing: Drawing) -> str:
    """An ``<svg>`` element for an HTML page, one path for all boxes that look alike; empty where there is nothing to draw."""
    placed = sheet(drawing, _size, None, widest=560.0)
    if not placed.boxes:
        return ""
    scale = min((WIDTH - 2 * MARGIN) / placed.width, (HEIGHT - 2 * MARGIN) / placed.height, LARGEST_SCALE)
    left, top = (WIDTH - placed.width * scale) / 2, (HEIGHT - placed.height * scale) / 2
    paths: dict[str, list[str]] = {}
    for arrow, points, _ in placed.lines:
        moved = [(left + x * scale, top + y * scale) for x, y in points]
        paths.setdefault(f"line {arrow.mark}".rstrip(), []).append(curve(moved, short=False))
    for box, (x, y), (width, height) in placed.boxes:
        corner = f"M{left + x * scale:.1f} {top + y * scale:.1f}"
        paths.setdefault(f"{_looks(box)} {box.mark}".rstrip(), []).append(
            f"{corner}h{width * scale:.1f}v{height * scale:.1f}h{-width * scale:.1f}z"
        )
    drawn = "".join(f'<path class="{looks}" d="{"".join(those)}"/>' for looks, those in paths.items())
    return f'<svg class="thumbnail" viewBox="0 0 {WIDTH} {HEIGHT}" aria-hidden="true">{drawn}</svg>'


def _looks(box: Box) -> str:
    if box.kind in ("topic", "service", "action"):
        return "channel"
    return "unknown" if box.unknown else "folded" if box.kind in ("folded", "others") else "node"


def _size(box: Box) -> Size:
    if box.kind in ("topic", "service", "action"):
        return (26.0, 12.0)
    return (64.0, 32.0) if box.kind == "folded" else (52.0, 24.0)
