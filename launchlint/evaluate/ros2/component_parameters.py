"""The params of composable nodes: launch_ros reads their files itself, by PyYAML, and sends values; rcl has no part in it.

Source: ``launch_ros.utilities.to_parameters_list`` and ``launch_ros.actions.load_composable_nodes``
(``get_composable_node_load_request``); the types are those that ``rclpy.parameter.Parameter.Type.check`` finds.
"""

from __future__ import annotations

import math
import posixpath
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from launchlint.evaluate.ros2.parameter_problems import ComponentFileRefused
from launchlint.evaluate.ros2.parameters import (
    PARAMETERS,
    GlobalParameter,
    Passed,
    TextValue,
    missing,
    parameter_file,
    source_of,
    values,
)
from launchlint.evaluate.ros2.parameters import by_rules as _by_rules
from launchlint.evaluate.ros2.rcl_files import table_of
from launchlint.evaluate.ros2.typed import TypeFault, load_file, same_type, what
from launchlint.model import Unknown
from launchlint.rcl.table import Table, winning
from launchlint.source import Origin, Place
from launchlint.syntax.ros2.description import ParameterFile, Text
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

    from launchlint.evaluate.ros2.parameters import GlobalSource, Performs
    from launchlint.syntax.ros2.description import Parameter, ParameterSource

Typed = tuple[str, Any]
"""Type and value, as :class:`launchlint.rcl.parameter_value.Value` has them; the value may be Unknown, with the type ``unknown``."""

_SCALARS = (bool, int, float, str)


class Written:
    """Where the params of a composable node stand, and which of them a file gives to whatever node matches a pattern."""

    def __init__(self) -> None:
        self.origins: dict[str, Origin] = {}
        self.shared: set[str] = set()

    def here(self, names: Iterable[str], origin: Origin) -> None:
        """In the launch file."""
        self.origins.update(dict.fromkeys(names, origin))
        self.shared.difference_update(names)

    def in_file(self, given: Passed, full_name: str, asks: Performs) -> None:
        """In a file, as far as rcl reads it the same way."""
        table = None if given.file is None or given.unknown else table_of(given.file, asks)
        if not isinstance(table, Table):
            return
        for_all = {id(each) for key in table.keys.values() if "*" in key.name for each in key.parameters}
        for name, parameter in winning(table, full_name).items():
            source, _, span, _ = parameter.written
            if source is not None:
                self.origins[name] = Origin(Place(source, span), given.origin.step)
            (self.shared.add if id(parameter) in for_all else self.shared.discard)(name)


def component_parameters(
    own: Iterable[ParameterSource],
    in_force: Iterable[GlobalSource],
    name: str,
    namespace: str | None,
    asks: Performs,
    passed: list[Passed] | None = None,
    written: Written | None = None,
) -> tuple[Mapping[str, Typed], bool]:
    """The params that a composable node is given, and whether all of them are known. Raises where launch stops.

    Args:
        own: its own params.
        in_force: what ``<set_parameter>`` and ``<set_parameters_from_file>`` left, in order.
        name: its name, empty if it has none here.
        namespace: its namespace, if it is given one.
        asks: who performs texts.
        passed: is filled with the files and values that it is given.
        written: is told where they stand.
    """
    passed = [] if passed is None else passed
    written = Written() if written is None else written
    full = posixpath.join(namespace.strip("/"), name.lstrip("/")) if namespace and namespace != "/" else name.lstrip("/")
    sets: list[Mapping[str, Any] | Passed] = []
    for each in in_force:
        if isinstance(each, GlobalParameter):
            sets.append({each.name.text if isinstance(each.name, Unknown) else each.name: each.value})
        elif isinstance(each.file, Unknown):
            sets.append(Passed(each.origin, file=each.file.text, unknown=True))
        else:
            if asks.session.read(each.file).data is None:
                asks.fail(missing(each.file, each.origin, "filename", asks))
            sets.append(Passed(each.origin, file=posixpath.normpath(each.file)))
    for source in own:
        if isinstance(source, ParameterFile):
            given = parameter_file(source, asks, must_exist=True)
            assert given is not None  # a file that must exist and does not has stopped launch
            sets.append(given)
            passed.append(given)
            written.in_file(given, f"/{full}", asks)
        else:
            texts: list[TextValue] = []
            found, origin = values(source, asks, texts), asks.where(source.place)
            sets.append(found)
            passed.append(Passed(origin, texts=tuple(texts)))
            written.here(found, origin)
    return _joined(sets, full, asks)


def extra_arguments(given: Iterable[Parameter], asks: Performs) -> Mapping[str, Typed]:
    """What ``<extra_arg>``s say. Raises where launch stops."""
    found: dict[str, Typed] = {}
    for each in given:
        if each.value is None:
            continue
        name = asks.perform(each.name)
        text = each.value.value if isinstance(each.value.value, Text) else each.value.value[0]
        key = name.text if isinstance(name, Unknown) else name
        found[key] = typed(_by_rules(key, text, asks))
    return found


