"""``<node>`` and ``<node_container>`` (launch_ros.actions.Node, launch_ros.actions.ComposableNodeContainer)."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping

from launchlint.evaluate.problems import InvalidNamespace, InvalidNodeName
from launchlint.evaluate.ros2.components import load, met_components
from launchlint.evaluate.ros2.context import Value
from launchlint.evaluate.ros2.judged_keys import Receiver
from launchlint.evaluate.ros2.judged_parameters import judged
from launchlint.evaluate.ros2.leaving import is_anonymous, note_leaks
from launchlint.evaluate.ros2.names import name_fault, namespace_fault, prefixed
from launchlint.evaluate.ros2.namespaces import namespace_of, namespace_with_slash
from launchlint.evaluate.ros2.parameters import Passed, node_parameters
from launchlint.evaluate.ros2.performing import Failure
from launchlint.evaluate.ros2.problems import NodePackageMissing
from launchlint.evaluate.ros2.processes import exits, prepare, process_of, text_of
from launchlint.evaluate.ros2.setting_actions import remapping
from launchlint.evaluate.ros2.started import Started, started
from launchlint.evaluate.ros2.substitutions import is_package_name, prefix
from launchlint.evaluate.ros2.walk import STARTING, Told, Walk, tag_of
from launchlint.model import EnvironmentSetting, Node, OwnParameters, ParameterSource, Remap, Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.problems import NameFault
    from launchlint.evaluate.ros2.started import Value as StartValue
    from launchlint.model import Role

_CONTAINERS = "component_container"
"""How the programs of rclcpp_components begin that others load nodes into, however they are started."""


class Named(NamedTuple):
    """A name and an absolute namespace; None where launch gives none."""

    name: Value | None
    namespace: Value | None

    @property
    def full(self) -> Value | None:
        """Both together, where launch gives both."""
        if self.name is None or self.namespace is None:
            return None
        if isinstance(self.name, str) and isinstance(self.namespace, str):
            return prefixed(self.namespace, self.name)
        unknown = self.name if isinstance(self.name, Unknown) else self.namespace
        reason = unknown.reason if isinstance(unknown, Unknown) else ""
        return Unknown(f"{text_of(self.namespace).rstrip('/')}/{text_of(self.name)}", reason)


def node(walk: Walk, action: described.Node) -> None:
    """Execute a node: its name, its params and its remaps are worked out before its command line is."""
    walk.spend(STARTING, action.place)
    walk.spend_on_inherited(action.place)
    components = met_components(walk, action.components)
    tag = tag_of(action)
    named = _named(walk, action)
    sources = _parameters(walk, action, named)
    remaps = [*(walk.context.remaps or ()), *(remapping(walk, remap) for remap in action.remaps)]
    executable, package = walk.value(action.executable), walk.optional(action.package)
    program = _program(walk, action, executable, package)
    arguments, ros_arguments = _words(walk, action.arguments), _words(walk, action.ros_arguments)
    prepared = prepare(walk, action.process, (program, *arguments), tag, action.place)
    known = [remap for remap in remaps if remap.patterns is None]
    fate = _started(walk, named, sources, known, arguments, ros_arguments if action.ros_arguments else None)
    if fate is not None:
        for problem in judged(sources, known, fate, fate.full_name or text_of(executable), walk.performer):
            walk.record_once(problem)
        walk.receivers.append(
            Receiver(
                fate.full_name,
                action.kind == "container" or text_of(executable).startswith(_CONTAINERS),
                tuple(sources),
                anonymous=action.name is not None and is_anonymous(action.name),
                program=text_of(executable),
                namespace=namespace_with_slash(named.namespace),
            )
        )
    unknown, patterns = _unknown({"name": named.name, "namespace": named.namespace, "package": package, "executable": executable})
    if any(isinstance(word, Unknown) for word in arguments):
        unknown.add("arguments")
    if len(known) < len(remaps):
        unknown.add("remaps")
    own = _own(None if fate is None else fate.parameters)
    here, origin = walk.here, walk.at(action.place)
    process = process_of(prepared, action.process, arguments, ros_arguments)
    note_leaks(walk, action.place, text_of(named.name) if named.name else text_of(executable))
    walk.nodes.append(
        Node(
            name=_shown(named.name),
            namespace=namespace_with_slash(named.namespace),
            package=_shown(package),
            executable=text_of(executable),
            machine=None,
            arguments=" ".join(process.arguments),
            remaps=tuple(known),
            environment=tuple(
                EnvironmentSetting(name, value, origin) for name, value in process.environment.items() if value is not None
            ),
            output=text_of(prepared.output),
            respawn=prepared.respawn,
            respawn_delay=action.process.respawn_delay or 0.0,
            required=process.on_exit == "shutdown",
            cwd=_shown(prepared.cwd) or None,
            launch_prefix=text_of(prepared.prefix) or None,
            file=here.file,
            origin=origin,
            places=_places(action),
            scope=here.scope,
            conditions=here.conditions,
            unknown=frozenset(unknown) | prepared.unknown,
            patterns=patterns,
            open_remaps=tuple(remap for remap in remaps if remap.patterns is not None),
            kind=action.kind,
            deferred=here.deferred,
            has_namespace=named.namespace is not None,
            process=process,
            sources=tuple(ParameterSource(each.origin, each.file, each.content, each.rule, each.of) for each in sources),
            own=own.own,
            own_origins=own.own_origins,
            own_shared=own.own_shared,
            own_as=None if fate is None or fate.called is None else _OwnAs(fate.called),
            fatal="" if fate is None or fate.refused is None else fate.refused.reason,
        )
    )  # fmt: skip
    if action.kind == "container" and named.full is not None:
        walk.performer.containers.append((action.place.key, named.full))
    if components:
        load(walk, components, named.full if named.full is not None else Told("", "the container has no name"), None)
    exits(walk, action.process)


def _named(walk: Walk, action: described.Node) -> Named:
    name = walk.optional(action.name)
    if isinstance(name, str) and action.name is not None:
        name = _checked_name(walk, name, action.name)
    namespace = namespace_of(walk, action.namespace, action.place)
    if isinstance(namespace, str) and namespace_fault(namespace):
        at = action.place if action.namespace is None else action.namespace.place
        walk.record(InvalidNamespace(origin=walk.at(at), refused=True, namespace=namespace, private=False))
        namespace = Told(namespace, "it is no namespace")
    return Named(name, namespace)


def _checked_name(walk: Walk, name: str, written: Text) -> Value:
    if not name_fault(name):
        return name
    reason: NameFault = "empty" if not name else "slash" if "/" in name else "characters"
    walk.record(InvalidNodeName(origin=walk.at(written.place), refused=True, name=name, from_test=False, reason=reason))
    return Told(name, "it is no name of a node")


def _parameters(walk: Walk, action: described.Node, named: Named) -> list[Passed]:
    """What stands on the command line for params. Where launch stops at one of them the others are left out, too."""
    try:
        return node_parameters(action.parameters, walk.context.parameters or (), named.full, walk.performer)
    except Failure as failure:
        walk.record(failure.problem)
        return [Passed(walk.at(action.place), unknown=True)]


def _program(walk: Walk, action: described.Node, executable: Value, package: Value | None) -> Value:
    """The path of the program (launch_ros.substitutions.ExecutableInPackage); its package must be there."""
    if package is None:
        return executable
    if isinstance(package, str) and action.package is not None:
        valid = is_package_name(package)
        if not valid or walk.session.packages.colcon.find(package, walk.entry) is None:
            place = action.package.place
            walk.record(NodePackageMissing(origin=walk.at(place), refused=True, package=package, near=walk.entry, valid=valid))
    if isinstance(executable, Unknown) or isinstance(package, Unknown):
        return executable if isinstance(executable, Unknown) else Unknown(executable, "its package is not known")
    return os.path.join(prefix(walk.performer), "lib", package, executable)


def _words(walk: Walk, words: tuple[Text, ...]) -> list[Value]:
    return [walk.value(word) for word in words]


def _started(
    walk: Walk, named: Named, sources: list[Passed], remaps: list[Remap], arguments: list[Value], ros_arguments: list[Value] | None
) -> Started | None:
    """What rcl makes of it; None where it is not known under which name."""
    if isinstance(named.name, Unknown) or isinstance(named.namespace, Unknown):
        return None
    words = [text_of(word) for word in arguments]
    ros_words = None if ros_arguments is None else [text_of(word) for word in ros_arguments]
    pairs = [(remap.source, remap.target) for remap in remaps]
    return started(words, ros_words, named.name, named.namespace, sources, pairs, walk.performer)


class _OwnAs:
    """What a node ends up with under a name that launch does not give it. Two of one node say the same, and look the same."""

    __slots__ = ("_called",)

    def __init__(self, called: Callable[[str], Mapping[str, StartValue] | None]) -> None:
        self._called = called

    def __call__(self, full_name: str) -> OwnParameters:
        return _own(self._called(full_name))

    def __repr__(self) -> str:
        return "OwnAs()"


def _own(parameters: Mapping[str, StartValue] | None) -> OwnParameters:
    """The params that it ends up with."""
    if parameters is None:
        return OwnParameters(None, {}, frozenset())
    return OwnParameters(
        {name: (value.type, value.data) for name, value in parameters.items()},
        {name: value.origin for name, value in parameters.items() if value.origin is not None},
        frozenset(name for name, value in parameters.items() if value.shared),
    )


def _unknown(values: dict[Role, Value | None]) -> tuple[set[Role], dict[Role, str]]:
    unknown = {role: value for role, value in values.items() if isinstance(value, Unknown)}
    return set(unknown), {role: value.pattern for role, value in unknown.items()}


def _shown(value: Value | None) -> str:
    return "" if value is None else text_of(value)


def _places(action: described.Node) -> dict[Role, Place]:
    process = action.process
    texts: dict[Role, Text | None] = {
        "package": action.package,
        "executable": action.executable,
        "name": action.name,
        "namespace": action.namespace,
        "arguments": action.arguments[0] if action.arguments else None,
        "prefix": process.prefix,
        "output": process.output,
        "cwd": process.cwd,
    }
    return {role: text.place for role, text in texts.items() if text is not None}
