"""Environment variables that the set-up files of a workspace set: the env-hooks of its packages, read and never run.

A package names its hooks with ``catkin_add_env_hooks``, and nearly always keeps them in a directory called ``env-hooks``; the shell files,
or the templates of them, are sourced by ``devel/setup.sh``.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import content, is_directory, names

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.package import Package

_DIRECTORIES = ("env-hooks", "env_hooks", "env-hook", "env_hook")
_CMAKE_FILE = "CMakeLists.txt"
_CALL = re.compile(rb"^[ \t]*catkin_add_env_hooks\s*\(([^)#]*)\)", re.MULTILINE | re.IGNORECASE)
_DIRECTORY = re.compile(r"\bDIRECTORY\s+\"?(?:\$\{(?:CMAKE_CURRENT|PROJECT|CMAKE)_SOURCE_DIR\}/?)?([^\s\"$]*)")
_MOST_HOOKS = 200

# sh, bash and zsh; csh; cmd and fish; what colcon writes into *.dsv.
_SETS = re.compile(
    r"\b(?:export|setenv)[ \t]+(\w+)"
    r"|^[ \t]*set(?:[ \t]+-\w+)*[ \t]+\"?(\w+)(?:=|[ \t]+\S)"
    r"|^(?:set|set-if-unset|prepend-non-duplicate|prepend-non-duplicate-if-exists|append-non-duplicate);(\w+)(?:;|$)",
    re.MULTILINE,
)
_COMMENT = re.compile(r"^[ \t]*(?:#|@#|rem\b|::).*", re.MULTILINE | re.IGNORECASE)


class Hooks(NamedTuple):
    """What env-hooks set: each variable with the file that sets it, and all places that were looked at."""

    variables: Mapping[str, str]
    looked: frozenset[str]


def read_hooks(packages: Iterable[Package]) -> Hooks:
    """The variables that the hooks of ``packages`` set; values are not looked at. Never raises."""
    found: dict[str, str] = {}
    looked: set[str] = set()
    left = _MOST_HOOKS
    for package in packages:
        for directory, start in _places(package.directory):
            looked.add(directory)
            for name in names(directory) if is_directory(directory) else ():
                file = os.path.join(directory, name)
                if not name.startswith(start) or left <= 0:
                    continue
                left -= 1
                looked.add(file)
                for variable in _set_by((content(file) or b"").decode("utf-8", "replace")):
                    found.setdefault(variable, file)
    return Hooks(found, frozenset(looked))


def _places(package: str) -> list[tuple[str, str]]:
    """The directories with hooks of a package, and what their names begin with."""
    found = [(os.path.join(package, each), "") for each in _DIRECTORIES]
    for call in _CALL.finditer(content(os.path.join(package, _CMAKE_FILE)) or b""):
        text = call[1].decode("utf-8", "replace")
        name, directory = text.split(None, 1)[0] if text.strip() else "", _DIRECTORY.search(text)
        if name and "$" not in name:
            found.append((os.path.normpath(os.path.join(package, directory[1] if directory else "")), f"{name}."))
    return found


def _set_by(text: str) -> list[str]:
    return [next(filter(None, match.groups())) for match in _SETS.finditer(_COMMENT.sub("", text))]
