"""The page: data, tables, style and scripts in one file, or with the latter beside it."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple
from urllib.parse import quote

from launchlint.report.html import tables
from launchlint.report.html.cards import Group
from launchlint.report.html.pack import script
from launchlint.report.html.parts.landing import landing
from launchlint.report.html.parts.library import library_of
from launchlint.report.html.parts.markup import NOTHING, Markup, joined, markup
from launchlint.report.html.parts.overview import overview_of
from launchlint.report.html.parts.rows import findings_table, table, unknown_table
from launchlint.report.html.summary import Count, counts, empty_states, verdict

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

STYLE = "style.css"
SCRIPTS = ("elk.js", "report.js")
"""In the order in which they are loaded."""
_HERE = Path(__file__).parent

_PAGE = """\
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="referrer" content="no-referrer">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="launchlint {version}">
<title>{title} – launchlint</title>
{style}
</head>
<body>
<a class="skip" href="#tables">Skip to the tables</a>
<header id="bar">
<h1>{title}</h1>
<p id="verdict" class="{level}">{verdict}</p>
<ul id="counts">
{counts}</ul>
<div id="controls"></div>
<p id="pages"><a href="#tables">Tables</a> <a href="#library">Library</a></p>
</header>
<nav id="tree" aria-label="Nodes"></nav>
<main id="stage">
{landing}<div id="drawing">
{overview}</div>
</main>
<aside id="panel" aria-label="Selection"></aside>
<section id="tables" aria-label="Tables">
<noscript>
{tables}</noscript>
{unknown}</section>
<section id="library" aria-label="Library">
{library}</section>
<footer id="foot">
{notices}<p>Made by launchlint {version}. Layout by elkjs, © Eclipse contributors, EPL-2.0.</p>
</footer>
<script type="application/json" id="launchlint-data">{data}</script>
{scripts}</body>
</html>
"""


class Rendered(NamedTuple):
    """A page, and the files that belong beside it: name → text."""

    html: str
    assets: Mapping[str, str]


def render(data: Mapping[str, Any], groups: Sequence[Group] = (), *, separate: str = "") -> Rendered:
    """The page of ``data``, with the cards of its entry files in ``groups``.

    With ``separate``, the start of their names, style and scripts are files of their own.
    """
    style, scripts = _read(STYLE), {name: _read(f"assets/{name}") for name in SCRIPTS}
    names = {name: f"{separate}.{name}" for name in (STYLE, *SCRIPTS)} if separate else {}
    level, said = verdict(data)
    empty = empty_states(data)
    several = len(data["entries"]) > 1
    html = markup(
        _PAGE,
        policy=_separate_policy() if separate else _policy([style], scripts.values()),
        version=data["version"],
        title=data["title"],
        style=_style(style, names),
        level=level,
        verdict=f"{said}, compared with {data['base']}" if data["base"] else said,
        counts=joined(map(_count, counts(data))),
        landing=landing(data, groups) if groups else NOTHING,
        overview=overview_of(data, empty),
        tables=joined((findings_table(tables.findings(data)), *(table(each, several=several) for each in tables.tables(data)))),
        unknown=unknown_table(empty, data["mend"]),
        library=library_of(data),
        notices=joined(markup("<p>{notice}</p>\n", notice=notice) for notice in data["notices"]),
        data=Markup(script(data)),
        scripts=joined(_script(text, names.get(name, "")) for name, text in scripts.items()),
    )
    return Rendered(html, {names[name]: text for name, text in {STYLE: style, **scripts}.items()} if separate else {})


def _style(style: str, names: Mapping[str, str]) -> Markup:
    if names:
        return markup('<link rel="stylesheet" href="{address}">', address=quote(names[STYLE]))
    return markup("<style>{style}</style>", style=Markup(style))


def _script(text: str, file: str) -> Markup:
    if file:
        return markup('<script src="{address}"></script>\n', address=quote(file))
    return markup("<script>{text}</script>\n", text=Markup(text))


def _count(count: Count) -> Markup:
    word = count.word.rstrip("s")
    return markup(
        '<li class="{looks}"><b>{number}</b> {word}</li>\n',
        looks=word if word in tables.SEVERITIES else "", number=count.number, word=count.word,
    )  # fmt: skip


def _policy(styles: Iterable[str], scripts: Iterable[str]) -> str:
    """A Content Security Policy that allows what stands in the page, by its hashes, and nothing else."""
    return f"default-src 'none'; style-src {_hashes(styles)}; script-src {_hashes(scripts)}; base-uri 'none'; form-action 'none'"


def _separate_policy() -> str:
    """The same where style and scripts are files beside the page."""
    return "default-src 'none'; style-src 'self'; script-src 'self'; base-uri 'none'; form-action 'none'"


def _hashes(texts: Iterable[str]) -> str:
    return " ".join(f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'" for text in texts)


def _read(name: str) -> str:
    return (_HERE / name).read_text(encoding="utf-8")
