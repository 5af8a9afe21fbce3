"""What a rule sees: one view per kind of question, and nothing else."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Mapping
from functools import cached_property
from types import MappingProxyType

from launchlint.dialects.door import named
from launchlint.dialects.record import Dialect
from launchlint.finding import Finding, Location
from launchlint.fix.format.style import Style
from launchlint.model import ROS2, Launch
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import Place, Source
from launchlint.syntax.tree import Document
from launchlint.workspace.packages import Packages

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeVar

    from launchlint.graph.connections import ConnectionGraph, Instance
    from launchlint.graph.difference import Difference
    from launchlint.graph.earlier import Earlier
    from launchlint.library.lookup import Library
    from launchlint.suppression import Suppression

    T = TypeVar("T")
    Kind = TypeVar("Kind", bound=Problem)


def tried(launch: Launch) -> str:
    """The args of ``launch`` with a default that only the search for configurations gave another value: ``sim:=true``.

    In ROS 2 these may be args of included files.
    """
    if not launch.given:
        return ""
    steered: frozenset[str] = frozenset().union(*(branch.steered_by for branch in launch.branches))
    free = {each.name for each in launch.declared if each.origin.step is None and not each.passed and each.default is not None}
    own = {each.argument.name for each in launch.declarations if each.argument.origin.step is None}
    free |= {each.argument.name for each in launch.declarations if each.has_default and each.argument.name not in own}
    return " ".join(f"{name}:={value}" for name, value in launch.given if name in steered and name in free)


def of_ros2(view: object) -> bool:
    """Whether a view is one of launch files of ROS 2."""
    return isinstance(view, (FileView, LaunchView)) and view.dialect.name == ROS2


class FileView:
    """The syntax view: one launch file as it is written, the packages around it, and what the project's normal form is like.

    ``dialect`` is the one that it was read in. ``named_by``: the file that names the distribution of ROS 2 that it is read for, if any.
    """

    def __init__(self, document: Document, packages: Packages, style: Style, dialect: Dialect, named_by: str) -> None:
        self.document = document
        self.packages = packages
        self.style = style
        self.dialect = dialect
        self.named_by = named_by
        self._worked_out: dict[object, Any] = {}

    def once(self, work: Callable[[FileView], T]) -> T:
        """What ``work`` makes of the view: worked out for the first rule that asks, and kept for the others."""
        if work not in self._worked_out:
            self._worked_out[work] = work(self)
        made: T = self._worked_out[work]
        return made


class LaunchView:
    """The launch view: what one entry file starts in one configuration.

    ``declared_entry``: the configuration file says how it is started. ``documents`` are the launch files it reached, by path. ``told`` is
    what rules have said of the problems of the launch, by identity of the problem and ID of the rule.
    """

    def __init__(
        self, launch: Launch, packages: Packages, declared_entry: bool, documents: Mapping[str, Document] = MappingProxyType({})
    ) -> None:
        self.launch = launch
        self.packages = packages
        self.declared_entry = declared_entry
        self.documents = documents
        self.told: dict[tuple[int, str], tuple[Finding, ...]] = {}
        self._worked_out: dict[object, Any] = {}

    def once(self, work: Callable[[LaunchView], T]) -> T:
        """What ``work`` makes of the view: worked out for the first that asks, and kept for the others."""
        if work not in self._worked_out:
            self._worked_out[work] = work(self)
        made: T = self._worked_out[work]
        return made

    @property
    def dialect(self) -> Dialect:
        """The one of the entry file."""
        return named(self.launch.dialect)

    @cached_property
    def node_names(self) -> frozenset[str]:
        """The names of all nodes and tests, without their namespaces."""
        return frozenset(node.name for node in (*self.launch.nodes, *self.launch.tests))

    @cached_property
    def tried(self) -> str:
        """The args with a default that only the search for configurations gave another value: ``sim:=true``."""
        return tried(self.launch)

    @cached_property
    def _problems(self) -> Mapping[Place, list[Problem]]:
        found: dict[Place, list[Problem]] = {}
        for problem in self.launch.problems:
            found.setdefault(problem.place, []).append(problem)
        return found

    @cached_property
    def included_by(self) -> Mapping[Source, frozenset[str]]:
        """The files (absolute) that the includes of each file enter; nothing of a file without any."""
        found: dict[Source, set[str]] = {}
        for each in self.launch.includes:
            if each.source is not None:
                found.setdefault(each.origin.place.source, set()).add(posixpath.abspath(each.source.file))
        return {source: frozenset(files) for source, files in found.items()}

    def beside(self, problem: Kind) -> list[Kind]:
        """The problems of the same kind and origin, in order; ``problem`` is one of them."""
        return [each for each in self._problems.get(problem.place, ()) if isinstance(each, type(problem)) and each.origin == problem.origin]

    @cached_property
    def started_in(self) -> Mapping[tuple[str, int], bool]:
        """The elements that nodes are started in, by file and offset: groups, includes, and the nodes themselves.

        True where a program that need not be a Python script is among them: any executable that does not end in ``.py``, and what an
        include would start that cannot be followed.
        """
        found: dict[tuple[str, int], bool] = {}
        unseen = ((each.origin, each.scope, True) for each in self.launch.includes if each.source is None)
        nodes = ((each.origin, each.scope, not each.executable.endswith(".py")) for each in (*self.launch.nodes, *self.launch.tests))
        for origin, scope, other in (*nodes, *unseen):
            place, around = origin.place, scope
            while found.get(key := place.key) not in (True, other):
                found[key] = other
                if around is None:
                    break
                place, around = around.origin.place, around.parent
        return found


class GraphView:
    """The graph view: who talks to whom in what one entry file starts in one configuration; else as :class:`LaunchView`."""

    def __init__(
        self,
        graph: ConnectionGraph,
        library: Library,
        packages: Packages,
        declared_entry: bool,
        documents: Mapping[str, Document],
        earlier: Earlier,
    ) -> None:
        self.graph = graph
        self.library = library
        self.packages = packages
        self.declared_entry = declared_entry
        self.documents = documents
        self._earlier = earlier
        self._worked_out: dict[object, Any] = {}

    @property
    def launch(self) -> Launch:
        """What is started."""
        return self.graph.launch

    @property
    def dialect(self) -> Dialect:
        """The one of the entry file."""
        return named(self.graph.launch.dialect)

    def once(self, work: Callable[[GraphView], T]) -> T:
        """What ``work`` makes of the view: worked out for the first rule that asks, and kept for the others."""
        if work not in self._worked_out:
            self._worked_out[work] = work(self)
        made: T = self._worked_out[work]
        return made

    def fact(self, instance: Instance, work: Callable[[Instance, Library], T]) -> T:
        """What ``work`` makes of a node and the library, and of nothing else: kept for other rules, and configurations with that node."""
        return self._earlier.fact(instance, work, self.library)


class BaseView(NamedTuple):
    """The base view: what changed in the connections of one entry file since the revision ``base``, all configurations joined.

    ``graphs`` are those of today.
    """

    base: str
    difference: Difference
    graphs: tuple[ConnectionGraph, ...]


class BrokenCall(NamedTuple):
    """An include that passes (``missing`` false) args its target does not declare, or does not pass one it requires.

    ``name`` is that of the arg, or the names of all that it should not pass, as roslaunch lists them (``a, b``). ``known`` are the args
    that the target of such ones declares.
    """

    target: str
    name: str
    missing: bool
    location: Location
    known: tuple[str, ...] = ()


class EntrySummary(NamedTuple):
    """What is left of an evaluated entry file when all have been evaluated; paths as shown.

    ``needs_caller``: it does not load alone, because args are missing that an including file or the command line would give;
    ``undeclared_args``: it reads args that it does not even declare. ``calls`` are its includes as it is started without args: the path
    of the included file, and the args that are passed with a value that is known. ``launcher`` starts it.
    """

    path: str
    refused: bool
    included: tuple[str, ...]
    broken_calls: tuple[BrokenCall, ...]
    roots: tuple[tuple[str, Location], ...]
    needs_caller: bool = False
    undeclared_args: bool = False
    calls: tuple[tuple[str, tuple[tuple[str, str], ...]], ...] = ()
    launcher: str = "roslaunch"


class RunView(NamedTuple):
    """The workspace view: all entry files of the run, and the directory (``root``) that shown paths are relative to.

    ``asked`` are the files and directories that people asked for, absolute; empty for all.
    """

    entries: tuple[EntrySummary, ...]
    packages: Packages
    root: str = ""
    asked: tuple[str, ...] = ()

    def is_asked(self, directory: str) -> bool:
        """Whether ``directory`` lies in what was asked for, or holds a file or directory of it."""
        return not self.asked or any((f"{directory}/").startswith(f"{path}/") or path.startswith(f"{directory}/") for path in self.asked)


class SuppressionView(NamedTuple):
    """All suppressions of the run.

    ``used`` holds each suppression with each name in it that suppressed something; ``resolve`` gives the ID for an ID or name; ``on``
    are the IDs of the rules that ran; ``names`` the names of all rules.
    """

    suppressions: tuple[Suppression, ...]
    used: frozenset[tuple[Suppression, str]]
    resolve: Callable[[str], str | None]
    on: frozenset[str]
    names: tuple[str, ...]
