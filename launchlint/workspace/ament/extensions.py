"""Tags that packages of the workspaces add to launch: ``@expose_action("tag")`` in a module of the entry point of launch's front ends.

Nothing of it is executed, and no module is followed: a text says which tags there are.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace import looking
from launchlint.workspace.packages import Packages

ENTRY_POINT = b"launch.frontend.launch_extension"
_WRITTEN_IN = ("setup.py", "setup.cfg", "pyproject.toml")
_EXPOSED = late(r"""@(?:[\w.]+\.)?expose_action\(\s*['"]([\w.-]+)['"]""")
_MOST_DIRECTORIES = 200


class _Extensions(NamedTuple):
    """The packages that bring tags, by tag; ``looked``: what was looked at to know."""

    brought_by: Mapping[str, str]
    looked: frozenset[str]


def brought_by(packages: Packages) -> Mapping[str, str]:
    """The name of the package that brings each tag (launch.frontend.parser.Parser.load_parser_extensions, launch.frontend.expose)."""
    found = packages.once(_read)
    looking.note(found.looked)
    return found.brought_by


def _read(packages: Packages) -> _Extensions:
    found, looked = looking.watched(lambda: _tags(packages))
    return _Extensions(found, frozenset(looked.all()))


def _tags(packages: Packages) -> Mapping[str, str]:
    tags: dict[str, str] = {}
    directories = {package.directory: package.name for place in packages.places for package in place.everything}
    for directory, name in sorted(directories.items()):
        written = (looking.content(os.path.join(directory, file)) for file in _WRITTEN_IN)
        if any(data is not None and ENTRY_POINT in data for data in written):
            for tag in _exposed(directory):
                tags.setdefault(tag, name)
    return tags


def _exposed(directory: str) -> list[str]:
    tags: list[str] = []
    for place, names in looking.walk(directory, _MOST_DIRECTORIES):
        for name in names:
            data = looking.content(os.path.join(place, name)) if name.endswith(".py") else None
            tags += [] if data is None else _EXPOSED.findall(data.decode("utf-8", "replace"))
    return tags
