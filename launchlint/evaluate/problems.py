"""What can be wrong with what a launch file comes to: one class for each kind of :class:`~launchlint.problem.Problem`."""

from __future__ import annotations

from launchlint.problem import Problem

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any, Literal

    from launchlint.model import Node
    from launchlint.source import Place

    NameFault = Literal["private", "slash", "empty", "characters"]


class EvaluationBound(Problem):
    """The file comes to more than anybody can work out; given up after so many ``elements``."""

    elements: int


# ---- substitutions and conditions


class BadSubstitution(Problem):
    """A substitution that roslaunch refuses; ``text`` is what is written."""

    reason: str
    text: str


class UnexpandedSubstitution(Problem):
    """What looks like a substitution and is none; ``extra`` says that it has one parenthesis too many, ``rosparam`` that it
    stands in YAML. ``words`` are those in it.
    """

    text: str
    extra: bool
    rosparam: bool = False
    words: tuple[str, ...] = ()


class EnvUnset(Problem):
    """An environment variable that is not set here."""

    variable: str

    @property
    def lacks(self) -> tuple[str, str]:
        """That environment variable."""
        return "the environment variable", self.variable


class PackageNotFound(Problem):
    """A package that is not here, looked for from the entry file ``near``."""

    package: str
    near: str

    @property
    def lacks(self) -> tuple[str, str]:
        """That package."""
        return "the package", self.package


class EvalError(Problem):
    """An expression that fails; ``known`` are the args that have a value."""

    reason: str
    expression: str
    known: tuple[str, ...]


class EvalNotCovered(Problem):
    """An expression whose value this check cannot tell."""

    reason: str


class EvalNeverEqual(Problem):
    """An arg compared with a text that it can never be equal to; ``negated``: it asks for the two to differ."""

    name: str
    literal: str
    negated: bool


class ConditionNotBoolean(Problem):
    """A condition whose ``value`` is no truth value; ``text`` is what is written."""

    attribute: str
    value: str
    text: str
    reason: str


class ConditionOnLaunch(Problem):
    """A substitution in a condition of ``<launch>``."""

    attribute: str
    text: str


# ---- args


class UndeclaredArg(Problem):
    """An arg that no declaration is in force for: ``known`` are those in scope, ``skipped`` its declarations under a false condition.

    ``entry`` says that it is read in the entry file, ``in_expression`` that an expression reads it, and not a substitution of its own.
    ``asked`` are the args that the conditions of ``skipped`` ask, with their values, as far as they are known. ``elsewhere`` are the
    places of the same file that set it always, and not where it is read (ROS 2).
    """

    name: str
    known: tuple[str, ...]
    entry: bool
    skipped: tuple[Place, ...]
    in_expression: bool
    asked: tuple[tuple[str, str], ...] = ()
    elsewhere: tuple[Place, ...] = ()

    def among(self, known: Iterable[str]) -> UndeclaredArg:
        """The same where other args are in scope."""
        return UndeclaredArg(**vars(self) | {"known": tuple(known)})

    @property
    def lacks(self) -> tuple[str, str]:
        """That arg."""
        return "the arg", self.name


class RequiredArgUnset(Problem):
    """An arg of the entry file without a value; ``empty``: it has a default, with nothing in it."""

    name: str
    empty: bool = False

    @property
    def lacks(self) -> tuple[str, str]:
        """That arg."""
        return "the arg", self.name


class UsedBeforeDeclaration(Problem):
    """An arg that is declared further down; ``cycle`` are the args that need each other, each with its declaration, if they do."""

    name: str
    cycle: tuple[tuple[str, Place], ...]


class ArgOutOfScope(Problem):
    """An arg that is declared in a group somewhere else."""

    name: str
    declaration: Place


class ArgRedeclared(Problem):
    """A second declaration of an arg in one scope."""

    name: str


class ArgOverrideRefused(Problem):
    """A value given for an arg that is fixed; ``by_include``: to the included ``file``, else on the command line."""

    name: str
    by_include: bool
    file: str = ""


# ---- includes


class IncludeNotFound(Problem):
    """An included ``file`` that cannot be read; ``environment``: its name is made from an environment variable."""

    file: str
    written: str
    reason: str
    environment: bool

    @property
    def lacks(self) -> tuple[str, str]:
        """That file."""
        return "the file", self.file.rsplit("/", 1)[-1]


class IncludeNotLoadable(Problem):
    """An included ``file`` that is no launch file; ``malformed``: not even XML. ``environment`` as above."""

    file: str
    reason: str
    environment: bool
    malformed: bool


class DeprecatedInclude(Problem):
    """An included ``file`` that calls itself deprecated, with this ``text``."""

    file: str
    text: str