def _joined(sets: Iterable[Mapping[str, Any] | Passed], full: str, asks: Performs) -> tuple[Mapping[str, Typed], bool]:
    found: dict[str, Typed] = {}
    complete = True
    current: Mapping[str, Any] = {}
    for each in sets:
        if isinstance(each, Passed):
            if each.unknown:
                complete = False
                continue
            # Where nothing in a file is for this node, what stood before it is sent once more.
            current = _of_file(each, full, asks) or current
        else:
            current = each
        for key, value in current.items():
            found[key] = typed(value)
    return found, complete


def typed(value: Any) -> Typed:
    """The type that rclpy sends a value with."""
    if isinstance(value, Unknown):
        return "unknown", value
    for type_, kind in (("bool", bool), ("int", int), ("double", float), ("str", str)):
        if isinstance(value, kind):
            return type_, value
    items = list(value)
    if not items:
        return "bytes", items
    for type_, kind in (("bool[]", bool), ("int[]", int), ("double[]", float), ("str[]", str)):
        if all(isinstance(item, kind) for item in items):
            return type_, items
    return "unknown", Unknown(str(items)[:100], "rclpy has no type for it")


def _of_file(given: Passed, full: str, asks: Performs) -> dict[str, Any] | None:
    """What a file holds for the node ``full`` (namespace and name, without the slash in front). Raises where launch stops."""
    shown = given.of or given.file or ""
    data = _loaded(given, shown, asks)
    if isinstance(data, Unknown):
        return None
    if not isinstance(data, dict):
        _refuse(given.origin, shown, "it holds no mapping" if data is not None else "it is empty", asks)
    by_node = dict(_by_node(data, ()))
    if by_node:
        data = by_node.get("**", {})
        mine = by_node.get(full)
        if full in by_node:
            if not isinstance(data, dict) or not isinstance(mine, dict):
                _refuse(given.origin, shown, f"{PARAMETERS} holds no mapping", asks)
            data = {**data, **mine}
    if not data:
        return None
    if not isinstance(data, dict):
        _refuse(given.origin, shown, f"{PARAMETERS} holds no mapping", asks)
    found: dict[str, Any] = {}
    _flatten(data, "", found, given.origin, shown, asks)
    return found


def _loaded(given: Passed, shown: str, asks: Performs) -> Any:
    if given.file is None:
        return given.content
    kept = asks.session.loaded.get(f"params {given.file}")
    if kept is None:
        read = asks.session.read(given.file)
        try:
            kept = (load_file(source_of(given.file, read.data or b"", asks).text), None)
        except YamlError as error:
            kept = (None, error.message)
        except YamlBeyond as beyond:
            kept = (Unknown(given.file, beyond.message), None)
        asks.session.loaded[f"params {given.file}"] = kept
    data, reason = kept
    if reason is not None:
        _refuse(given.origin, shown, reason, asks)
    return data


def _by_node(data: Mapping[Any, Any], keys: tuple[str, ...]) -> Iterator[tuple[str, Any]]:
    """Each ``ros__parameters`` under the names of its keys; what stands behind it in its mapping is not looked at."""
    for key, value in data.items():
        if key == PARAMETERS:
            yield "/".join(keys), value
            return
        if isinstance(value, dict):
            yield from _by_node(value, (*keys, str(key).lstrip("/")))


def _flatten(data: Mapping[Any, Any], before: str, found: dict[str, Any], origin: Origin, shown: str, asks: Performs) -> None:
    for key, value in data.items():
        if not isinstance(key, str):
            _refuse(origin, shown, f"the name {key!r} of a parameter is no text", asks)
        name = f"{before}{key}"
        if isinstance(value, dict):
            _flatten(value, f"{name}.", found, origin, shown, asks)
        elif isinstance(value, list):
            try:
                found[name] = _list(value)
            except TypeFault as fault:
                _refuse(origin, shown, f"{name}: {fault.reason}", asks)
        elif isinstance(value, (*_SCALARS, bytes)):
            found[name] = value
        else:
            _refuse(origin, shown, f"{name} is {what(value)}, and that is no value of a parameter", asks)


def _list(items: list[Any]) -> tuple[Any, ...]:
    """A list of a file: whole numbers among numbers with a point are taken for such; anything else must be of one type."""
    kinds = {type(each) for each in items}
    if kinds == {int, float}:
        return tuple(float(each) if abs(each) < 2**1000 else math.inf for each in items)
    if not items:
        raise TypeFault("a list without items has no type")
    if not same_type(items):
        raise TypeFault("the items of a list must all be of one type: true or false, whole numbers, numbers with a point, or texts")
    return tuple(items)


def _refuse(origin: Origin, file: str, reason: str, asks: Performs) -> NoReturn:
    asks.fail(ComponentFileRefused(origin=origin, refused=True, file=file, reason=reason))
