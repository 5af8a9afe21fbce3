"""Where the files of a workspace give args to launch files by name: `roslaunch x.launch name:=…` anywhere, `<arg>` within an include."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.given_args import ANY, NOTHING, Uses, uses_of
from launchlint.workspace.looking import walk
from launchlint.workspace.text_parts import GIVEN, GIVEN_IN_LAUNCH, part_of
from launchlint.workspace.texts import parts

_MOST_DIRECTORIES = 2_000
_MOST_FILES = 2_000
_LAUNCH_ENDS = (".launch", ".xml", ".test")
_OTHER_ENDS = (".sh", ".bash", ".zsh", ".service", ".desktop", ".py", ".md", ".rst", ".txt", ".yml", ".yaml", ".rc", ".conf")
_OTHERS = frozenset(("package.xml", "CMakeLists.txt"))

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.contents import Contents


class ArgUses(NamedTuple):
    """By name of the launch file (without directories): the args given to it with ``:=``, each with the files (absolute) that do, and
    the args that includes pass; the places that were looked at; and what each file (absolute) gives.
    """

    given: Mapping[str, Mapping[str, tuple[str, ...]]]
    passed: Mapping[str, frozenset[str]]
    looked: frozenset[str]
    of_files: Mapping[str, Uses]

    def giver(self, file: str, name: str) -> str | None:
        """A file other than ``file`` (absolute) itself that names it and gives the arg ``name`` with ``:=``."""
        return next((each for each in self.given.get(os.path.basename(file), {}).get(name, ()) if each != file), None)

    def may_be_passed(self, name: str) -> bool:
        """Whether an include of which the file name is computed passes the arg: it may enter any of several files that are alike."""
        return name in self.passed.get(ANY, ())

    def is_passed(self, file: str, name: str) -> bool:
        """Whether an include of a file of that name, or one whose name is computed, passes the arg."""
        return any(name in self.passed.get(each, ()) for each in (os.path.basename(file), ANY))

    def after(self, files: Iterable[str]) -> ArgUses:
        """The same when ``files`` (absolute, of those that were looked at) hold something else; itself where that makes no difference."""
        found = {file: uses_of(part_of(file, _part(file))) for file in files}
        if all(self.of_files.get(file, NOTHING) == uses for file, uses in found.items()):
            return self
        of_files = {file: found.get(file, uses) for file, uses in self.of_files.items()}
        return _together(of_files, self.looked)


def read_arg_uses(directories: Iterable[str], held: Contents | None = None) -> ArgUses:
    """The args that launch files, scripts, services and documents below ``directories`` give to launch files. Bounded; never raises.

    ``held`` may know what the files hold.
    """
    looked: set[str] = set()
    found = {file: uses_of(lines) for file, lines in parts(_places(directories), _MOST_FILES, looked, _part, held)}
    return _together(found, frozenset(looked))


def _part(file: str) -> str:
    return GIVEN_IN_LAUNCH if file.endswith(_LAUNCH_ENDS) else GIVEN


def _together(of_files: Mapping[str, Uses], looked: frozenset[str]) -> ArgUses:
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
    return name not in _OTHERS and (name.endswith((*_LAUNCH_ENDS, *_OTHER_ENDS)) or name.startswith("Dockerfile"))