class IncludeCycle(Problem):
    """Files that include each other; ``endless`` or only too deep: ``depth`` of them."""

    cycle: tuple[str, ...]
    endless: bool
    depth: int


class IncludeUndeclaredArg(Problem):
    """An arg passed to a file that does not declare it.

    ``file`` is the included one as shown, ``target`` as it was opened; ``known`` are the args it takes, ``undeclared`` all those that are
    passed for nothing.
    """

    name: str
    file: str
    known: tuple[str, ...]
    target: str
    undeclared: tuple[str, ...]


class PassAllHidesTypo(Problem):
    """The same where ``pass_all_args`` keeps roslaunch from saying so."""

    name: str
    file: str
    known: tuple[str, ...]
    target: str
    undeclared: tuple[str, ...]


class IncludeMissingArg(Problem):
    """An arg that the included ``file`` needs and does not get; ``passed`` are those it gets.

    ``empty`` as for :class:`RequiredArgUnset`.
    """

    name: str
    file: str
    passed: tuple[str, ...]
    target: str
    pass_all: bool
    empty: bool = False

    # ---- nodes, machines and names

    @property
    def lacks(self) -> tuple[str, str]:
        """That arg."""
        return "the arg", self.name


class InvalidNodeName(Problem):
    """A name that no node can have, ``from_test``: taken from that of the test; roslaunch refuses ``private`` and ``slash``."""

    name: str
    from_test: bool
    reason: NameFault


class InvalidNamespace(Problem):
    """A namespace that is none; roslaunch refuses a ``private`` one."""

    namespace: str
    private: bool


class DuplicateNode(Problem):
    """Two nodes of one ``name``; ``core``: the other one is roscore's own (``first`` is ``second`` then)."""

    name: str
    first: Node
    second: Node
    core: bool


class UnknownMachine(Problem):
    """A machine that nobody defines; ``known`` are those that are."""

    name: str
    known: tuple[str, ...]

    @property
    def lacks(self) -> tuple[str, str]:
        """That machine."""
        return "the machine", self.name


class MachineConflict(Problem):
    """A machine defined twice, with different ``fields``."""

    name: str
    fields: tuple[str, ...]


class UnbalancedQuotes(Problem):
    """A command line that no shell could split."""

    attribute: str
    reason: str


# ---- remaps


class RemapReplaced(Problem):
    """A remap inside a node that another one of the same source takes the place of, ``always`` or in this configuration."""

    key: str
    old: str
    new: str
    always: bool


class InvalidRemapName(Problem):
    """A name in a remap that roslaunch refuses."""

    attribute: str
    value: str
    reason: Literal["empty", "illegal"]


class DoubledSlash(Problem):
    """Two slashes in a name of a remap."""

    attribute: str
    value: str


# ---- params


class InvalidParamName(Problem):
    """A name that roslaunch sets and hardly anybody can ask for."""

    name: str


class GlobalParamInNode(Problem):
    """A global name inside a node, which becomes one below ``namespace``."""

    name: str
    namespace: str


class ParamReplaced(Problem):
    """A param of a node that is set twice in it, ``always`` or in this configuration."""

    name: str
    old: Any
    new: Any
    always: bool


class ParamValueType(Problem):
    """A value that does not fit its type; ``known``: the type is one."""

    value: str
    type: str
    known: bool
    reason: str


class ParamFileMissing(Problem):
    """A ``file`` that ``attribute`` names and that cannot be read because of ``reason``.

    ``shown`` is its path as people see it; ``missing`` says that there is no such file (else it is no readable text), ``relative``
    that the name is looked up where roslaunch is started, ``elsewhere`` that it lies in nothing that is here, ``environment`` that its name
    is made from an environment variable. ``near`` is the file that was probably meant, ``no_directory`` the directory that does not exist
    either (empty if it does).
    """

    attribute: str
    file: str
    reason: str
    shown: str
    missing: bool
    relative: bool
    elsewhere: bool
    environment: bool
    near: str | None
    no_directory: str

    @property
    def lacks(self) -> tuple[str, str]:
        """That file."""
        return "the file", self.file.rsplit("/", 1)[-1]


class ParamYamlInvalid(Problem):
    """YAML that cannot be loaded; ``in_file``: it stands in ``file``, else in the launch file. ``hint`` says which mistake it
    probably is.
    """

    reason: str
    hint: Literal["", "colon", "scalar"]
    in_file: bool
    file: str


class YamlDuplicateKey(Problem):
    """A key (its path, with ``/``) that stands twice in one mapping; ``same``: with the same value.

    ``anchored``: the first value has an anchor, by which it is used elsewhere.
    """

    key: str
    same: bool
    anchored: bool


class Ros2Parameters(Problem):
    """A parameter file made for ROS 2; ``name`` is one of the ``count`` params that come of it here."""

    name: str
    count: int
