"""``<composable_node>``: what a container is asked to load (launch_ros.actions.LoadComposableNodes)."""

from __future__ import annotations

from functools import partial

from launchlint.evaluate.ros2 import component_parameters
from launchlint.evaluate.ros2.context import Value
from launchlint.evaluate.ros2.judged_keys import Receiver, judged_component
from launchlint.evaluate.ros2.leaving import note_leaks
from launchlint.evaluate.ros2.namespaces import namespace_of, namespace_with_slash
from launchlint.evaluate.ros2.performing import Failure
from launchlint.evaluate.ros2.processes import text_of
from launchlint.evaluate.ros2.setting_actions import remapping
from launchlint.evaluate.ros2.walk import STARTING, Walk
from launchlint.model import Condition, Node, Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.rcl.names import full_name
from launchlint.syntax.ros2 import description as described

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from launchlint.evaluate.ros2.component_parameters import Typed
    from launchlint.evaluate.ros2.parameters import Passed
    from launchlint.model import Role
    from launchlint.source import Place


class Met(NamedTuple):
    """A composable node that is to be loaded, with its condition, if it has one; ``ignored``: that does not hold."""

    component: described.Component
    condition: Condition | None
    ignored: bool = False


def met_components(walk: Walk, components: tuple[described.Component, ...]) -> list[Met]:
    """Those whose conditions hold."""
    met: list[Met] = []
    for component in components:
        walk.spend(1, component.place)
        if component.condition is None:
            met.append(Met(component, None))
            continue
        condition = walk.judge(component.condition, "composable_node", component.place)
        if condition is not None:
            met.append(Met(component, condition))
    return met


def _all_components(walk: Walk, components: tuple[described.Component, ...]) -> list[Met]:
    """All of them, whatever their conditions say: the launch of the distribution never looks at them."""
    met: list[Met] = []
    for component in components:
        condition = component.condition
        if condition is None:
            met.append(Met(component, None))
            continue
        value = text_of(walk.value(condition.operands[0]))
        holds = (value.strip().lower() in ("true", "1")) is (condition.kind == "if")
        met.append(Met(component, Condition(condition.kind, condition.place, False, value), not holds))
    return met


def load_components(walk: Walk, action: described.LoadComponents) -> None:
    """``<load_composable_node>``: the target is a text, to which no namespace is added."""
    target = walk.value(action.target)
    components = met_components if walk.rules.loads_by_condition else _all_components
    load(walk, components(walk, action.components), target, action.target.place)


def load(walk: Walk, met: list[Met], container: Value, place: Place | None) -> None:
    """Ask a container to load them, one after the other."""
    for each in met:
        outer = walk.here
        if each.condition is not None:
            assumed = outer.assumed or each.condition.assumed
            walk.here = outer._replace(conditions=(*outer.conditions, each.condition), assumed=assumed)
        if walk.repeats is None or not isinstance(container, str):
            _load(walk, each, container, place)
        else:
            perform = partial(_load_again, met=each, container=container, target=place)
            walk.repeats.execute(walk, each.component, perform, (container, each.ignored))
        walk.here = outer


def _load_again(walk: Walk, _: described.Component, *, met: Met, container: str, target: Place | None) -> None:
    _load(walk, met, container, target)


def _load(walk: Walk, met: Met, container: Value, target: Place | None) -> None:
    component = met.component
    walk.spend(STARTING, component.place)
    walk.spend_on_inherited(component.place)
    package, plugin, name = walk.value(component.package), walk.value(component.plugin), walk.optional(component.name)
    namespace = namespace_of(walk, component.namespace, component.place)
    remaps = [*(walk.context.remaps or ()), *(remapping(walk, remap) for remap in component.remaps)]
    written = component_parameters.Written()
    own = _parameters(walk, component, name, namespace, written)
    extra = _extra(walk, component)
    note_leaks(walk, component.place, text_of(name) if name else text_of(plugin))
    values: dict[Role, Value | None] = {"name": name, "namespace": namespace, "package": package, "executable": plugin}
    unknown = {role: value for role, value in values.items() if isinstance(value, Unknown)}
    roles = frozenset(unknown) if all(remap.patterns is None for remap in remaps) else frozenset((*unknown, "remaps"))
    here, origin = walk.here, walk.at(component.place)
    walk.nodes.append(
        Node(
            name="" if name is None else text_of(name),
            namespace=namespace_with_slash(namespace),
            package=text_of(package),
            executable="",
            machine=None,
            arguments="",
            remaps=tuple(remap for remap in remaps if remap.patterns is None),
            environment=(),
            output=None,
            respawn=False,
            respawn_delay=0.0,
            required=False,
            cwd=None,
            launch_prefix=None,
            file=here.file,
            origin=origin,
            places=_places(component) if target is None else {**_places(component), "container": target},
            scope=here.scope,
            conditions=here.conditions,
            unknown=roles,
            patterns={role: value.pattern for role, value in unknown.items()},
            open_remaps=tuple(remap for remap in remaps if remap.patterns is not None),
            kind="composable",
            plugin=text_of(plugin),
            container=text_of(container),
            deferred=here.deferred,
            has_namespace=namespace is not None,
            own=own,
            own_origins={} if own is None else {each: place for each, place in written.origins.items() if each in own},
            own_shared=frozenset(written.shared),
            extra_arguments=extra,
            condition_ignored=met.ignored,
        )
    )


def _parameters(
    walk: Walk, component: described.Component, name: Value | None, namespace: Value | None, written: component_parameters.Written
) -> Mapping[str, Typed] | None:
    in_force = walk.context.parameters or ()
    if not in_force and not component.parameters:
        return {}
    if isinstance(name, Unknown) or isinstance(namespace, Unknown):
        return None
    passed: list[Passed] = []
    try:
        own, complete = component_parameters.component_parameters(
            component.parameters, in_force, name or "", namespace, walk.performer, passed, written
        )
        if name:
            full = full_name(namespace or "/", name)
            walk.receivers.append(Receiver(full, False, tuple(passed), composable=True))
            for problem in judged_component(passed, full, walk.performer):
                walk.record_once(problem)
        return own if complete else None
    except Failure as failure:
        walk.record(failure.problem)
        return None


def _extra(walk: Walk, component: described.Component) -> Mapping[str, Typed]:
    try:
        return component_parameters.extra_arguments(component.extra_arguments, walk.performer)
    except Failure as failure:
        walk.record(failure.problem)
        return {}


def _places(component: described.Component) -> dict[Role, Place]:
    texts = {"package": component.package, "executable": component.plugin, "name": component.name, "namespace": component.namespace}
    return {role: text.place for role, text in texts.items() if text is not None}  # type: ignore[misc]
