"""Looking around on disk: whether something is there, and what a directory holds.

What rules look at beside launch files passes through here and is noted, since the result cache must know what a result hangs on.
"""

from __future__ import annotations

import os
from _thread import _local
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property

from launchlint.named_tuple import NamedTuple

MOST_NAMES = 2_000
"""Directory entries that are looked at: a directory may be of any size, and all of this is only for hints."""

LARGEST_FILE = 1 << 20
"""Bytes: as :data:`launchlint.workspace.reading.LARGEST_FILE`."""
_MANY = 50
"""So many paths, of which all is noted by whoever hangs on one, are one thing."""
ALL_BELOW = "**"
_OF_NPM = "node_modules"
_PYTHON_ENVIRONMENT = "pyvenv.cfg"
PART = "//"
"""Between a file and the part of its text that matters (:func:`launchlint.workspace.texts.parts`): it stands in no absolute path."""

QUESTION = "?"
"""Before what packages were asked (:mod:`launchlint.workspace.questions`): no absolute path begins with it."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Protocol, TypeVar

    Asked = TypeVar("Asked", bound=Callable[[Any, str], Any])
    K = TypeVar("K")
    T = TypeVar("T")
    Kept = Callable[[str, Callable[[], "Looked"]], "Answer | None"]

    class Surveyed(Protocol):
        """What was seen, with all that was looked at for it."""

        @property
        def looked(self) -> frozenset[str]:
            """Paths (absolute)."""


class Looked(NamedTuple):
    """What was looked at, absolute: some ``paths``, and ``wholes``, large sets that others looked at, too (a whole workspace).

    A whole is the same object for all who looked at it, and is never copied: with a set of its own for each of them, what is kept of a
    workspace would grow with the square of it.
    """

    paths: frozenset[str]
    wholes: tuple[frozenset[str], ...] = ()
    answers: tuple[Answer, ...] = ()

    def all(self) -> Iterator[str]:
        """Each path, some perhaps several times; with those that answers hang on."""
        for several in self.sets():
            yield from several

    def sets(self) -> Iterator[frozenset[str]]:
        """The paths in sets, of which those that answers hang on are the same for all who were answered."""
        yield from (self.paths, *self.wholes)
        for answer in self.answers:
            yield from answer.looked.sets()


class Answer:
    """What hangs on an answer alone, what was ``found``, and not on all that was looked at for it.

    While all is as it was where somebody ``looked``, so is the answer; else the question can be asked again.
    """

    def __init__(self, question: str, found: object, looked: Callable[[], Looked]) -> None:
        self.question = question
        self.found = found
        self._looked = looked

    @cached_property
    def looked(self) -> Looked:
        """All that was looked at, or was in an earlier run that kept the answer; it is read when somebody asks."""
        return self._looked()

    @cached_property
    def state(self) -> str:
        """Equal for equal answers."""
        from hashlib import sha1

        return sha1(_told(self.found).encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()


NOTHING = Looked(frozenset())
"""Nowhere."""


class _Account:
    """What one piece of work looked at; ``wholes`` by identity, ``answers`` by question."""

    def __init__(self) -> None:
        self.answers: dict[str, Answer] = {}
        self.paths: set[str] = set()
        self.wholes: dict[int, frozenset[str]] = {}

    def add(self, path: str) -> None:
        """Add one path."""
        self.paths.add(path)

    def update(self, looked: Looked | Iterable[str]) -> None:
        """Add all that was looked at."""
        if isinstance(looked, Looked):
            self.update(looked.paths)
            self.answered(looked.answers)
            for whole in looked.wholes:
                self.wholes[id(whole)] = whole
        elif isinstance(looked, frozenset) and len(looked) >= _MANY:
            self.wholes[id(looked)] = looked
        else:
            self.paths.update(looked)

    def looked(self) -> Looked:
        """All of it."""
        return Looked(frozenset(self.paths), tuple(self.wholes.values()), tuple(self.answers.values()))

    def answered(self, answers: Iterable[Answer]) -> None:
        """Add answers."""
        self.answers.update((each.question, each) for each in answers)


class _OfThread(_local):
    """What a thread looked at: by everything, then by each piece of work inside of another that is watched."""

    def __init__(self) -> None:
        self.noted: list[_Account] = [_Account()]


_account = _OfThread()


def exists(path: str) -> bool:
    """Whether there is anything at ``path``."""
    return os.path.exists(_note(path))


def is_file(path: str) -> bool:
    """Whether there is a file at ``path``."""
    return os.path.isfile(_note(path))


def is_directory(path: str) -> bool:
    """Whether there is a directory at ``path``."""
    return os.path.isdir(_note(path))


def names(directory: str) -> list[str]:
    """The names in ``directory``, sorted; none where it cannot be read. Of a very large one only some are looked at."""
    try:
        return sorted(os.listdir(_note(directory or os.curdir)))[:MOST_NAMES]
    except (OSError, ValueError):
        return []


def walk(directory: str, most: int) -> Iterator[tuple[str, list[str]]]:
    """Each directory at and below ``directory`` with the names in it, in order. Ends after ``most``.

    Hidden ones and links are left out, and what npm or pip installed there: it is somebody else's, and there is much of it.
    """
    waiting = [directory]
    while waiting and most > 0:
        most -= 1
        current = waiting.pop()
        found = _entries(current)
        if _PYTHON_ENVIRONMENT in found:
            continue
        yield current, list(found)
        below = [name for name, is_directory in found.items() if is_directory and not name.startswith(".") and name != _OF_NPM]
        waiting += [os.path.join(current, name) for name in reversed(below)]


def _entries(directory: str) -> dict[str, bool]:
    """As :func:`names`, each with whether it is a directory, and no link to one."""
    try:
        with os.scandir(_note(directory or os.curdir)) as scan:
            entries = sorted(scan, key=lambda entry: entry.name)[:MOST_NAMES]
            return {entry.name: _is_directory(entry) for entry in entries}
    except (OSError, ValueError):
        return {}


def _is_directory(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir(follow_symlinks=False)
    except OSError:
        return False


def start(path: str) -> bytes | None:
    """The first two bytes of a file; ``None`` where it cannot be read."""
    try:
        descriptor = os.open(_note(path), os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    except (OSError, ValueError):
        return None
    try:
        return os.read(descriptor, 2)
    except OSError:
        return None
    finally:
        os.close(descriptor)


def content(path: str) -> bytes | None:
    """All of a small file; ``None`` where there is none that can be read."""
    from launchlint.workspace.reading import read_bytes

    try:
        return read_bytes(_note(path))
    except OSError:
        return None


def read_bytes(path: str, largest: int = LARGEST_FILE) -> bytes:
    """As :func:`launchlint.workspace.reading.read_bytes`."""
    from launchlint.workspace import reading

    return reading.read_bytes(_note(path), largest)


def note_tree(directory: str) -> None:
    """Note that which files there are below ``directory``, and which of them can be run, matters."""
    _account.noted[-1].add(os.path.join(os.path.abspath(directory), ALL_BELOW))


def files_of(directory: str) -> tuple[dict[str, int], bool]:
    """As :func:`launchlint.workspace.listing.files_of`."""
    from launchlint.workspace import listing

    note_tree(directory)
    return listing.files_of(directory)


def noted() -> Looked:
    """What was looked at since this was called last."""
    taken = _account.noted[-1].looked()
    _account.noted[-1] = _Account()
    return taken


def watched(work: Callable[[], T]) -> tuple[T, Looked]:
    """What ``work`` gives, and what it looked at; that stays noted."""
    _account.noted.append(_Account())
    try:
        result = work()
    finally:
        looked = _account.noted.pop().looked()
        note(looked)
    return result, looked


def remembered(known: dict[K, tuple[T, Looked]], key: K, work: Callable[[], T]) -> T:
    """What ``work`` gives, done once for each key; whoever asks has looked at what it looked at."""
    if key not in known:
        known[key] = watched(work)
    else:
        note(known[key][1])
    return known[key][0]


def question(function: Asked) -> Asked:
    """Mark a function of a module that :meth:`Packages.answer` may be given: only such are asked again for what a cache holds."""
    function.is_question = True  # type: ignore[attr-defined]
    return function


def answered(known: dict[str, tuple[T, Answer]], question: str, work: Callable[[], T], kept: Kept | None = None) -> T:
    """What ``work`` gives, done once for each question: whoever asks hangs on the answer alone, which is made of texts and numbers.

    ``kept`` may know the answer, given anew how it would be found.
    """
    if question not in known:

        def anew() -> tuple[T, Looked]:
            _account.noted.append(_Account())
            try:
                found = work()
            finally:
                looked = _account.noted.pop().looked()
            return found, looked

        before: Any = None if kept is None else kept(question, lambda: anew()[1])
        if before is None:
            made, looked = anew()
            known[question] = made, Answer(question, made, lambda: looked)
        else:
            known[question] = before.found, before
    found, answer = known[question]
    _account.noted[-1].answered((answer,))
    return found


def _told(found: object) -> str:
    """Equal for equal answers, in whatever order a set gives its members."""
    if isinstance(found, (set, frozenset)):
        return f"{{{', '.join(sorted(map(_told, found)))}}}"
    if isinstance(found, Mapping):
        return f"{{{', '.join(f'{_told(key)}: {_told(value)}' for key, value in found.items())}}}"
    if isinstance(found, (tuple, list)):
        return f"({', '.join(map(_told, found))})"
    return repr(found)


class _Deaf(_Account):
    """An account in which nothing is noted."""

    def add(self, _: str) -> None:
        """Nothing."""

    def update(self, _: Looked | Iterable[str]) -> None:
        """Nothing."""

    def answered(self, _: Iterable[Answer]) -> None:
        """Nothing."""


@contextmanager
def unnoted() -> Iterator[None]:
    """While it lasts nothing is noted: what is looked at is of no concern to whatever this thread works on."""
    _account.noted.append(_Deaf())
    try:
        yield
    finally:
        _account.noted.pop()


def note(looked: Looked | Iterable[str]) -> None:
    """Note again what was looked at (paths are absolute)."""
    _account.noted[-1].update(looked)


def note_question(way: str, kind: str, about: str = "") -> None:
    """Note what packages that are found in this ``way`` were asked."""
    _account.noted[-1].add(f"{QUESTION}{way} {kind} {about}")


def state(path: str) -> str:
    """Equal for equal answers of all functions here: what is at ``path``, the content of a small file, or the names in a directory."""
    from hashlib import sha1

    from launchlint.workspace.reading import read_bytes

    file, _, part = path.partition(PART)
    try:
        if file and part:
            from launchlint.workspace.text_parts import part_state

            return part_state(_read(file), part)
        if path.endswith(os.sep + ALL_BELOW):
            return _tree(path[: -len(ALL_BELOW)])
        if os.path.isdir(path):
            return directory_state(os.listdir(path))
        if not os.path.exists(path):
            return ""
        return f"file {sha1(read_bytes(path), usedforsecurity=False).hexdigest()}"
    except (OSError, ValueError) as error:
        return f"{type(error).__name__} {getattr(error, 'errno', '')} {error.args[-1] if error.args else ''}"


def directory_state(names: Iterable[str]) -> str:
    """The :func:`state` of a directory in which there are these names."""
    from hashlib import sha1

    return f"directory {sha1(chr(0).join(sorted(names)).encode('utf-8', 'surrogateescape'), usedforsecurity=False).hexdigest()}"


def content_state(path: str) -> str:
    """As :func:`state`, sooner, for a small file; empty for all else."""
    from hashlib import sha1

    from launchlint.workspace.reading import read_bytes

    try:
        return f"file {sha1(read_bytes(path), usedforsecurity=False).hexdigest()}"
    except (OSError, ValueError):
        return ""


def _read(file: str) -> bytes:
    """What a small file holds; nothing where it cannot be read."""
    from launchlint.workspace.reading import read_bytes

    try:
        return read_bytes(file)
    except (OSError, ValueError):
        return b""


def tree_state(files: Mapping[str, int], *, complete: bool) -> str:
    """The :func:`state` of all below a directory in which there are these files, as :func:`launchlint.workspace.listing.files_of` tells."""
    from hashlib import sha1

    text = "\0".join([f"{name} {mode & 0o111}" for name, mode in files.items()] + [str(complete)])
    return f"tree {sha1(text.encode('utf-8', 'surrogateescape'), usedforsecurity=False).hexdigest()}"


def _tree(directory: str) -> str:
    from launchlint.workspace.listing import files_of

    files, complete = files_of(directory)
    return tree_state(files, complete=complete)


def _note(path: str) -> str:
    _account.noted[-1].add(os.path.abspath(path))
    return path
