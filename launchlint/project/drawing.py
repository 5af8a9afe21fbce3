"""What the drawings of launch files are made from, as it was when all that is open had been looked at."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.check.ignores import PerFileIgnores
from launchlint.check.options import EntryRequest, Options
from launchlint.named_tuple import NamedTuple


class Wanted(NamedTuple):
    """What is to be drawn: an entry file, in the texts (absolute file → what it holds) that stand in for files of a workspace."""

    request: EntryRequest
    texts: Mapping[str, bytes]
    options: Options
    per_file: PerFileIgnores


class Drawing(NamedTuple):
    """All that the pages of some files are made from, as it is now: nothing of it changes any more."""

    requests: Mapping[str, EntryRequest]
    texts: Mapping[str, bytes]
    options: Options
    per_file: PerFileIgnores

    def of(self, file: str) -> Wanted | None:
        """What the page of ``file`` (absolute) is made from; None where it is no entry file."""
        request = self.requests.get(file)
        return None if request is None else Wanted(request, self.texts, self.options, self.per_file)
