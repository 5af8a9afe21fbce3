"""Where things lie: packages, executables, the files that values name."""

from __future__ import annotations

import os
import re

from launchlint.ide.view import View
from launchlint.workspace.executables import ExecutableIndex

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.ide.mention import Mention
    from launchlint.workspace.package import Package


def package_of(view: View, name: str) -> Package | None:
    """The package that a launch file gets by this name."""
    packages = view.snapshot.packages if view.dialect.name == "ros1" else view.snapshot.packages.colcon
    return packages.get(name, view.file)


def program_file(view: View, package: str, name: str) -> str | None:
    """The source or script of an executable, where it is here."""
    home = package_of(view, package)
    if home is None:
        return None
    found = view.snapshot.packages.once(ExecutableIndex).executables(home).by_name.get(name)
    if found is not None and found.path is not None and os.path.isfile(found.path):
        return found.path
    for directory in ("scripts", "nodes", "src", home.name, "bin", "src/nodes", f"src/{home.name}"):
        for end in ("", ".py", ".cpp", ".cc"):
            path = os.path.join(home.directory, directory, name + end)
            if os.path.isfile(path):
                return path
    return None


def file_named(view: View, mention: Mention) -> str | None:
    """The file that a value names in the first configuration that reads it."""
    for include in view.includes_of(mention.item):
        if include.source is not None:
            return os.path.abspath(include.source.file)
    return resolved(view, mention.name)


def resolved(view: View, text: str) -> str | None:
    """The file that ``text`` names, with packages, args and the file's directory put in; None where there is none."""
    directory = os.path.dirname(view.file)

    def instead(match: re.Match[str]) -> str:
        command, _, word = match[1].partition(" ")
        word = word.strip().strip("'\"")
        if command in ("find", "find-pkg-share"):
            home = package_of(view, word)
            return "\0" if home is None else home.directory
        if command == "dirname":
            return directory
        if command in ("arg", "var"):
            value = next(iter(arg_values(view, word)), None)
            return "\0" if value is None else value
        return "\0"

    path = re.sub(r"\$\(([^()$]*)\)", instead, text)
    if "\0" in path or "$" in path or not path:
        return None
    path = os.path.normpath(os.path.join(directory, path))
    return path if os.path.isfile(path) else None


def arg_values(view: View, name: str) -> dict[str, list[str]]:
    """The values that an arg has in this file → how each comes about, in the order of configurations."""
    found: dict[str, list[str]] = {}
    for configuration in view.configurations:
        evaluation = configuration.evaluation
        given = " ".join(f"{key}:={value}" for key, value in evaluation.launch.given)
        if evaluation.entered:
            for each in evaluation.entered:
                if each.path == view.shown and name in each.arguments:
                    value = each.arguments[name]
                    way = "" if each.step is None else evaluation.launch.entry.path
                    _note(found, value if isinstance(value, str) else f"not known: {value.reason}", " ".join(filter(None, (way, given))))
            continue
        for argument in view.declarations(name):
            known = argument.default if argument.value is None else argument.value
            if known is not None:
                _note(found, known if isinstance(known, str) else f"not known: {known.reason}", given)
    return found


def _note(found: dict[str, list[str]], value: str, way: str) -> None:
    ways = found.setdefault(value, [])
    if way not in ways:
        ways.append(way)
