"""What to probe, and how: the YAML file that ``launchlint probe`` reads.

Every key and value is validated; whatever is wrong is a :class:`ConfigurationError` with the file, line and column.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from types import MappingProxyType

from launchlint.named_tuple import NamedTuple
from launchlint.probe.words import MEANT, is_a, repository_url
from launchlint.words import split_words
from launchlint.workspace.yaml_nodes import MAPPING, SCALAR, SEQUENCE, Document, Node, read_document, shown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

DEFAULT_BASE = "debian:bookworm"
MOST_ITEMS = 10_000
LONGEST_TEXT = 100_000
NETWORKS = ("default", "host")

_EMPTY: Mapping[Any, Any] = MappingProxyType({})

TIMES = {"quiet": (0.1, 60.0), "limit": (1.0, 600.0), "total": (10.0, 86_400.0), "build": (10.0, 86_400.0)}
"""The limits that are seconds: least and most."""
COUNTS = {"jobs": range(1, 65), "pids": range(16, 100_001)}


class Repository(NamedTuple):
    """A git repository: its URL and the ref to check out."""

    url: str
    ref: str


class LaunchFile(NamedTuple):
    """A launch file to probe: ``package/path``, and the args it is started with."""

    file: str
    args: Mapping[str, str]


class Limits(NamedTuple):
    """Bounds, times in seconds.

    Args:
        quiet: a node is ready when nothing new came for so long.
        limit: it is stopped after so long.
        jobs: nodes that run at once.
        memory: of the container, as Docker writes it.
        pids: processes in the container.
        total: the container is stopped after so long.
        build: so is the building of one package.
    """

    quiet: float = 1.0
    limit: float = 15.0
    jobs: int = 2
    memory: str = "2g"
    pids: int = 512
    total: float = 7200.0
    build: float = 900.0

    @property
    def bytes(self) -> int:
        """``memory`` in bytes."""
        return int(self.memory[:-1]) * (2**30 if self.memory.endswith("g") else 2**20)


class ProbeConfiguration(NamedTuple):
    """All settings.

    Args:
        path: the file, as people see it.
        base: the image that is built upon.
        network: of the build: Docker's default one, or the host's.
        repositories: to clone.
        paths: local checkouts, absolute.
        apt: further apt packages.
        pip: further packages from PyPI.
        packages: the ROS packages to probe; empty: those of the sources, or all where there are no sources.
        everything: probe all packages that can be seen, also installed ones.
        programs: the programs to probe, of all those in the packages; empty: all.
        skip: packages and programs to leave out.
        nodes: program → settings, as the program in the container reads them.
        launch: launch files to probe.
        limits: bounds.
    """

    path: str = ""
    base: str = DEFAULT_BASE
    network: str = "default"
    repositories: tuple[Repository, ...] = ()
    paths: tuple[str, ...] = ()
    apt: tuple[str, ...] = ()
    pip: tuple[str, ...] = ()
    packages: tuple[str, ...] = ()
    everything: bool = False
    programs: tuple[str, ...] = ()
    skip: tuple[str, ...] = ()
    nodes: Mapping[str, Mapping[str, Any]] = _EMPTY
    launch: tuple[LaunchFile, ...] = ()
    limits: Limits = Limits()


def load(path: str) -> ProbeConfiguration:
    """Read a probe's configuration.

    Raises:
        ConfigurationError: it cannot be read, or something in it is not what it should be.
    """
    return read(read_document(path), os.path.dirname(os.path.abspath(path)))


def read(document: Document, directory: str) -> ProbeConfiguration:
    """The settings in a document; paths in it are relative to ``directory``. Raises ConfigurationError."""
    reader = _Reader(document, directory)
    settings: dict[str, Any] = {"path": document.path}
    for key, key_node, value in [] if document.root is None else document.pairs(document.root, "the configuration"):
        read_key = _READERS.get(key)
        if read_key is None:
            document.unknown(key_node, _READERS, "the configuration")
        if not (value.kind == SCALAR and value.type == "null"):
            settings.update(read_key(reader, value))
    return ProbeConfiguration(**settings)


class _Reader:
    """The keys of the file, one method each: node → the settings it makes."""

    def __init__(self, document: Document, directory: str) -> None:
        self.document = document
        self.directory = directory

    def _word(self, node: Node, kind: str, what: str) -> str:
        text = self.document.text(node, what)
        if not is_a(kind, text):
            self.document.fail(node, f"{what} cannot be {shown(text)}: write {MEANT[kind]}")
        return text

    def _words(self, node: Node, kind: str, what: str) -> tuple[str, ...]:
        if node.kind == MAPPING:
            self.document.fail(node, f"{what} must be a list, not a mapping")
        items = [node] if node.kind == SCALAR else node.items
        return tuple(self._word(each, kind, f"an item of {what}") for each in items)

    def base(self, node: Node) -> dict[str, Any]:
        return {"base": self._word(node, "base", "base")}

    def network(self, node: Node) -> dict[str, Any]:
        return {"network": self._one_of(node, NETWORKS, "network")}

    def _one_of(self, node: Node, words: tuple[str, ...], what: str) -> str:
        from launchlint.spelling import did_you_mean

        word = self.document.text(node, what)
        if word not in words:
            hint = did_you_mean(word, words) or f"write one of them: {', '.join(words)}"
            self.document.fail(node, f"{what} cannot be {shown(word)}; {hint}")
        return word

    def repositories(self, node: Node) -> dict[str, Any]:
        if node.kind != SEQUENCE:
            self.document.fail(node, f"repositories must be a list, not {node.describe()}")
        repositories, paths = [], []
        for item in node.items:
            found = self._members(item, "a repository", ("url", "ref", "path"))
            if "path" in found:
                other = next((found[key] for key in ("url", "ref") if key in found), None)
                if other is not None:
                    self.document.fail(other, "a repository has either `path`, a local checkout, or `url` and `ref`")
                paths.append(self._path(found["path"]))
                continue
            if "url" not in found:
                self.document.fail(item, "a repository needs `url` (owner/name or a URL) and `ref`, or `path`: which is it?")
            if "ref" not in found:
                self.document.fail(
                    item, "a repository needs `ref`, a branch, tag or commit: default branches change, and many are for ROS 2 by now"
                )
            text = self.document.text(found["url"], "url")
            url = repository_url(text)
            if url is None:
                self.document.fail(
                    found["url"],
                    f"url cannot be {shown(text)}: write owner/name (of GitHub), or an https, ssh, git or file URL without a password",
                )
            repositories.append(Repository(url, self._word(found["ref"], "ref", "ref")))
        return {"repositories": tuple(repositories), "paths": tuple(paths)}

    def _path(self, node: Node) -> str:
        text = self.document.text(node, "path")
        path = os.path.normpath(os.path.join(self.directory, text))
        if "\0" in text or not os.path.isdir(path):
            self.document.fail(node, f"there is no directory {shown(text)}; paths are relative to this file")
        return path

    def _members(self, node: Node, what: str, known: tuple[str, ...]) -> dict[str, Node]:
        found = {}
        for key, key_node, value in self.document.pairs(node, what):
            if key not in known:
                self.document.unknown(key_node, frozenset(known), what)
            if not (value.kind == SCALAR and value.type == "null"):
                found[key] = value
        return found

    def apt(self, node: Node) -> dict[str, Any]:
        return {"apt": self._words(node, "apt", "apt")}

    def pip(self, node: Node) -> dict[str, Any]:
        return {"pip": self._words(node, "pip", "pip")}

    def packages(self, node: Node) -> dict[str, Any]:
        if node.kind == SCALAR and node.text == "all":
            return {"everything": True}
        return {"packages": tuple(dict.fromkeys(self._words(node, "package", "packages")))}

    def programs(self, node: Node) -> dict[str, Any]:
        return {"programs": tuple(dict.fromkeys(self._words(node, "program", "programs")))}

    def skip(self, node: Node) -> dict[str, Any]:
        found = []
        for text, each in self.document.texts(node, "skip"):
            if not is_a("package", text) and not is_a("program", text):
                self.document.fail(each, f"skip cannot hold {shown(text)}: write a package or {MEANT['program']}")
            found.append(text)
        return {"skip": tuple(found)}

    def nodes(self, node: Node) -> dict[str, Any]:
        found: dict[str, Mapping[str, Any]] = {}
        for label, key, value in self.document.pairs(node, "nodes"):
            if not is_a("program", label):
                self.document.fail(key, f"nodes cannot have {shown(label)}: write {MEANT['program']}")
            settings = self._settings(value, f"the node {shown(label)}", (*_SETTINGS, "variants"))
            found[label] = MappingProxyType(settings)
        return {"nodes": MappingProxyType(found)}

    def _settings(self, node: Node, what: str, known: tuple[str, ...]) -> dict[str, Any]:
        settings: dict[str, Any] = {}
        for key, value in self._members(node, what, known).items():
            settings[key] = self._variants(value) if key == "variants" else _ALL_SETTINGS[key](self, value)
        return settings

    def _variants(self, node: Node) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for name, key, value in self.document.pairs(node, "variants"):
            if not is_a("variant", name):
                self.document.fail(key, f"a variant cannot be called {shown(name)}: write {MEANT['variant']}")
            settings = self._settings(value, f"the variant {shown(name)}", (*_SETTINGS, "match"))
            if name != "default" and "match" not in settings and not settings.get("params"):
                self.document.fail(
                    key,
                    f"the variant {shown(name)} sets no params, so say by `match` (a condition of the library format) "
                    "when it is the one that runs",
                )
            found[name] = settings
        return found

    def args(self, node: Node) -> str:
        text = self.document.text(node, "args")
        try:
            words = split_words(text)
        except ValueError as error:
            self.document.fail(node, f"args cannot be split into words: {str(error).lower()}")
        if "\0" in text or len(text) > LONGEST_TEXT or len(words) > MOST_ITEMS:
            self.document.fail(node, "args are too long, or hold a null character")
        return text

    def params(self, node: Node) -> dict[str, Any]:
        found = {}
        for name, key, value in self.document.pairs(node, "params"):
            if not is_a("param", name):
                self.document.fail(key, f"a param cannot be called {shown(name)}: write {MEANT['param']}")
            found[name] = self._plain(value)
        return found

    def _plain(self, node: Node) -> Any:
        """A YAML value as JSON has it, read by the rules of YAML 1.1 as roslaunch's ``<rosparam>`` reads it."""
        if node.kind == SEQUENCE:
            return [self._plain(each) for each in node.items]
        if node.kind == MAPPING:
            return {key: self._plain(value) for key, _, value in self.document.pairs(node, "a param")}
        if node.type == "null":
            self.document.fail(node, "a param has no value; write one, or '' for an empty text")
        if node.type in ("bool", "int", "float"):
            import yaml

            value = yaml.safe_load(node.text)
            if isinstance(value, float) and not math.isfinite(value):
                self.document.fail(node, f"a param cannot be {shown(node.text)}: XML-RPC has no such number")
            if isinstance(value, int) and not isinstance(value, bool) and not -(2**31) <= value < 2**31:
                self.document.fail(node, f"a param cannot be {shown(node.text)}: whole numbers have 32 bits in ROS")
            return value
        return node.text

    def env(self, node: Node) -> dict[str, str]:
        return self._texts(node, "env", "variable", "an environment variable")

    def remap(self, node: Node) -> dict[str, str]:
        found = self._texts(node, "remap", "name", "a remapped name")
        for _, _, value in self.document.pairs(node, "remap"):
            self._word(value, "name", "the target of a remap")
        return found

    def files(self, node: Node) -> dict[str, str]:
        return self._texts(node, "files", "file", "a file")

    def _texts(self, node: Node, key: str, kind: str, what: str) -> dict[str, str]:
        found = {}
        for name, key_node, value in self.document.pairs(node, key):
            if not is_a(kind, name):
                self.document.fail(key_node, f"{what} cannot be called {shown(name)}: write {MEANT[kind]}")
            found[name] = self.document.text(value, f"{what} {shown(name)}")
            if "\0" in found[name] or len(found[name]) > LONGEST_TEXT:
                self.document.fail(value, f"{what} is too long, or holds a null character")
        return found

    def match(self, node: Node) -> Any:
        from launchlint.library.validate import faults

        condition = self._plain(node)
        probe = {"default": {"match": condition}}
        document = {"format": "launchlint-library", "version": 1, "packages": {"p": {"executables": {"e": {"variants": probe}}}}}
        for fault in faults(document)[:1]:
            self.document.fail(node, f"match is no condition: {fault.message}")
        return condition

    def quiet(self, node: Node) -> float:
        return self._seconds(node, "quiet")

    def limit(self, node: Node) -> float:
        return self._seconds(node, "limit")

    def _seconds(self, node: Node, key: str) -> float:
        text = self.document.text(node, key)
        least, most = TIMES[key]
        try:
            value = float(text) if len(text) < 20 else math.nan
        except ValueError:
            value = math.nan
        if not least <= value <= most:
            self.document.fail(node, f"{key} must be a number of seconds from {least:g} to {most:g}, not {shown(text)}")
        return value

    def launch(self, node: Node) -> dict[str, Any]:
        if node.kind != SEQUENCE:
            self.document.fail(node, f"launch must be a list, not {node.describe()}")
        found = []
        for item in node.items:
            if item.kind == SCALAR:
                found.append(LaunchFile(self._word(item, "launch", "a launch file"), _EMPTY))
                continue
            members = self._members(item, "a launch file", ("file", "args"))
            if "file" not in members:
                self.document.fail(item, f"a launch file needs `file`: {MEANT['launch']}")
            args = self._texts(members["args"], "args", "arg", "an arg") if "args" in members else {}
            found.append(LaunchFile(self._word(members["file"], "launch", "file"), MappingProxyType(args)))
        return {"launch": tuple(found)}

    def limits(self, node: Node) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for key, value in self._members(node, "limits", Limits._fields).items():
            if key in TIMES:
                found[key] = self._seconds(value, key)
            elif key == "memory":
                found[key] = self._word(value, "memory", "memory")
            else:
                text = self.document.text(value, key)
                number = int(text) if text.isascii() and text.isdecimal() and len(text) < 10 else -1
                if number not in COUNTS[key]:
                    self.document.fail(value, f"{key} must be a whole number from {COUNTS[key][0]} to {COUNTS[key][-1]}, not {shown(text)}")
                found[key] = number
        return {"limits": Limits(**found)}


_SETTINGS: Mapping[str, Callable[[_Reader, Node], Any]] = {
    "args": _Reader.args,
    "params": _Reader.params,
    "env": _Reader.env,
    "remap": _Reader.remap,
    "files": _Reader.files,
    "quiet": _Reader.quiet,
    "limit": _Reader.limit,
}
"""What can be set for one node. A variant also has ``match``."""
_ALL_SETTINGS = {**_SETTINGS, "match": _Reader.match}

_READERS: Mapping[str, Callable[[_Reader, Node], dict[str, Any]]] = {
    "base": _Reader.base,
    "network": _Reader.network,
    "repositories": _Reader.repositories,
    "apt": _Reader.apt,
    "pip": _Reader.pip,
    "packages": _Reader.packages,
    "programs": _Reader.programs,
    "skip": _Reader.skip,
    "nodes": _Reader.nodes,
    "launch": _Reader.launch,
    "limits": _Reader.limits,
}
