"""Where the files of a workspace give args to launch files by name: `roslaunch x.launch name:=…` anywhere, `<arg>` within an include."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk
from launchlint.workspace.texts import decoded, files, texts

_MOST_DIRECTORIES = 2_000
_MOST_FILES = 2_000
_LAUNCH_ENDS = (".launch", ".xml", ".test")
_OTHER_ENDS = (".sh", ".bash", ".zsh", ".service", ".desktop", ".py", ".md", ".rst", ".txt", ".yml", ".yaml", ".rc", ".conf")
_NOT_LAUNCH = frozenset(("package.xml", "CMakeLists.txt"))
# Whole files of any kind are looked through, none is read as a launch file: what is found here only keeps rules silent.
_FILE = re.compile(r"(?<![\w.-])[\w.-]{1,200}\.(?:launch|test|xml)\b")
_GIVEN = re.compile(r"(?<![\w/~])([A-Za-z]\w{0,200}):=")
_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_ARGS = re.compile(r"""\bargs\s{0,20}=\s{0,20}("[^"<]*"|'[^'<]*')""")
_INCLUDED = re.compile(r"\bfile\s*=\s*[\"']([^\"']{0,1000})[\"']")
_PASSED = re.compile(r"<arg\b[^<>]{0,1000}?\bname\s*=\s*[\"'](\w+)[\"']")
_ANY = ""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.workspace.contents import Contents


class _Uses(NamedTuple):
    """What one file gives: the launch files that it starts, and those that it includes, each with names of args."""

    starts: tuple[tuple[str, frozenset[str]], ...]
    includes: tuple[tuple[str, frozenset[str]], ...]


_NOTHING = _Uses((), ())


class ArgUses(NamedTuple):
    """By name of the launch file (without directories): the args given to it with ``:=``, each with the files (absolute) that do, and
    the args that includes pass; the places that were looked at; and what each file (absolute) gives.
    """

    given: Mapping[str, Mapping[str, tuple[str, ...]]]
    passed: Mapping[str, frozenset[str]]
    looked: frozenset[str]
    of_files: Mapping[str, _Uses]

    def giver(self, file: str, name: str) -> str | None:
        """A file other than ``file`` (absolute) itself that names it and gives the arg ``name`` with ``:=``."""
        return next((each for each in self.given.get(os.path.basename(file), {}).get(name, ()) if each != file), None)

    def may_be_passed(self, name: str) -> bool:
        """Whether an include of which the file name is computed passes the arg: it may enter any of several files that are alike."""
        return name in self.passed.get(_ANY, ())

    def is_passed(self, file: str, name: str) -> bool:
        """Whether an include of a file of that name, or one whose name is computed, passes the arg."""
        return any(name in self.passed.get(each, ()) for each in (os.path.basename(file), _ANY))

    def after(self, files: Iterable[str]) -> ArgUses:
        """The same when ``files`` (absolute, of those that were looked at) hold something else; itself where that makes no difference."""
        found = {file: _uses(file, text) for file, text in texts([("", sorted(files))], _MOST_FILES, set())}
        if all(self.of_files.get(file, _NOTHING) == uses for file, uses in found.items()):
            return self
        of_files = {file: found.get(file, uses) for file, uses in self.of_files.items()}
        return _together(of_files, self.looked)


def read_arg_uses(directories: Iterable[str], held: Contents | None = None) -> ArgUses:
    """The args that launch files, scripts, services and documents below ``directories`` give to launch files. Bounded; never raises.

    ``held`` may know what the files hold.
    """
    looked: set[str] = set()
    places = _places(directories)
    if held is None:
        found = {file: _uses(file, text) for file, text in texts(places, _MOST_FILES, looked)}
    else:
        found = {file: _known_uses(file, held) for file in files(places, _MOST_FILES, looked)}
    return _together(found, frozenset(looked))


def _known_uses(file: str, held: Contents) -> _Uses:
    try:
        return held.fact(file, "arg uses", lambda data: _uses(file, decoded(data)), _to_json, _from_json)
    except OSError:
        return _NOTHING


def _to_json(uses: _Uses) -> list[Any]:
    return [[[name, sorted(given)] for name, given in each] for each in uses]


def _from_json(known: Any) -> _Uses:
    starts, includes = (tuple((name, frozenset(given)) for name, given in each) for each in known)
    return _Uses(starts, includes)


def _uses(file: str, text: str) -> _Uses:
    if not file.endswith(_LAUNCH_ENDS):
        return _Uses(tuple(_starts(text, is_launch=False)), ())
    text = _COMMENT.sub("", text)
    return _Uses(tuple(_starts(text, is_launch=True)), tuple(_includes(text)))


def _together(of_files: Mapping[str, _Uses], looked: frozenset[str]) -> ArgUses:
    given: dict[str, dict[str, tuple[str, ...]]] = {}
    passed: dict[str, set[str]] = {}
    for file, uses in of_files.items():
        for started, names in uses.starts:
            givers = given.setdefault(started, {})
            for each in names:
                if file not in givers.get(each, ()):
                    givers[each] = (*givers.get(each, ()), file)[:2]
        for included, names in uses.includes:
            passed.setdefault(included, set()).update(names)
    return ArgUses(given, {key: frozenset(value) for key, value in passed.items()}, looked, of_files)


def _places(directories: Iterable[str]) -> Iterator[tuple[str, list[str]]]:
    for top in directories:
        for directory, listed in walk(top, _MOST_DIRECTORIES):
            yield directory, [name for name in listed if _may_start(name)]


def _may_start(name: str) -> bool:
    return name not in _NOT_LAUNCH and (name.endswith((*_LAUNCH_ENDS, *_OTHER_ENDS)) or name.startswith("Dockerfile"))


def _starts(text: str, *, is_launch: bool) -> Iterator[tuple[str, frozenset[str]]]:
    """Launch files that the text names with the args that it gives: those of the same line; in a launch file, those of any node's args."""
    if ":=" not in text:
        return
    lines = text.replace("\\\n", " ").splitlines()
    if is_launch:
        lines = [" ".join([*_ARGS.findall(text), *_FILE.findall(text)])]
    for line in lines:
        names = frozenset(_GIVEN.findall(line)) if ":=" in line else frozenset()
        for started in dict.fromkeys(_FILE.findall(line)) if names else ():
            yield started, names


def _includes(text: str) -> Iterator[tuple[str, frozenset[str]]]:
    """The launch files that the text includes, with the args that it passes."""
    for part in text.split("<include")[1:]:
        inside, _, _ = part.partition("</include>")
        file = _INCLUDED.search(inside[:2_000])
        if file is not None:
            name = file[1].rpartition("/")[2]
            yield _ANY if "$(" in name or ")" in name else name, frozenset(_PASSED.findall(inside))
