"""The page: data, tables, style and scripts in one file, or with the latter beside it."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Mapping, Sequence
from hashlib import sha256
from pathlib import Path

from launchlint.named_tuple import NamedTuple
from launchlint.report.html import tables
from launchlint.report.html.cards import Group
from launchlint.report.html.pack import script
from launchlint.report.html.summary import counts, empty_states, overview, verdict, wrong

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from jinja2 import Environment

STYLE = "style.css"
SCRIPTS = ("elk.js", "report.js")
"""In the order in which they are loaded."""
HERE = Path(__file__).parent
COMPILED = HERE / "compiled"
"""The templates as Python, in a directory that is named after the jinja2 that wrote it."""


class Rendered(NamedTuple):
    """A page, and the files that belong beside it: name → text."""

    html: str
    assets: Mapping[str, str]


def render(data: Mapping[str, Any], landing: Sequence[Group] = (), *, separate: str = "") -> Rendered:
    """The page of ``data``, with ``landing``, the cards of its entry files.

    With ``separate``, the start of their names, style and scripts are files of their own.
    """
    style, scripts = _read(STYLE), {name: _read(f"assets/{name}") for name in SCRIPTS}
    names = {name: f"{separate}.{name}" for name in (STYLE, *SCRIPTS)} if separate else {}
    html = (
        templates()
        .get_template("page.html")
        .render(
            data=data,
            landing=landing,
            wrong=wrong(data),
            json=script(data),
            policy=_separate_policy() if separate else _policy([style], scripts.values()),
            style=style,
            scripts=scripts,
            names=names,
            tables=tables.tables(data),
            findings=tables.findings(data),
            place=lambda at: tables.place(data, at),
            entry_title=lambda entry: tables.entry_title(data, entry),
            verdict=verdict(data),
            counts=counts(data),
            overview=overview(data),
            empty=empty_states(data),
        )
    )
    return Rendered(html, {names[name]: text for name, text in {STYLE: style, **scripts}.items()} if separate else {})


def templates(*, compiled: bool = True) -> Environment:
    """The templates of the page: as ``scripts/page_templates.py`` compiled them where this very jinja2 did it, else from their text.

    Compiling them takes as long as checking a small repository.
    """
    import jinja2

    text = jinja2.PackageLoader("launchlint.report.html")
    made = COMPILED / f"jinja2-{vars(jinja2).get('__version__')}"
    return jinja2.Environment(
        # Made by another version there is no such directory: what the compiler writes is jinja2's own affair.
        loader=jinja2.ChoiceLoader([jinja2.ModuleLoader(made), text]) if compiled else text,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
        keep_trailing_newline=True,
    )


def _policy(styles: Iterable[str], scripts: Iterable[str]) -> str:
    """A Content Security Policy that allows what stands in the page, by its hashes, and nothing else."""
    return f"default-src 'none'; style-src {_hashes(styles)}; script-src {_hashes(scripts)}; base-uri 'none'; form-action 'none'"


def _separate_policy() -> str:
    """The same where style and scripts are files beside the page."""
    return "default-src 'none'; style-src 'self'; script-src 'self'; base-uri 'none'; form-action 'none'"


def _hashes(texts: Iterable[str]) -> str:
    return " ".join(f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'" for text in texts)


def _read(name: str) -> str:
    return (HERE / name).read_text(encoding="utf-8")
