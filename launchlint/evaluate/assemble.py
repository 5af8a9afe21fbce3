"""Join the blocks of one entry file into a :class:`~launchlint.model.Launch`.

Here everything gets its include chain, inherited remaps, environment and ``~params`` come together, and what only shows in the whole is
noticed: two nodes of one name, two machines of one name, a machine that does not exist.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from launchlint.evaluate.block import Block, Call, Clear, LocalBranch, MoreParameters, NodeEffect, PrivateParameter, Value
from launchlint.evaluate.names import UNKNOWN_NAMESPACE, canonical
from launchlint.evaluate.problems import DuplicateNode, MachineConflict, UnknownMachine
from launchlint.evaluate.steering import steering
from launchlint.model import (
    Argument,
    Branch,
    Condition,
    EnvironmentSetting,
    Include,
    Launch,
    Machine,
    Node,
    ParameterSetting,
    Remap,
    Role,
    Scope,
    ScopedSetting,
)
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import IncludeStep, Origin, Source
from launchlint.syntax.tree import Document

LARGEST_LAUNCH = 400_000
"""Effects of one configuration; includes that include each other twice at every level would go beyond it."""
INHERITED_PER_EFFECT = 8
"""How many environment settings, handed down to a node from including files, count as one more effect; of remaps each does."""

_OPEN_REMAPS: frozenset[Role] = frozenset(("remaps",))


class Entered(NamedTuple):
    """A launch file that was entered, by which include, and the args in it with their values."""

    path: str
    step: IncludeStep | None
    arguments: Mapping[str, Value]


class Evaluation(NamedTuple):
    """The outcome of evaluating one entry file in one configuration.

    ``documents`` are the launch files it reached by path; ``visited`` the indices of their conditional elements that were evaluated.
    ``compared`` (ROS 2) says what launch configurations that can be given are compared with. ``entered`` (ROS 1) are the files in the order
    in which they were entered, with the args that were read there.
    """

    launch: Launch
    documents: Mapping[str, Document]
    visited: Mapping[str, frozenset[int]]
    compared: Mapping[str, tuple[str, ...]] = MappingProxyType({})
    entered: tuple[Entered, ...] = ()


class _Inherited(NamedTuple):
    """What a block gets from the files that include it."""

    step: IncludeStep | None
    scope: Scope | None
    conditions: tuple[Condition, ...]
    assumed: bool
    remaps: tuple[Remap, ...]
    environment: tuple[EnvironmentSetting, ...]
    private: tuple[PrivateParameter, ...]
    steer: Mapping[str, frozenset[str]]
    given: frozenset[str]
    guessed: bool


class _Assembly:
    """The lists that one walk over the blocks fills."""

    def __init__(self) -> None:
        self.problems: list[Problem] = []
        self.entered: list[Entered] = []
        self.nodes: list[Node] = []
        self.tests: list[Node] = []
        self.settings: list[ParameterSetting] = []
        self.more_parameters: list[str] = []
        self.clear_params: list[tuple[str, Origin]] = []
        self.machines: dict[str, Machine] = {}
        self.unknown_machines: set[str] = set()
        self.executables: list[tuple[str, str, str]] = []
        self.includes: list[Include] = []
        self.scoped: list[ScopedSetting] = []
        self.declared: list[Argument] = []
        self.branches: list[Branch] = []
        self.files: list[str] = []
        self.complete = True
        self.names: dict[tuple[str, int], tuple[Node, bool]] = {}
        self.documents: dict[str, Document] = {}
        self.visited: dict[str, set[int]] = {}
        self.count = 0

    def walk(self, block: Block, file: str, inherited: _Inherited) -> None:
        """Add what ``block`` contributes."""
        path = block.document.source.path
        self.files.append(file)
        self.unknown_machines |= block.unknown_machines
        self.documents[path] = block.document
        self.entered.append(Entered(path, inherited.step, block.argument_values))
        self.visited.setdefault(path, set()).update(block.visited)
        steer = _steering(block, inherited)
        place = _Placing(inherited)
        inheritance = len(inherited.remaps) + len(inherited.environment) // INHERITED_PER_EFFECT + len(inherited.private)
        below = inherited.step
        for effect in block.effects:
            self.count += 1
            if self.count > LARGEST_LAUNCH:
                self.complete = False
                return
            if isinstance(effect, ParameterSetting):
                self.settings.append(effect if below is None else place.setting(effect))
            elif isinstance(effect, NodeEffect):
                self.count += inheritance
                self._node(effect, place, inherited)
            elif isinstance(effect, Problem):
                assumed = effect.assumed or inherited.assumed
                self.problems.append(
                    effect.but(origin=place.origin(effect.origin), assumed=assumed, refused=effect.refused and not assumed)
                )
            elif isinstance(effect, Call):
                self._call(effect, place, inherited, steer)
            elif isinstance(effect, LocalBranch):
                self._branch(effect, place, block, steer)
            elif isinstance(effect, Argument):
                self.declared.append(effect if below is None else place.argument(effect))
            elif isinstance(effect, ScopedSetting):
                conditions = inherited.conditions + effect.conditions
                self.scoped.append(effect._replace(origin=place.origin(effect.origin), conditions=conditions))
            elif isinstance(effect, Machine):
                self._machine(effect._replace(origin=place.origin(effect.origin)))
            elif isinstance(effect, Include):
                self.complete = False
                self.includes.append(place.include(effect))
            elif isinstance(effect, MoreParameters):
                self.more_parameters.append(effect.namespace)
            elif isinstance(effect, Clear):
                self.clear_params.append((effect.namespace, place.origin(effect.origin)))
            else:
                self.executables.append((effect.command, effect.parameter, effect.file))

    def _node(self, effect: NodeEffect, place: _Placing, inherited: _Inherited) -> None:
        node = effect.node
        respelled = {remap.key for remap in node.remaps}
        remaps = tuple(remap for remap in inherited.remaps if remap.key not in respelled) + tuple(
            remap._replace(origin=place.origin(remap.origin)) for remap in node.remaps
        )
        unknown = node.unknown if all(remap.source for remap in remaps) else node.unknown | _OPEN_REMAPS
        node = node._replace(
            origin=place.origin(node.origin),
            scope=place.scope(node.scope),
            conditions=inherited.conditions + node.conditions,
            remaps=tuple(remap for remap in remaps if remap.source),
            unknown=unknown,
            open_remaps=tuple(remap for remap in remaps if not remap.source),
            environment=inherited.environment
            + tuple(setting._replace(origin=place.origin(setting.origin)) for setting in node.environment),
        )
        scoped = _merge(inherited.private, tuple(place.private(parameter) for parameter in effect.scoped_private))
        if node.knows("name", "namespace"):
            for parameter in (*scoped, *(place.private(own) for own in effect.own_private)):
                key = parameter.key.removeprefix("~")
                name = canonical(effect.parameter_namespace + key)
                self.settings.append(parameter.setting._replace(name=name, node=node.full_name))
        if node.is_test:
            self.tests.append(node)
            return
        self.nodes.append(node)
        if node.name and node.knows("name", "namespace"):
            self._check_name(node, guessed=inherited.guessed)

    def _check_name(self, node: Node, *, guessed: bool) -> None:
        """Two nodes of one name: roslaunch stops (roslaunch.config.ROSLaunchConfig.add_node); /rosout is roscore's own.

        One of ``guessed`` nodes may have got its name from a mistake that is told elsewhere.
        """
        first, first_guessed = self.names.setdefault((node.full_name, _unknown_scope(node)), (node, guessed))
        if guessed or first_guessed:
            return
        core = first is node
        if core and node.full_name != "/rosout":
            return
        if any(condition.assumed for condition in (*node.conditions, *first.conditions)):
            return
        self.problems.append(
            DuplicateNode(
                origin=Origin(node.places.get("name", node.origin.place), node.origin.step),
                refused=True,
                related=() if core else ((first.places.get("name", first.origin.place), "the first one"),),
                name=node.full_name,
                first=first,
                second=node,
                core=core,
            )
        )

    def _machine(self, machine: Machine) -> None:
        known = self.machines.setdefault(machine.name, machine)
        # No password and an empty one are the same to roslaunch (roslaunch.core.Machine.config_key).
        fields = tuple(field for field in machine._fields[:-1] if (getattr(known, field) or "") != (getattr(machine, field) or ""))
        if fields:
            related = ((known.origin.place, "the first definition"),)
            self.problems.append(MachineConflict(origin=machine.origin, refused=True, related=related, name=machine.name, fields=fields))

    def _call(self, call: Call, place: _Placing, inherited: _Inherited, steer: Mapping[str, frozenset[str]]) -> None:
        include = place.include(call.include)
        self.includes.append(include)
        respelled = {remap.key for remap in call.remaps}
        step = IncludeStep(call.include.origin.place, inherited.step)
        passed = {name: steering(steer.get(read, ()) for read in reads) for name, reads in call.argument_reads.items()}
        inner = _Inherited(
            step,
            place.scope(call.scope),
            inherited.conditions + call.conditions,
            inherited.assumed or any(condition.assumed for condition in call.conditions),
            tuple(remap for remap in inherited.remaps if remap.key not in respelled)
            + tuple(remap._replace(origin=place.origin(remap.origin)) for remap in call.remaps),
            inherited.environment + tuple(setting._replace(origin=place.origin(setting.origin)) for setting in call.environment),
            _merge(inherited.private, tuple(place.private(parameter) for parameter in call.private)),
            passed,
            frozenset(include.arguments),
            inherited.guessed or call.guessed,
        )
        self.walk(call.block, call.include.file, inner)

    def _branch(self, effect: LocalBranch, place: _Placing, block: Block, steer: Mapping[str, frozenset[str]]) -> None:
        steered = steering(steer.get(name, ()) for name in effect.reads)
        self.branches.append(
            Branch(
                place.origin(effect.origin),
                effect.element,
                effect.tag,
                effect.attribute,
                effect.text,
                effect.taken,
                steered,
                _is_open(block, effect.reads),
            )
        )

    def check_machines(self) -> None:
        """A node on a machine that no file defines: roslaunch stops (roslaunch.config.ROSLaunchConfig._select_machine)."""
        if "" in self.unknown_machines:
            return
        known = self.unknown_machines.union(self.machines)
        for node in (*self.nodes, *self.tests):
            if node.machine and node.machine not in known and node.knows("machine"):
                origin = Origin(node.places.get("machine", node.origin.place), node.origin.step)
                assumed = any(condition.assumed for condition in node.conditions)
                defined = tuple(sorted(self.machines))
                self.problems.append(UnknownMachine(origin=origin, refused=not assumed, assumed=assumed, name=node.machine, known=defined))


class _Placing:
    """Puts the items of one block below the includes that led to it."""

    def __init__(self, inherited: _Inherited) -> None:
        self.step = inherited.step
        self.outer = inherited.scope
        self.conditions = inherited.conditions
        self._scopes: dict[int, Scope] = {}

    def origin(self, origin: Origin) -> Origin:
        if self.step is None:
            return origin
        if origin.step is None:
            return Origin(origin.place, self.step)
        step = self.step
        for place in origin.chain:
            step = IncludeStep(place, step)
        return Origin(origin.place, step)

    def scope(self, scope: Scope | None) -> Scope | None:
        if scope is None or (self.step is None and self.outer is None):
            return self.outer if scope is None else scope
        placed = self._scopes.get(id(scope))
        if placed is None:
            placed = scope._replace(origin=self.origin(scope.origin), parent=self.scope(scope.parent))
            self._scopes[id(scope)] = placed
        return placed

    def setting(self, setting: ParameterSetting) -> ParameterSetting:
        if self.step is None:
            return setting
        name, value, origin, tag, scope, conditions, node = setting  # written out, since there are so many of them
        place, step = origin
        placed = Origin(place, self.step) if step is None else self.origin(origin)
        return ParameterSetting(name, value, placed, tag, scope, self.conditions + conditions, node)

    def argument(self, argument: Argument) -> Argument:
        if self.step is None:
            return argument
        name, value, default, origin, passed, in_group = argument
        place, step = origin
        placed = Origin(place, self.step) if step is None else self.origin(origin)
        return Argument(name, value, default, placed, passed, in_group)

    def private(self, parameter: PrivateParameter) -> PrivateParameter:
        return parameter if self.step is None else parameter._replace(setting=self.setting(parameter.setting))

    def include(self, include: Include) -> Include:
        return include._replace(
            origin=self.origin(include.origin), scope=self.scope(include.scope), conditions=self.conditions + include.conditions
        )


def assemble(
    block: Block, file: str, arguments: Mapping[str, str], given: tuple[tuple[str, str], ...], pinned: frozenset[str]
) -> Evaluation:
    """The launch that ``block``, the block of the entry file, amounts to. ``pinned`` args are not to be changed by further
    configurations.
    """
    assembly = _Assembly()
    steer = {name: frozenset() if name in pinned else frozenset((name,)) for name in block.open_arguments}
    assembly.walk(block, file, _Inherited(None, None, (), False, (), (), (), steer, frozenset(arguments), False))
    assembly.check_machines()
    parameters: dict[str, ParameterSetting] = {}
    for setting in assembly.settings:
        parameters[setting.name] = setting
    problems = tuple(assembly.problems)
    launch = Launch(
        entry=block.document.source,
        arguments=arguments,
        given=given,
        refused=next((problem for problem in problems if problem.refused), None),
        problems=problems,
        nodes=tuple(assembly.nodes),
        tests=tuple(assembly.tests),
        parameters=parameters,
        parameter_settings=tuple(assembly.settings),
        more_parameters=tuple(assembly.more_parameters),
        clear_params=tuple(assembly.clear_params),
        machines=assembly.machines,
        executables=tuple(assembly.executables),
        includes=tuple(assembly.includes),
        settings=tuple(assembly.scoped),
        declared=tuple(assembly.declared),
        branches=tuple(assembly.branches),
        files=tuple(assembly.files),
        complete=assembly.complete,
    )
    visited = {path: frozenset(indices) for path, indices in assembly.visited.items()}
    return Evaluation(launch, assembly.documents, visited, entered=tuple(assembly.entered))


def not_loadable(source: Source, document: Document | None, given: tuple[tuple[str, str], ...], problem: Problem) -> Evaluation:
    """The empty launch of an entry file that cannot even be read as a launch file."""
    launch = Launch(source, dict(given), given, problem, (problem,), (), (), {}, (), (), {}, (), (), (), (), (), (), False)
    return Evaluation(launch, {} if document is None else {source.path: document}, {})


def _unknown_scope(node: Node) -> int:
    """Which group or include an unknown part of the namespace comes from: in two of them it need not be the same. 0 where all is known."""
    scope = node.scope
    if scope is None or UNKNOWN_NAMESPACE not in node.namespace:
        return 0
    unknown = node.namespace.count(UNKNOWN_NAMESPACE)
    while scope.parent is not None and scope.parent.namespace.count(UNKNOWN_NAMESPACE) == unknown:
        scope = scope.parent
    return id(scope)


def _merge(outer: tuple[PrivateParameter, ...], inner: tuple[PrivateParameter, ...]) -> tuple[PrivateParameter, ...]:
    """The ``~params`` of ``outer`` that ``inner`` does not set again, then those of ``inner``."""
    again = {parameter.key for parameter in inner}
    return tuple(parameter for parameter in outer if parameter.key not in again) + inner


def _steering(block: Block, inherited: _Inherited) -> dict[str, frozenset[str]]:
    """For each arg of a file, the args of the entry file that its value depends on."""
    steer: dict[str, frozenset[str]] = dict(inherited.steer)
    for name, reads in block.argument_reads.items():
        if name in inherited.steer and inherited.step is not None:
            continue
        steer[name] = steer.get(name, frozenset()) | steering(steer.get(read, ()) for read in reads)
    return steer


def _is_open(block: Block, reads: frozenset[str]) -> bool:
    """Whether one of ``reads`` can be changed from outside the file: not declared with ``value=``, or the environment."""
    seen: set[str] = set()
    waiting = list(reads)
    while waiting:
        name = waiting.pop()
        if name in seen:
            continue
        seen.add(name)
        if name in block.open_arguments or name not in block.argument_reads:
            return True
        waiting.extend(block.argument_reads[name])
    return False
