"""The tables that are there without JavaScript: findings, what launch files start and connect, programs that nobody knows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.report.html.parts.markup import NOTHING, Markup, escaped, joined, markup
from launchlint.report.html.tables import Body, Link, Row, Table

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def findings_table(rows: Sequence[Row]) -> Markup:
    """All findings of the page."""
    if not rows:
        said = "No rule found anything wrong. What a node does is only known from libraries: "
        content = markup('<p class="empty">{said}mistakes at nodes that are listed as unknown below cannot be seen.</p>\n', said=said)
    else:
        columns = ("Severity", "Rule", "Finding", "Place", "What to do")
        body = markup("<tbody>\n{rows}</tbody>\n", rows=joined(map(_finding, rows)))
        content = _wide("Findings", "findings", _heads(columns, body))
    return _folding("Findings", len(rows), content)


def _finding(row: Row) -> Markup:
    severity, rule, name, message, at, help_ = row.cells
    return markup(
        '<tr id="findings-{number}" data-index="{number}" class="{severity}"><td>{severity}</td><td>{rule} {name}</td><td>{message}</td>'
        "<td>{at}</td><td>{help}</td></tr>\n",
        number=row.number, severity=severity, rule=rule, name=name, message=message, at=_link(at), help=help_,
    )  # fmt: skip


def table(of: Table, *, several: bool) -> Markup:
    """A table about all launch files; where they are ``several``, the rows of each stand below its name."""
    if not of.rows:
        content = markup('<p class="empty">{empty}</p>\n', empty=of.empty)
    else:
        bodies = joined(_body(body, len(of.columns) if several else 0) for body in of.bodies if body.rows)
        content = _wide(of.caption, of.id, _heads(of.columns, bodies))
        if of.more:
            rest = "more rows belong to launch files that are not in this table: make a report of one file to see them here."
            content = joined((content, markup('<p class="note">{more} {rest}</p>\n', more=of.more, rest=rest)))
    return markup("{table}\n", table=_folding(of.caption, of.rows + of.more, content))


def _body(body: Body, columns: int) -> Markup:
    """The rows of one launch file; its name above them spans so many ``columns``, 0: there is no need of it."""
    title = '<tr class="entry"><th colspan="{columns}" scope="rowgroup">{title}</th></tr>\n'
    named = markup(title, columns=columns, title=body.title) if columns else NOTHING
    return markup('<tbody data-entry="{entry}">\n{named}{rows}</tbody>\n', entry=body.entry, named=named, rows=joined(map(_row, body.rows)))


def _row(row: Row) -> Markup:
    mark = markup(' class="{mark}"', mark=row.mark) if row.mark else NOTHING
    cells = "".join(f"<td>{_link(cell) if isinstance(cell, Link) else escaped(cell)}" for cell in row.cells)
    return Markup(f'<tr data-index="{row.number}"{mark}>{cells}\n')


def _link(at: Link) -> Markup:
    return markup('<a href="{address}">{text}</a>', address=at.address, text=at.text) if at.address else escaped(at.text)


def unknown_table(empty: Mapping[str, Any], mend: Mapping[str, str]) -> Markup:
    """The programs of which nothing is known (``unknown`` of ``summary.empty_states``), and what makes them known."""
    programs = empty["unknown"]
    if not programs:
        return _folding("Unknown programs", 0, Markup('<p class="empty">Every program is known.</p>\n'), id_="unknown")
    parts = [
        markup(
            "<p>{sight}Nothing says what these programs do, so their connections are missing in the drawing, and rules that speak of what "
            "is missing weigh that they may be there.</p>\n",
            sight=f"{empty['sight']}. " if empty["sight"] else "",
        )
    ]
    if mend["command"]:
        parts.append(Markup("<p>To know those whose packages are here, run this, then make the page again:</p>\n"))
        parts.append(
            markup('<pre class="command" tabindex="0" role="group" aria-label="Command">{command}</pre>\n', command=mend["command"])
        )
    if mend["advice"]:
        parts.append(markup("<p>{advice}.</p>\n", advice=mend["advice"]))
    cells = "<tr><td>{program}</td><td>{nodes}</td><td>{why}</td><td>{helps}</td></tr>\n"
    rows = joined(markup(cells, program=program, nodes=nodes, why=why, helps=helps) for program, nodes, why, helps in programs)
    body = markup("<tbody>\n{rows}</tbody>\n", rows=rows)
    parts.append(_wide("Unknown programs", "unknown", _heads(("Program", "Nodes", "Why", "What helps"), body)))
    return _folding("Unknown programs", len(programs), joined(parts), id_="unknown")


def _folding(caption: str, number: int, content: Markup, *, id_: str = "") -> Markup:
    named = markup(' id="{id}"', id=id_) if id_ else NOTHING
    return markup(
        '<details class="table" open{named}>\n<summary><h2>{caption} <span class="number">{number}</span></h2></summary>\n'
        "{content}</details>\n",
        named=named, caption=caption, number=number, content=content,
    )  # fmt: skip


def _wide(caption: str, id_: str, content: Markup) -> Markup:
    """A table that may be wider than the page: it moves by itself."""
    return markup(
        '<div class="wide" tabindex="0" role="region" aria-label="{caption}">\n<table id="table-{id}">\n{content}</table>\n</div>\n',
        caption=caption, id=id_, content=content,
    )  # fmt: skip


def _heads(columns: Sequence[str], content: Markup) -> Markup:
    heads = joined(markup('<th scope="col">{column}</th>', column=column) for column in columns)
    return markup("<thead><tr>{heads}</tr></thead>\n{content}", heads=heads, content=content)
