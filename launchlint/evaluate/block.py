"""What one launch file contributes when it is entered with given args in a given namespace.

A block knows nothing of who includes it: its origins have no include chain beyond its own includes, its nodes carry only the remaps and
settings of its own file. So a block can be worked out once and used wherever the file is entered in the same way; :mod:`.assemble` joins
the blocks of one entry file into a :class:`~launchlint.model.Launch`.
"""

from __future__ import annotations

import os

from launchlint.model import (
    Argument,
    Condition,
    EnvironmentSetting,
    Include,
    Machine,
    Node,
    ParameterSetting,
    Remap,
    Scope,
    ScopedSetting,
    Unknown,
)
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import Origin, Place
from launchlint.syntax.tree import Document
from launchlint.workspace.looking import NOTHING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

Value: TypeAlias = "str | Unknown"

NO_CYCLE = 1 << 30
"""The :attr:`Block.cycle_floor` of a block without an include cycle that begins above it."""


class PrivateParameter(NamedTuple):
    """A ``~param``: set for every node that follows in its scope. ``key`` is as written, canonicalised."""

    key: str
    setting: ParameterSetting


class NodeEffect(NamedTuple):
    """A node with what its own file says about it; ``private`` are the ``~params`` of its file and its own params, in roslaunch's order.

    ``parameters`` are the settings of ``<rosparam>`` children, which take effect before the private ones.
    """

    node: Node
    scoped_private: tuple[PrivateParameter, ...]
    own_private: tuple[PrivateParameter, ...]
    parameter_namespace: str


class Call(NamedTuple):
    """An ``<include>`` that was followed: what the included file inherits is what stands here.

    ``guessed``: an arg that it passes was lost, so that the file is evaluated with another value than was meant.
    """

    include: Include
    block: Block
    remaps: tuple[Remap, ...]
    environment: tuple[EnvironmentSetting, ...]
    private: tuple[PrivateParameter, ...]
    argument_reads: dict[str, frozenset[str]]
    scope: Scope
    conditions: tuple[Condition, ...]
    guessed: bool


class Clear(NamedTuple):
    """A ``clear_params``: the namespace whose parameters are deleted first."""

    namespace: str
    origin: Origin


class RunStep(NamedTuple):
    """A ``rosparam dump`` or ``delete`` that runs at the start."""

    command: str
    parameter: str
    file: str


class MoreParameters(NamedTuple):
    """Parameters of unknown names or values are set in ``namespace``: a YAML file that is not here, an unset environment variable."""

    namespace: str


class LocalBranch(NamedTuple):
    """A condition as the file sees it; ``reads`` are the args of this file it depends on."""

    origin: Origin
    element: Place
    tag: str
    attribute: str
    text: str
    taken: bool | None
    reads: frozenset[str]


Side = tuple[str, int, str, bool]
"""One side of a condition: path, offset of the element, ``if`` or ``unless``, and whether it was taken."""

Effect: TypeAlias = (
    "NodeEffect | ParameterSetting | MoreParameters | Machine | Problem | Call | Include | Clear | RunStep | LocalBranch | ScopedSetting"
    " | Argument"
)


class Block:
    """The effects of one launch file, in document order, and what leaks out of it.

    ``declared`` are the args declared at file level; ``argument_reads`` says for each arg of the file which other args its value was made
    from, ``argument_values`` what they are at its end; ``open_arguments`` are the args a caller can set. ``missing`` are args that were
    read but have no value: name to (declaration, reading place); ``refused_overrides`` are ``value=`` args that the caller tried to set.
    ``default_machine`` and ``leaked`` leak to the
    including file. ``anonymous``: an ``$(anon)`` was evaluated, so the block is not to be used again; ``near``: a package was found by its
    nearness to the entry file. ``unknown_machines`` are the machines that are defined by something unknown (empty: the name itself is).
    ``assumed_declarations``: an arg is declared under a condition of unknown value.

    What it cost, so that using it again counts as doing it again: ``looked_at`` elements, ``depth`` includes inside includes, the files
    and environment variables it ``touched``, and where it ``looked`` around. ``angles``: after it, YAML values may be angles.
    ``cycle_floor`` is the lowest place on the include stack that an include cycle in it leads back to.
    """

    __slots__ = (
        "_sides",
        "angles",
        "anonymous",
        "argument_reads",
        "argument_values",
        "assumed_declarations",
        "cycle_floor",
        "declared",
        "default_machine",
        "depth",
        "document",
        "effects",
        "entered",
        "leaked",
        "looked",
        "looked_at",
        "missing",
        "near",
        "node_count",
        "open_arguments",
        "refused_overrides",
        "touched",
        "unknown_machines",
        "variables",
        "visited",
    )

    def __init__(self, document: Document) -> None:
        self.document = document
        self.effects: list[Effect] = []
        self.visited: set[int] = set()
        self.declared: dict[str, Place] = {}
        self.argument_reads: dict[str, frozenset[str]] = {}
        self.open_arguments: set[str] = set()
        self.missing: dict[str, tuple[Place, Place]] = {}
        self.refused_overrides: dict[str, Place] = {}
        self.default_machine: str | None = None
        self.leaked: list[PrivateParameter] = []
        self.argument_values: dict[str, Value] = {}
        self.anonymous = False
        self.near = False
        self.assumed_declarations = False
        self.node_count = 0
        self.angles = False
        self.unknown_machines: set[str] = set()
        self.looked_at = 0
        self.depth = 0
        self.looked = NOTHING
        self.touched: frozenset[str] = frozenset()
        self.variables: frozenset[str] = frozenset()
        self.cycle_floor = NO_CYCLE
        self.entered: set[object] = set()
        self._sides: frozenset[Side] | None = None

    @property
    def sides(self) -> frozenset[Side]:
        """The sides of conditions that are taken in this file and in those it includes. To be asked for when the block is complete."""
        if self._sides is None:
            sides: set[Side] = set()
            for effect in self.effects:
                if isinstance(effect, Call):
                    sides |= effect.block.sides
                elif isinstance(effect, LocalBranch) and effect.taken is not None:
                    sides.add((effect.element.source.path, effect.element.span.start, effect.attribute, effect.taken))
            self._sides = frozenset(sides)
        return self._sides

    def is_made_of(self, files: frozenset[str]) -> bool:
        """Whether it hangs on what one of ``files`` (absolute) holds."""
        file = self.document.source.file
        return not self.touched.isdisjoint(files) or file in files or os.path.abspath(file) in files
