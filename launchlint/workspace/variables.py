"""Where a workspace itself sets or reads an environment variable: in shell files, images, services and sources. Nothing is run."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.container_homes import HIDDEN, MOST_HIDDEN
from launchlint.workspace.looking import walk
from launchlint.workspace.texts import parts, texts

_MOST_DIRECTORIES = 2_000
_MOST_FILES = 600
_SHELL_ENDS = (".sh", ".bash", ".zsh", ".env", ".service", ".rc", ".bashrc", ".zshrc")
_SOURCE_ENDS = (".py", ".cpp", ".cc", ".cxx", ".hpp", ".h")
_COMPOSE_ENDS = (".yml", ".yaml")
_SHELL = re.compile(r"^[ \t]*(?:(?:export|declare -x)[ \t]+|Environment=[\"']?)?([A-Za-z_]\w*)=", re.MULTILINE)
_SHELL_NAME = re.compile(r"\.?[\w-]{0,255}(?:env|setup|profile|vars)[\w-]{0,255}", re.IGNORECASE)
"""What people call a shell file that they source, without an ending: ``envsetup``."""
_DOCKER = re.compile(r"^[ \t]*(?:ENV|ARG)[ \t]+([A-Za-z_]\w*)|(?<=\\\n)[ \t]*([A-Za-z_]\w*)=", re.MULTILINE | re.IGNORECASE)
"""In an image; one ``ENV`` may go on in further lines."""
_COMPOSE = re.compile(r"^[ \t]*(?:-[ \t]*[\"']?)?([A-Z_][A-Z_0-9]*)[ \t]*[:=]", re.MULTILINE)
_LAUNCH_ENDS = (".launch", ".launch.xml", ".test")
_SOURCE = re.compile(r"(?:environ(?:\.get)?[ \t]*[\[(]|getenv[ \t]*\()[ \t]*[\"']([A-Za-z_]\w*)[\"']")
_AGAIN, _OPTIONAL = "+", "?"

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.contents import Contents


class Variables(NamedTuple):
    """Each variable that is set or read, with the first file (absolute) that does, and the places that were looked at."""

    known: Mapping[str, str]
    looked: frozenset[str]


def read_variables(directories: Iterable[str]) -> Variables:
    """The variables that files below ``directories`` but launch files set or read; values are not looked at. Bounded; never raises."""
    found: dict[str, str] = {}
    looked: set[str] = set()
    for file, text in texts(_places(directories, lambda name: _pattern(name) is not None), _MOST_FILES, looked):
        pattern = _pattern(os.path.basename(file))
        for match in () if pattern is None else pattern.finditer(text):
            found.setdefault(match[match.lastindex or 0], file)
    return Variables(found, frozenset(looked))


class Readers(NamedTuple):
    """How many launch files read each variable without a default, the variables that one of them reads ``again``, those that some launch
    file has a default for, and the places that were looked at.
    """

    counts: Mapping[str, int]
    again: frozenset[str]
    optional: frozenset[str]
    looked: frozenset[str]

    def family(self, name: str) -> tuple[str, int]:
        """What the variable's name begins with, up to the first ``_``, and how many begin so that are never read with a default."""
        prefix = name.partition("_")[0] + "_"
        return prefix, sum(1 for each in self.counts if each.startswith(prefix) and each not in self.optional)


def read_in_launch_files(directories: Iterable[str], held: Contents | None = None) -> Readers:
    """The variables that launch files below ``directories`` read. Bounded; never raises. ``held`` may know what the files hold.

    It is no grammar, but a look through whole files, comments and all: that a variable is read in many files is a reason for less, never
    for more.
    """
    counted: Counter[str] = Counter()
    more: dict[str, set[str]] = {_AGAIN: set(), _OPTIONAL: set()}
    looked: set[str] = set()
    for _, names in parts(_places(directories, lambda name: name.endswith(_LAUNCH_ENDS)), _MOST_FILES, looked, "variables", held):
        for name in names:
            if name[:1] in more:
                more[name[0]].add(name[1:])
            else:
                counted[name[1:]] += 1
    return Readers(counted, frozenset(more[_AGAIN]), frozenset(more[_OPTIONAL]), frozenset(looked))


def _places(directories: Iterable[str], wanted: Callable[[str], bool]) -> Iterator[tuple[str, list[str]]]:
    for top in directories:
        hidden = (each for name in HIDDEN for each in walk(os.path.join(top, name), MOST_HIDDEN))
        for directory, listed in (*hidden, *walk(top, _MOST_DIRECTORIES)):
            yield directory, [name for name in listed if wanted(name)]


def _pattern(name: str) -> re.Pattern[str] | None:
    if name.endswith(_SHELL_ENDS) or _SHELL_NAME.fullmatch(name):
        return _SHELL
    if name.startswith("Dockerfile") or name.endswith(".dockerfile"):
        return _DOCKER
    if name.endswith(_COMPOSE_ENDS) and "compose" in name:
        return _COMPOSE
    return _SOURCE if name.endswith(_SOURCE_ENDS) else None
