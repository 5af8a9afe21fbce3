"""What stands in place of the drawing until scripts draw it: the first launch file by its namespaces, or why there is none."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.report.html.parts.markup import NOTHING, Markup, joined, markup
from launchlint.report.html.summary import overview
from launchlint.report.html.tables import entry_title

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def overview_of(data: Mapping[str, Any], empty: Mapping[str, Any]) -> Markup:
    """``empty`` is that of ``summary.empty_states``."""
    if empty["entries"]:
        return Markup(
            '<p class="empty">There is no launch file to show. Give files, or a directory that holds some: '
            "<code>launchlint report robot.launch -o report.html</code>.</p>\n"
        )
    if empty["nodes"]:
        said = "which nodes are started is not known" if empty["open"] else "no node is started"
        why = joined(_why(data, entry) for entry in empty["refused"][:1])
        return markup('<p class="empty">Nothing to draw: {said}.{why}</p>\n', said=said, why=why)
    first = data["entries"][0]
    rows = joined(
        markup("<tr><td>{name}</td><td>{nodes}</td><td>{unknown}</td></tr>\n", name=name, nodes=nodes, unknown=unknown)
        for name, nodes, unknown in overview(data)
    )
    return markup(
        '<noscript><p class="note">The drawing needs JavaScript. Everything it shows stands in the tables below.</p></noscript>\n'
        "<h2>{title}</h2>\n{refused}{with_args}"
        '<table id="overview">\n'
        '<thead><tr><th scope="col">Namespace</th><th scope="col">Nodes</th><th scope="col">Unknown</th></tr></thead>\n'
        "<tbody>\n{rows}</tbody>\n</table>\n",
        title=entry_title(data, first), refused=_refused(first),
        with_args=markup('<p class="empty">{said}</p>\n', said=first["withArgs"]) if first["withArgs"] else NOTHING, rows=rows,
    )  # fmt: skip


def _why(data: Mapping[str, Any], entry: Mapping[str, Any]) -> Markup:
    title = entry_title(data, entry)
    refused = entry["verdict"] == "refused"
    said = f"{entry['launcher']} refuses {title}" if refused else f"Whether {entry['launcher']} loads {title} cannot be told"
    return markup(" {said}: {why}.", said=said, why=entry["why"])


def _refused(entry: Mapping[str, Any]) -> Markup:
    if entry["verdict"] == "loads":
        return NOTHING
    launcher = entry["launcher"]
    said = f"{launcher} refuses this file" if entry["verdict"] == "refused" else f"Whether {launcher} loads this file cannot be told"
    rest = "Shown is what it would start otherwise, as far as that can be told."
    return markup('<p class="empty">{said}: {why}. {rest}</p>\n', said=said, why=entry["why"], rest=rest)
