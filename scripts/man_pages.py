"""Write the manual pages docs/man/*.1 from the commands, or check that they are what those say (``--check``)."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import click

from launchlint import __version__
from launchlint.cli.commands import main_group

PAGES = Path(__file__).resolve().parent.parent / "docs" / "man"
DATE = "1970-01-01"
"""Stands where click-man wants the day; a page must not change because time went by."""


def pages() -> dict[str, str]:
    """Name of each page, and its text."""
    from click_man.core import write_man_pages

    with tempfile.TemporaryDirectory() as directory:
        write_man_pages("launchlint", _loaded(), version=__version__, target_dir=directory, date=DATE)
        return {file.name: _tidy(file.read_text(encoding="utf-8")) for file in sorted(Path(directory).iterdir())}


def _loaded() -> click.Group:
    """The commands, which are else imported only when they are called."""
    context = click.Context(main_group)
    found = {name: main_group.get_command(context, name) for name in main_group.list_commands(context)}
    commands = {name: command for name, command in found.items() if command is not None}
    return click.Group("launchlint", commands, params=main_group.params, help=main_group.help)


def _tidy(text: str) -> str:
    head, _, body = text.partition("\n")
    return "\n".join(line.rstrip() for line in (head.replace(f'"{DATE}"', '""'), *body.splitlines())) + "\n"


def main(words: list[str]) -> int:
    """Write the pages, or with ``--check`` look at them. Returns the exit status."""
    texts = pages()
    if words == ["--check"]:
        there = {file.name: file.read_text(encoding="utf-8") for file in PAGES.glob("*.1")}
        wrong = sorted(name for name in texts.keys() | there.keys() if texts.get(name) != there.get(name))
        if wrong:
            print(f"docs/man is not what the commands say: {', '.join(wrong)}; run scripts/man_pages.py", file=sys.stderr)
        return int(bool(wrong))
    PAGES.mkdir(exist_ok=True)
    for file in PAGES.glob("*.1"):
        if file.name not in texts:
            file.unlink()
    for name, text in texts.items():
        (PAGES / name).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
