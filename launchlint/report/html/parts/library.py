"""What the programs on the page are known to do, for readers without JavaScript."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.report.html.parts.markup import NOTHING, Markup, joined, markup

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_ABOUT = (
    "<h2>Library</h2>\n<p>What the programs on this page are known to do, and how that is known: from a run (dynamic), from source code "
    "(static), or written by hand (manual).</p>\n"
)


def library_of(data: Mapping[str, Any]) -> Markup:
    """The section's content."""
    nothing = '<p class="empty">Nothing is known of any program on this page.</p>\n'
    left_out = (
        '<p class="note">{more} more programs are in the libraries that were given: <code>launchlint library show</code> lists them.</p>\n'
    )
    return markup(
        "{about}<noscript>\n{nothing}{programs}{left_out}</noscript>\n",
        about=Markup(_ABOUT),
        nothing=NOTHING if data["library"] else Markup(nothing),
        programs=joined(_program(number, each) for number, each in enumerate(data["library"])),
        left_out=markup(left_out, more=data["libraryLeftOut"]) if data["libraryLeftOut"] else NOTHING,
    )


def _program(number: int, program: Mapping[str, Any]) -> Markup:
    is_nodelet = program["kind"] == "nodelet"
    return markup(
        '<details class="program" id="program-{number}" data-index="{number}">\n'
        '<summary><h3>{name}</h3> <span class="number">{count}</span>{of}</summary>\n{status}{interface}{open}</details>\n',
        number=number, name=program["name"] if is_nodelet else f"{program['package']}/{program['name']}", count=len(program["interface"]),
        of=f" nodelet of {program['package']}" if is_nodelet else "",
        status=markup("<p>{status}</p>\n", status=program["status"]) if program["status"] else NOTHING, interface=_interface(program),
        open=joined(
            markup('<p class="note">It may have more {category} than are listed: {why}</p>\n', category=category, why=why)
            for category, why in program["open"]
        ),
    )  # fmt: skip


def _interface(program: Mapping[str, Any]) -> Markup:
    if not program["interface"]:
        return NOTHING
    row = "<tr><td>{category}</td><td>{name}</td><td>{type}</td><td>{detail}</td><td>{evidence}</td></tr>\n"
    rows = joined(markup(row, **{**each, "evidence": "; ".join(each["evidence"])}) for each in program["interface"])
    heads = joined(markup('<th scope="col">{head}</th>', head=head) for head in ("Kind", "Name", "Type", "Detail", "Evidence"))
    return markup("<table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n", heads=heads, rows=rows)
