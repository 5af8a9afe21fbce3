"""The page: data, tables, style and scripts in one file, or with the latter beside it."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Mapping, Sequence
from hashlib import sha256
from typing import NamedTuple

from launchlint.report.html import tables
from launchlint.report.html.cards import Group
from launchlint.report.html.pack import script
from launchlint.report.html.summary import counts, empty_states, overview, verdict, wrong

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

STYLE = "style.css"
SCRIPTS = ("elk.js", "report.js")
"""In the order in which they are loaded."""


class Rendered(NamedTuple):
    """A page, and the files that belong beside it: name → text."""

    html: str
    assets: Mapping[str, str]


def render(data: Mapping[str, Any], landing: Sequence[Group] = (), *, separate: str = "") -> Rendered:
    """The page of ``data``, with ``landing``, the cards of its entry files.

    With ``separate``, the start of their names, style and scripts are files of their own.
    """
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("launchlint.report.html"), autoescape=True, trim_blocks=True, lstrip_blocks=True, undefined=StrictUndefined,
        keep_trailing_newline=True,
    )  # fmt: skip
    style, scripts = _read(STYLE), {name: _read(f"assets/{name}") for name in SCRIPTS}
    names = {name: f"{separate}.{name}" for name in (STYLE, *SCRIPTS)} if separate else {}
    html = environment.get_template("page.html").render(
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
    return Rendered(html, {names[name]: text for name, text in {STYLE: style, **scripts}.items()} if separate else {})


def _policy(styles: Iterable[str], scripts: Iterable[str]) -> str:
    """A Content Security Policy that allows what stands in the page, by its hashes, and nothing else."""
    return f"default-src 'none'; style-src {_hashes(styles)}; script-src {_hashes(scripts)}; base-uri 'none'; form-action 'none'"


def _separate_policy() -> str:
    """The same where style and scripts are files beside the page."""
    return "default-src 'none'; style-src 'self'; script-src 'self'; base-uri 'none'; form-action 'none'"


def _hashes(texts: Iterable[str]) -> str:
    return " ".join(f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'" for text in texts)


def _read(name: str) -> str:
    from importlib.resources import files

    return files("launchlint.report.html").joinpath(name).read_text(encoding="utf-8")
