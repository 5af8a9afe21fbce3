"""A package that is not here, while all that a launch file asks of it lies in its own package: a name from before a split or rename."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from launchlint.late import late
from launchlint.rules.package_contents import contents
from launchlint.syntax.ros1.substitutions import parse_again
from launchlint.workspace.looking import exists, note, walk, watched
from launchlint.workspace.packages import Package, Packages
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.texts import texts

_LAUNCH_ENDS = (".launch", ".launch.xml", ".test")
_MOST_DIRECTORIES = 100
_MOST_FILES = 200
_STARTED = late(r"<(?:node|test)\s[^<>]{1,2000}>")
_PKG = late(r"\spkg\s*=\s*[\"']([^\"']*)[\"']")
_TYPE = late(r"\stype\s*=\s*[\"']([^\"'$]*)[\"']")
_BEHIND = late(r"/([\w.+/-]+)(\$?)")


def own_instead(name: str, text: str, packages: Packages, near: str) -> Package | None:
    """The package of the launch file ``near`` with content ``text``, if it holds all files and programs that are asked of ``name``.

    A public package may well have files of the same names: then the own package must bear its name, and more (``camera_driver`` for
    ``camera``), and hold a program that is asked for, too. ``None`` where the package is here or declared, where nothing is asked of it
    that can be told, where the file would include itself (it stands before one of the same name), and where other launch files of the
    own package ask ``name`` for what that has not.
    """
    home = packages.package_of(near)
    if home is None or not home.name or home.name == name or packages.has(name):
        return None
    if home.manifest is None or name in home.manifest.depends():
        return None
    asked = _asked(text)
    found, started = asked.files.get(name, ()), asked.started.get(name, ())
    if (not found and not started) or any(made for _, made in found):
        return None
    if name in public_names() and not (started and home.name.startswith(f"{name}_")):
        return None
    if any(posixpath.join(home.directory, file) == posixpath.abspath(near) for file, _ in found):
        return None
    if not all(exists(posixpath.join(home.directory, file)) for file, _ in found):
        return None
    programs = contents(packages).executables(home).names if started else []
    types = [_TYPE.search(tag) for tag in started]
    if not all(each is not None and each[1] in programs for each in types):
        return None
    return None if _another_exists(name, home, packages, near) else home


_latest: list[tuple[Packages, dict[tuple[str, str], tuple[bool, frozenset[str]]]]] = []


def _another_exists(name: str, home: Package, packages: Packages, near: str) -> bool:
    """As :func:`_others_ask_for_more`, looked at once for each file: it is asked in every configuration."""
    if not _latest or _latest[0][0] is not packages:
        _latest[:] = [(packages, {})]
    known = _latest[0][1]
    key = (name, near)
    if key not in known:
        known[key] = watched(lambda: _others_ask_for_more(name, home, packages, near))
    answer, looked = known[key]
    note(looked)
    return answer


def _others_ask_for_more(name: str, home: Package, packages: Packages, near: str) -> bool:
    """Whether other launch files of ``home`` ask ``name`` for what ``home`` has not: then there is such a package, elsewhere.

    From before a split a path may begin with the name of what is now ``home``.
    """
    listed = ((each, [file for file in found if file.endswith(_LAUNCH_ENDS)]) for each, found in walk(home.directory, _MOST_DIRECTORIES))
    inner = (f"{home.name}/", f"{posixpath.basename(home.directory)}/")
    programs = contents(packages).executables(home).names
    for file, text in texts(listed, _MOST_FILES, set()):
        if name in text and file != posixpath.abspath(near):
            asked = _asked(text)
            paths = [path for path, made in asked.files.get(name, ()) if not made]
            paths = [next((path.removeprefix(each) for each in inner if path.startswith(each)), path) for path in paths]
            types = [_TYPE.search(tag) for tag in asked.started.get(name, ())]
            if not all(exists(posixpath.join(home.directory, path)) for path in paths):
                return True
            if not all(each is None or each[1] in programs for each in types):
                return True
    return False


def lacks_all(package: Package, name: str, text: str) -> str:
    """The first file that a launch file with content ``text`` asks of the package ``name``, where ``package`` has none; else empty.

    Of a path that goes on with a substitution the directory counts.
    """
    asked = [posixpath.dirname(file) if made else file for file, made in _asked(text).files.get(name, ())]
    asked = [file for file in asked if file]
    return "" if any(exists(posixpath.join(package.directory, file)) for file in asked) else next(iter(asked), "")


class _Asked(NamedTuple):
    """What a launch file asks of each package: files (True: a substitution follows the name), and the start tags of its programs."""

    files: Mapping[str, Sequence[tuple[str, bool]]]
    started: Mapping[str, Sequence[str]]


@lru_cache(maxsize=256)  # each package that is not here is asked for in every configuration
def _asked(text: str) -> _Asked:
    files: dict[str, list[tuple[str, bool]]] = {}
    started: dict[str, list[str]] = {}
    for part in parse_again(text).substitutions("find"):
        behind = _BEHIND.match(text, part.end)
        if behind is not None:
            files.setdefault(part.only, []).append((behind[1], bool(behind[2])))
    for tag in _STARTED.finditer(text):
        package = _PKG.search(tag[0])
        if package is not None:
            started.setdefault(package[1], []).append(tag[0])
    return _Asked(files, started)
