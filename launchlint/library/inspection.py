"""All that is wrong with a library file: what breaks the format, and, where nothing does, what is of no use in it."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.errors import LibraryError
from launchlint.library.consistency import inconsistencies
from launchlint.library.file import decode, read
from launchlint.library.position import located
from launchlint.library.shipped import Bundled
from launchlint.library.validate import MOST_PROBLEMS, Fault, Path, faults

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def inspect_file(path: str) -> tuple[Any, list[str]]:
    """As :func:`inspect`; a file that cannot be read is what is wrong with it."""
    try:
        return inspect(read(path), path)
    except LibraryError as error:
        return None, [str(error)]


def inspect(data: bytes, path: str) -> tuple[Any, list[str]]:
    """The JSON of a library and all that is wrong with it, each line beginning with ``path:line:column``."""
    repeated = _Repeated()
    try:
        text, document = decode(data, path, repeated.mapping)
    except LibraryError as error:
        return None, [str(error)]
    found = [*repeated.faults(document), *(faults(document) or inconsistencies(document, _shipped))]
    return document, located(text, path, found[:MOST_PROBLEMS])


def _shipped(package: str, middleware: str) -> Any:
    return Bundled(middleware).package(package)


class _Repeated:
    """Keys that stand twice in one mapping: JSON readers keep the last value only, so something that somebody wrote is lost."""

    def __init__(self) -> None:
        self._found: dict[int, tuple[dict[str, Any], list[str]]] = {}

    def mapping(self, pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        """What the JSON reader makes of a mapping."""
        made = dict(pairs)
        if len(made) < len(pairs):
            names = [name for name, _ in pairs]
            self._found[id(made)] = made, [name for name in made if names.count(name) > 1]  # holding the mapping keeps its id its own
        return made

    def faults(self, document: Any) -> list[Fault]:
        """One for each such key, in the order of the document."""
        return list(self._below(document, ())) if self._found else []

    def _below(self, value: Any, path: Path) -> Iterator[Fault]:
        waiting: list[tuple[Any, Path]] = [(value, path)]
        while waiting:
            here, path = waiting.pop()
            if isinstance(here, dict):
                for name in self._found.get(id(here), (here, ()))[1]:
                    yield Fault((*path, name), f"this key stands twice in the same mapping; only this value counts: {name[:80]}")
                waiting += [(inner, (*path, key)) for key, inner in reversed(here.items())]
            elif isinstance(here, list):
                waiting += [(inner, (*path, index)) for index, inner in reversed(list(enumerate(here)))]
