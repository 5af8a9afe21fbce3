"""The picture that ``launchlint report --picture`` writes: of what changed, or of one launch file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.graph.difference import Difference, difference
from launchlint.graph.topology import EMPTY
from launchlint.plural import counted
from launchlint.report.graph.drawing import draw
from launchlint.report.html.material import EntryMaterial
from launchlint.report.html.tables import entry_title
from launchlint.report.picture.vector import Section, svg

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_BOXES = 60
"""Boxes, and arrows, of one picture that can still be read in a comment."""
MOST_SECTIONS = 4
"""Launch files that one picture shows."""


def picture(data: Mapping[str, Any], materials: Sequence[EntryMaterial]) -> str:
    """The picture as SVG; ``materials`` are in the order of the data's entries.

    Compared with a revision: of each launch file that changed, what changed in it. Else: of the first launch file of the page.
    """
    entries = data["entries"]
    if data["base"] is None:
        return svg([_whole(data, at, materials[at]) for at in range(len(entries))[:1]])
    changed = [at for at in range(len(entries)) if entries[at]["changes"] or entries[at].get("mark")]
    # What several launch files have in common is shown once: where the same became of them.
    sections: dict[tuple[object, ...], Section] = {}
    for at in changed:
        section = _changed(data, at, materials[at])
        sections.setdefault((tuple(section.said), section.drawing), section)
    shown = list(sections.values())[:MOST_SECTIONS]
    if not shown:
        return svg([Section(f"Nothing changed since {data['base']}", (), draw(EMPTY, MOST_BOXES))])
    return svg(shown, compared=True, more=len(changed) - len(shown))


def _whole(data: Mapping[str, Any], at: int, material: EntryMaterial) -> Section:
    entry = data["entries"][at]
    known, nodes = entry["sight"]
    verdict = f"{entry['verdict']}: {entry['why']}" if entry["why"] else entry["verdict"]
    said = [verdict, f"{known} of {counted(nodes, 'node')} known"] if nodes else [verdict]
    return Section(entry_title(data, entry), said, draw(material.topology or EMPTY, MOST_BOXES))


def _changed(data: Mapping[str, Any], at: int, material: EntryMaterial) -> Section:
    entry = data["entries"][at]
    title = entry_title(data, entry)
    before, after = material.before, material.topology
    if before is None or after is None:
        word = "new launch file" if before is None else "this launch file is gone"
        return Section(title, [word], draw(after or before or EMPTY, MOST_BOXES))
    change: Difference = difference(before, after)
    return Section(title, [", ".join(words for _, words in entry["changes"])], draw(after, MOST_BOXES, change))
