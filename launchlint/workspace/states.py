"""What there was where something looked around: paths with their states, as results keep them.

Most of what a result hangs on it shares with others, down to the last path (all manifests of a workspace, all its documents): that is kept
and compared once for all of them.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator
from functools import cached_property

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import ALL_BELOW, PART, QUESTION, Answer, Looked, content_state, state
from launchlint.workspace.texts import parts_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.packages import Packages

Look = tuple[str, str]
"""A path (absolute) and its state (:func:`launchlint.workspace.looking.state`), or a question and its answer."""


class Shared:
    """Looks that many results hang on, sorted; all these hold the same object."""

    def __init__(self, looks: tuple[Look, ...]) -> None:
        self.looks = looks

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Shared) and self.looks == other.looks)

    def __hash__(self) -> int:
        return hash(self.name)

    @cached_property
    def name(self) -> str:
        """Equal for equal looks, in hexadecimal."""
        from hashlib import sha1

        return sha1(repr(self.looks).encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()


class Answered(NamedTuple):
    """The state of the answer to a question, and all looks that the answer hangs on (:class:`launchlint.workspace.looking.Answer`)."""

    question: str
    state: str
    shared: tuple[Shared, ...]


class Looks(NamedTuple):
    """All that a result hangs on by looking around: its own looks, sorted, what it shares with others, and answers."""

    own: tuple[Look, ...] = ()
    shared: tuple[Shared, ...] = ()
    answers: tuple[Answered, ...] = ()

    @property
    def all_shared(self) -> Iterable[Shared]:
        """What it shares with others, and what its answers hang on, each once."""
        return dict.fromkeys((*self.shared, *(each for answer in self.answers for each in answer.shared)))


NOWHERE = Looks()


class States:
    """What there is on disk, each path looked at once, until it is said to have changed.

    ``kept`` gives the state of the answer to a question where it is kept what that hangs on, and all of it is true.
    """

    def __init__(self, find: Callable[[str], str] | None = None, kept: Callable[[str], str | None] | None = None) -> None:
        self._find = find or state_of
        self._kept = kept
        self._known: dict[str, str] = {}
        self._shared: dict[int, tuple[frozenset[str], Shared]] = {}

    def of(self, path: str) -> str:
        """The state of an absolute path."""
        known = self._known.get(path)
        if known is None:
            known = self._known[path] = self._find(path)
        return known

    def looks(self, looked: Looked, others: Iterable[Looks] = ()) -> Looks:
        """What was looked at, with its states; and all of ``others``."""
        own: dict[str, str] = {}
        shared = dict.fromkeys(map(self._whole, looked.wholes))
        answers: dict[str, Answered] = {}
        for other in others:
            own.update(other.own)
            shared.update(dict.fromkeys(other.shared))
            answers.update((each.question, each) for each in other.answers)
        own.update((path, self.of(path)) for path in looked.paths)
        answers.update((each.question, each) for each in self.answered(looked.answers))
        return Looks(tuple(sorted(own.items())), tuple(shared), tuple(sorted(answers.values(), key=lambda each: each.question)))

    def answered(self, answers: Iterable[Answer]) -> Iterator[Answered]:
        """The answers, with the states of all that they hang on; without them where it is kept what the same answer hangs on."""
        for each in answers:
            state = each.state
            if self._kept is not None and self._kept(each.question) == state:
                yield Answered(each.question, state, ())
                continue
            yield Answered(each.question, state, tuple(dict.fromkeys(map(self._whole, filter(None, each.looked.sets())))))

    def _whole(self, paths: frozenset[str]) -> Shared:
        kept = self._shared.get(id(paths))
        if kept is None:  # the set is kept, too: another one must not get its identity
            kept = self._shared[id(paths)] = (paths, Shared(tuple((path, self.of(path)) for path in sorted(paths))))
        return kept[1]

    def forget(self, places: Collection[str]) -> None:
        """There may be something else now at ``places``, as :func:`places_of` gives them."""
        for place in places:
            self._known.pop(place, None)
        for key, (paths, _) in list(self._shared.items()):
            if any(place in paths for place in places):
                del self._shared[key]


def places_of(files: Iterable[str], *, listed: bool) -> set[str]:
    """The places at which one sees something else when ``files`` (absolute) change; ``listed``: when they are made or removed, too."""
    places: set[str] = set()
    for file in files:
        places.update((file, *parts_of(file)))
        directory = os.path.dirname(file) if listed else ""
        if directory:
            places.add(directory)
        while directory:
            places.add(os.path.join(directory, ALL_BELOW))
            directory = os.path.dirname(directory) if directory != os.path.dirname(directory) else ""
    return places


def state_of(path: str, packages: Packages | None = None) -> str:
    """:func:`launchlint.workspace.looking.state`, sooner where it is that of a small file; of a question the answer of ``packages``."""
    if path.startswith(QUESTION):
        from launchlint.workspace.questions import answer

        return "" if packages is None else answer(packages, path)
    return state(path) if PART in path else content_state(path) or state(path)
