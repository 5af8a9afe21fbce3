"""Which entry files a file reaches: what each was made from, where it looked around, and which files it tells something of."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from launchlint.check.entry import EntryResult
from launchlint.check.options import EntryRequest
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import state
from launchlint.workspace.states import Looks, Shared, places_of


class _Known(NamedTuple):
    """What is kept of one entry file, to be taken out again."""

    read: tuple[str, ...]
    looks: Looks
    told: frozenset[str]


class Reach:
    """The reverse of what results say of themselves. All is proportional to what hangs on a file, not to the number of entry files."""

    def __init__(self) -> None:
        self._known: dict[EntryRequest, _Known] = {}
        self._read: dict[str, dict[EntryRequest, None]] = {}
        self._looks: dict[str, dict[EntryRequest | Shared, str]] = {}
        self._sharing: dict[Shared, dict[EntryRequest, None]] = {}
        self._told: dict[str, dict[EntryRequest, None]] = {}

    def put(self, request: EntryRequest, result: EntryResult, *others: EntryResult) -> None:
        """``result`` is what is known of an entry file; ``others`` are of texts that stand in for broken ones, and hang on the same."""
        self.drop(request)
        read = tuple({name for each in (result, *others) for name, _ in each.dependencies})
        known = self._known[request] = _Known(read, result.looks, frozenset(_paths(result)))
        for file in read:
            self._read.setdefault(file, {})[request] = None
        for path, seen in known.looks.own:
            self._looks.setdefault(path, {})[request] = seen
        for shared in known.looks.all_shared:
            if shared not in self._sharing:
                for path, seen in shared.looks:
                    self._looks.setdefault(path, {})[shared] = seen
            self._sharing.setdefault(shared, {})[request] = None
        for shown in known.told:
            self._told.setdefault(shown, {})[request] = None

    def drop(self, request: EntryRequest) -> None:
        """Nothing is known of an entry file any more."""
        known = self._known.pop(request, None)
        if known is not None:
            for file in known.read:
                self._read[file].pop(request, None)
            for path, _ in known.looks.own:
                self._looks[path].pop(request, None)
            for shared in known.looks.all_shared:
                self._sharing[shared].pop(request, None)
                if not self._sharing[shared]:
                    del self._sharing[shared]
                    for path, _ in shared.looks:
                        self._looks[path].pop(shared, None)
            for shown in known.told:
                self._told[shown].pop(request, None)

    def reading(self, files: Collection[str]) -> Iterator[EntryRequest]:
        """The entry files that were made from any of ``files`` (absolute), whether these are there or not."""
        for file in files:
            yield from self._read.get(file, ())

    def telling(self, paths: Collection[str]) -> frozenset[EntryRequest]:
        """The entry files in whose results something is told of files as shown."""
        return frozenset(request for path in paths for request in self._told.get(path, ()))

    def seeing(self, files: Collection[str], *, listed: bool) -> set[EntryRequest]:
        """The entry files that looked around and would see something else now, when ``files`` (absolute) are others than before.

        ``listed``: they may also have been made or removed.
        """
        found: set[EntryRequest] = set()
        for place in places_of(files, listed=listed):
            lookers = self._looks.get(place)
            if lookers:
                now = state(place)
                for looker, seen in lookers.items():
                    if seen != now:
                        found.update(self._sharing[looker] if isinstance(looker, Shared) else (looker,))
        return found


def _paths(result: EntryResult) -> Iterator[str]:
    yield result.path
    for finding in result.findings:
        yield finding.location.path
        for step in finding.chain:
            yield step.path
    for file in result.files:
        yield file.path
        for guarded in file.findings:
            yield guarded.finding.location.path
