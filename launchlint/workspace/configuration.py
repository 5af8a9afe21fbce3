"""``.launchlint.yaml``: what a project says about its checks.

Every key is validated; whatever is wrong is a :class:`ConfigurationError` with the file, line and column. Paths in the file are relative to
the directory it stands in.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from types import MappingProxyType

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.entries import Entry, arguments_of, entries_of, load_entries
from launchlint.workspace.repository import repository_root
from launchlint.workspace.ros2_distributions import DISTRIBUTIONS
from launchlint.workspace.yaml_nodes import SCALAR, Document, Node, read_document, shown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

FILE_NAME = ".launchlint.yaml"
SCHEMA_NAME = "configuration_schema.json"

SEVERITIES = ("error", "warning", "info")
COMPLETENESS = ("complete", "partial")
LINE_WIDTHS = range(40, 401)
INDENTS = range(1, 9)
FORMAT_KEYS = frozenset(("line-width", "indent", "sort-attributes", "sort-args"))

_EMPTY: Mapping[Any, Any] = MappingProxyType({})


class Configuration(NamedTuple):
    """All settings, with the defaults for whatever the file does not say.

    Args:
        path: the file they come from, as people see it; ``None`` for the defaults.
        directory: its directory, absolute; patterns are relative to it.
        workspace: directories to look for packages in, absolute; empty: found by themselves.
        library: library files, absolute.
        select: rules to run (names, ids or the start of an id); ``None``: those that are on by default.
        ignore: rules not to run.
        severity: rule → error, warning or info.
        per_file_ignores: pattern → rules not to run on the files that it matches.
        exclude: patterns of files and directories to leave out.
        entries: the launch files that people start, with their arguments (``file`` absolute); ``None``: found by themselves.
        baseline: file of findings that are known and not told, absolute.
        args: name of a profile → arguments that every entry is evaluated with, once per profile.
        env: environment variables that launch files see, over those of the process.
        packages: ``complete`` where every package the robot has can be seen here, ``partial`` where not; ``None``: found by itself.
        distro: the distribution of ROS 2 that launch files of it are for; ``None``: that of the environment, else as its files say.
        extract: whether the sources of the workspaces' own nodes are read.
        line_width: characters of a line that the formatter fills with a start tag, before each attribute gets a line of its own.
        indent: blanks per level that the formatter writes.
        sort_attributes: whether the formatter puts attributes in canonical order.
        sort_args: whether it moves args to the start of their block, where that is proved to change nothing.
        positions: key, or key and index or name → line and column (from 1) of what is written there, for errors that only upper
            rooms can find.
    """

    path: str | None = None
    directory: str | None = None
    workspace: tuple[str, ...] = ()
    library: tuple[str, ...] = ()
    select: tuple[str, ...] | None = None
    ignore: tuple[str, ...] = ()
    severity: Mapping[str, str] = _EMPTY
    per_file_ignores: Mapping[str, tuple[str, ...]] = _EMPTY
    exclude: tuple[str, ...] = ()
    entries: tuple[Entry, ...] | None = None
    baseline: str | None = None
    args: Mapping[str, Mapping[str, str]] = _EMPTY
    env: Mapping[str, str] = _EMPTY
    packages: str | None = None
    distro: str | None = None
    extract: bool = True
    line_width: int = 120
    indent: int = 2
    sort_attributes: bool = True
    sort_args: bool = False
    positions: Mapping[tuple[str | int, ...], tuple[int, int]] = _EMPTY

    def where(self, *keys: str | int) -> str:
        """``path:line:col`` of a setting, for the start of a message; the path alone where the position is not known."""
        position = self.positions.get(keys)
        path = self.path or FILE_NAME
        return path if position is None else f"{path}:{position[0]}:{position[1]}"


def schema_text() -> str:
    """The JSON Schema of the file."""
    with open(os.path.join(os.path.dirname(__file__), SCHEMA_NAME), encoding="utf-8") as file:
        return file.read()


def find_configuration(path: str) -> str | None:
    """The configuration file for the launch file or directory at ``path``: the nearest one upward, not beyond its repository; absolute."""
    path = os.path.abspath(path)
    directory = path if os.path.isdir(path) else os.path.dirname(path)
    root = repository_root(directory)
    while True:
        candidate = os.path.join(directory, FILE_NAME)
        if os.path.isfile(candidate):
            return candidate
        if directory in (root, os.path.dirname(directory)):
            return None
        directory = os.path.dirname(directory)


def load(path: str) -> Configuration:
    """Read a configuration file.

    Args:
        path: the file, as people shall see it in messages.

    Raises:
        ConfigurationError: it cannot be read, or something in it is not what it should be.
    """
    document = read_document(path)
    settings: dict[str, Any] = {"path": path, "directory": os.path.dirname(os.path.abspath(path))}
    positions: dict[tuple[str | int, ...], tuple[int, int]] = {}
    reader = _Reader(document, settings["directory"], positions)
    for key, key_node, value in [] if document.root is None else document.pairs(document.root, "the configuration"):
        read = _READERS.get(key)
        if read is None:
            document.unknown(key_node, _READERS, "the configuration")
        positions[(key,)] = (key_node.line, key_node.column)
        if not (value.kind == SCALAR and value.type == "null"):
            settings.update(read(reader, value))
    return Configuration(**settings, positions=MappingProxyType(positions))


class _Reader:
    """The keys of the file, one method each: node → the settings it makes."""

    def __init__(self, document: Document, directory: str, positions: dict[tuple[str | int, ...], tuple[int, int]]) -> None:
        self.document = document
        self.directory = directory
        self.positions = positions

    def _note(self, node: Node, *keys: str | int) -> None:
        self.positions[keys] = (node.line, node.column)

    def _listed(self, node: Node, *keys: str | int) -> tuple[str, ...]:
        listed = self.document.texts(node, str(keys[-1]))
        for number, (text, each) in enumerate(listed):
            self._note(each, *keys, number)
            if not text:
                self.document.fail(each, f"an item of {keys[-1]} is empty; remove it")
        return tuple(text for text, _ in listed)

    def _paths(self, node: Node, key: str) -> tuple[str, ...]:
        return tuple(os.path.normpath(os.path.join(self.directory, each)) for each in self._listed(node, key))

    def _one_of(self, node: Node, words: tuple[str, ...], what: str) -> str:
        from launchlint.spelling import did_you_mean

        word = self.document.text(node, what)
        if word not in words:
            hint = did_you_mean(word, words) or f"write one of them: {', '.join(words)}"
            self.document.fail(node, f"{what} cannot be {shown(word)}; {hint}")
        return word

    def workspace(self, node: Node) -> dict[str, Any]:
        for text, each in self.document.texts(node, "workspace"):
            place = os.path.join(self.directory, text)
            if text and not os.path.isdir(place):
                self.document.fail(
                    each, f"there is no directory {shown(text)}, so no package can be found in it; correct the path or remove it"
                )
            if text and self.directory != os.sep and os.path.realpath(place) == os.sep:
                self.document.fail(
                    each, f"{shown(text)} is the whole disk, which takes too long to look through; name the directory of the packages"
                )
        return {"workspace": self._paths(node, "workspace")}

    def library(self, node: Node) -> dict[str, Any]:
        return {"library": self._paths(node, "library")}

    def baseline(self, node: Node) -> dict[str, Any]:
        text = self.document.text(node, "baseline")
        if not text:
            self.document.fail(node, "baseline is empty; name a file, or remove the key")
        return {"baseline": os.path.normpath(os.path.join(self.directory, text))}

    def select(self, node: Node) -> dict[str, Any]:
        return {"select": self._listed(node, "select")}

    def ignore(self, node: Node) -> dict[str, Any]:
        return {"ignore": self._listed(node, "ignore")}

    def exclude(self, node: Node) -> dict[str, Any]:
        return {"exclude": self._listed(node, "exclude")}

    def severity(self, node: Node) -> dict[str, Any]:
        found: dict[str, str] = {}
        for rule, key, value in self.document.pairs(node, "severity"):
            self._note(key, "severity", rule)
            found[rule] = self._one_of(value, SEVERITIES, f"the severity of {shown(rule)}")
        return {"severity": MappingProxyType(found)}

    def per_file_ignores(self, node: Node) -> dict[str, Any]:
        found: dict[str, tuple[str, ...]] = {}
        for pattern, key, value in self.document.pairs(node, "per-file-ignores"):
            self._note(key, "per-file-ignores", pattern)
            found[pattern] = self._listed(value, "per-file-ignores", pattern)
        return {"per_file_ignores": MappingProxyType(found)}

    def entries(self, node: Node) -> dict[str, Any]:
        found: list[Entry] = []
        for number, (entry, each) in enumerate(zip(entries_of(self.document, node), node.items, strict=True)):
            self._note(each, "entries", number)
            file = os.path.normpath(os.path.join(self.directory, entry.file))
            if not os.path.isfile(file):
                self.document.fail(
                    each, f"there is no launch file {shown(entry.file)}, so it cannot be checked; correct the path or remove the entry"
                )
            judged_as = None if entry.as_ is None else os.path.normpath(os.path.join(self.directory, entry.as_))
            found.append(Entry(file, judged_as, entry.arguments))
        return {"entries": tuple(found)}

    def args(self, node: Node) -> dict[str, Any]:
        found: dict[str, Mapping[str, str]] = {}
        for profile, key, value in self.document.pairs(node, "args"):
            self._note(key, "args", profile)
            if value.kind == SCALAR and value.type != "null":
                self.document.fail(
                    value,
                    f"args are grouped in profiles, so {shown(profile)} must be a mapping; put it under a name, such as default",
                )
            found[profile] = MappingProxyType(arguments_of(self.document, value))
        return {"args": MappingProxyType(found)}

    def env(self, node: Node) -> dict[str, Any]:
        found: dict[str, str] = {}
        for name, key, value in self.document.pairs(node, "env"):
            if not name or "=" in name or "\0" in name:
                self.document.fail(key, f"an environment variable cannot be called {shown(name)}; remove the = or the empty name")
            found[name] = self.document.text(value, f"the environment variable {shown(name)}")
        return {"env": MappingProxyType(found)}

    def packages(self, node: Node) -> dict[str, Any]:
        return {"packages": self._one_of(node, COMPLETENESS, "packages")}

    def distro(self, node: Node) -> dict[str, Any]:
        return {"distro": self._one_of(node, DISTRIBUTIONS, "distro")}

    def extract(self, node: Node) -> dict[str, Any]:
        return {"extract": self._one_of(node, ("true", "false"), "extract") == "true"}

    def format(self, node: Node) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for key, key_node, value in self.document.pairs(node, "format"):
            if key == "line-width":
                found["line_width"] = self._number(value, LINE_WIDTHS, key)
            elif key == "indent":
                found["indent"] = self._number(value, INDENTS, key)
            elif key in ("sort-attributes", "sort-args"):
                found[key.replace("-", "_")] = self._one_of(value, ("true", "false"), key) == "true"
            else:
                self.document.unknown(key_node, FORMAT_KEYS, "format")
        return found

    def _number(self, node: Node, allowed: range, what: str) -> int:
        text = self.document.text(node, what)
        number = int(text) if text.isascii() and text.isdecimal() and len(text) < 10 else -1
        if number not in allowed:
            self.document.fail(node, f"{what} must be a whole number from {allowed[0]} to {allowed[-1]}, not {shown(text)}")
        return number


_READERS = {
    "workspace": _Reader.workspace,
    "library": _Reader.library,
    "select": _Reader.select,
    "ignore": _Reader.ignore,
    "severity": _Reader.severity,
    "per-file-ignores": _Reader.per_file_ignores,
    "exclude": _Reader.exclude,
    "baseline": _Reader.baseline,
    "entries": _Reader.entries,
    "args": _Reader.args,
    "env": _Reader.env,
    "packages": _Reader.packages,
    "distro": _Reader.distro,
    "extract": _Reader.extract,
    "format": _Reader.format,
}

KEYS = tuple(_READERS)
"""Every key the file may have."""

__all__ = ["KEYS", "Configuration", "Entry", "find_configuration", "load", "load_entries"]
