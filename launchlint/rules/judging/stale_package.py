"""A package that is not here, while all that a launch file asks of it lies in its own package: a name from before a split or rename."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping, Sequence
from functools import lru_cache

from launchlint.late import late
from launchlint.library.shipped import Bundled
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.package_contents import contents
from launchlint.rules.judging.released import lacking
from launchlint.spelling import folded, one_slip
from launchlint.syntax.ros1.substitutions import parse_again
from launchlint.workspace.looking import content, exists, is_file, names
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.text_parts import LARGEST

_GENERATED = "_moveit_config"
"""What the Setup Assistant calls its packages."""
_LAUNCH_ENDS = (".launch", ".launch.xml", ".test")
_MOST_BESIDE = 100
_SHORTEST_SLIP = 6
"""Below this many letters most names are one slip away from some other name."""
_STARTED = late(r"<(?:node|test)\s[^<>]{1,2000}>")
_PKG = late(r"\spkg\s*=\s*[\"']([^\"']*)[\"']")
_TYPE = late(r"\stype\s*=\s*[\"']([^\"'$]*)[\"']")
_BEHIND = late(r"/([\w.+/-]+)(\$?)")


def own_instead(name: str, text: str, packages: Packages, near: str) -> Package | None:
    """The package of the launch file ``near`` with content ``text``, if it holds all files and programs that are asked of ``name``.

    A public package may well have files of the same names: then the own package must bear its name, and more (``camera_driver`` for
    ``camera``), and hold a program that is asked for, too. ``None`` where the package is here or declared, where nothing is asked of it
    that can be told, where it is one file only and no name has all words of the other, where another package of its family that is not here
    is asked for something else (both may lie in another repository), and where the file would include itself: it stands before one of the
    same name.
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
    if len(found) == 1 and not started and not _has_words_of(name, home.name):
        return None
    if any(_is_of_family(each, name) and not _holds(home, files) for each, files in asked.files.items() if not packages.has(each)):
        return None
    programs = contents(packages).executables(home).names if started else []
    types = [_TYPE.search(tag) for tag in started]
    return home if all(each is not None and each[1] in programs for each in types) else None


def _has_words_of(one: str, other: str) -> bool:
    """Whether one of two names has all words of the other: the same first word may be that of whoever made both."""
    words, others = set(folded(one).split("_")), set(folded(other).split("_"))
    return words <= others or others <= words


def _is_of_family(one: str, other: str) -> bool:
    """Whether two names have their first two words in common, and one more each, which is another."""
    words, others = folded(one).split("_"), folded(other).split("_")
    return words != others and min(len(words), len(others)) > 2 and words[:2] == others[:2]


def _holds(home: Package, files: Sequence[tuple[str, bool]]) -> bool:
    return all(exists(posixpath.join(home.directory, posixpath.dirname(file) if made else file)) for file, made in files)


def own_files_instead(name: str, text: str, home: Package, near: str) -> tuple[str, ...]:
    """The files that the launch file ``near`` with content ``text`` asks of the package ``name``, if ``home`` has all at the same paths.

    They were meant to be its own: the two packages are of one kind by the last word of their names (``arm_moveit_config``), nothing else
    is asked of the other one, here or in the launch files beside, and it is more than one file, or MoveIt's Setup Assistant wrote
    ``home`` from a template. A launch file that is one of them wraps the other one, and what else than such a template includes launch
    files of another package may need what these do. Empty where it is not so.
    """
    last, other = home.name.rpartition("_")[2], name.rpartition("_")[2]
    asked = _asked(text)
    found = asked.files.get(name, ())
    if last != other or "_" not in name or not found or asked.started.get(name) or text.count(name) != len(found):
        return ()
    files = tuple(dict.fromkeys(file for file, _ in found))
    paths = [posixpath.join(home.directory, file) for file in files]
    if any(made for _, made in found) or posixpath.abspath(near) in paths or not all(map(is_file, paths)):
        return ()
    if _asked_elsewhere(name, home, near):
        return ()
    from launchlint.rules.judging.left_out import SETUP_ASSISTANT

    if is_file(posixpath.join(home.directory, SETUP_ASSISTANT)):
        return files
    wraps = not home.name.endswith(_GENERATED) and any(file.endswith(_LAUNCH_ENDS) for file in files)
    return files if len(files) > 1 and not wraps else ()


def _asked_elsewhere(name: str, home: Package, near: str) -> bool:
    """Whether a launch file beside ``near`` asks the package ``name`` for a file that ``home`` has not: then it is needed all the same."""
    directory = posixpath.dirname(posixpath.abspath(near))
    for each in [each for each in names(directory) if each.endswith(_LAUNCH_ENDS)][:_MOST_BESIDE]:
        text = (content(posixpath.join(directory, each)) or b"")[:LARGEST].decode("utf-8", "replace")
        for file, made in _asked(text).files.get(name, ()) if name in text else ():
            if made or not exists(posixpath.join(home.directory, file)):
                return True
    return False


def own_by_a_slip(name: str, text: str, packages: Packages, near: str) -> Package | None:
    """The package of the workspaces from which the public ``name`` is one slip away, where it must be meant in the launch file ``near``.

    It must be, where no ``package.xml`` here declares the public one and it has all that the launch file with content ``text`` asks of the
    other, or nothing that is asked is there, the launch file is its own, and the public package was never released for what the workspace
    is for. A short name is one slip away from too many others.
    """
    if len(name) < _SHORTEST_SLIP or packages.has(name):
        return None
    local = [each for place in packages.places[: len(packages.workspaces)] for each in place.everything if not each.is_metapackage]
    slip = one_slip(name, {each.name for each in local if each.name})
    found = None if slip is None else packages.get(slip, near)
    if found is None or any(each.manifest is not None and name in each.manifest.depends() for each in local):
        return None
    asked = _asked(text)
    files, started = asked.files.get(name, ()), programs_asked(name, text)
    known = (Bundled().package(name) or {}).get("executables", ())
    if not started.isdisjoint(known):
        return None
    if (files or started) and _holds(found, files) and started <= set(contents(packages).executables(found).names):
        return found
    home = packages.package_of(near)
    if home is None or home.manifest is None or home.directory != found.directory or started:
        return None
    return found if lacking(name, home.manifest, packages).distributions else None


def lacks_all(package: Package, name: str, text: str) -> str:
    """The first file that a launch file with content ``text`` asks of the package ``name``, where ``package`` has none; else empty.

    Of a path that goes on with a substitution the directory counts.
    """
    asked = [posixpath.dirname(file) if made else file for file, made in _asked(text).files.get(name, ())]
    asked = [file for file in asked if file]
    return "" if any(exists(posixpath.join(package.directory, file)) for file in asked) else next(iter(asked), "")


def holds_some(package: Package, name: str, text: str) -> bool:
    """Whether ``package`` has a file that a launch file with content ``text`` asks of ``name``, or a directory of it far down."""
    for file, made in _asked(text).files.get(name, ()):
        directory = posixpath.dirname(file)
        if (file and not made and exists(posixpath.join(package.directory, file))) or (
            "/" in directory and exists(posixpath.join(package.directory, directory))
        ):
            return True
    return False


def programs_asked(name: str, text: str) -> set[str]:
    """The programs of the package ``name`` that a launch file with content ``text`` starts."""
    return {found[1] for tag in _asked(text).started.get(name, ()) if (found := _TYPE.search(tag)) is not None}


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
