"""What the configurations of one entry file have in common: a node that is started in the same way is worked out once.

Most configurations differ in a node or two. Two nodes are the same where everything is equal that is known of them, the places in the
launch files and the conditions included; then all that follows from the node alone is equal, too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from launchlint.graph.connections import Instance
from launchlint.graph.parameters import Parameters
from launchlint.model import Node
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeVar

    from launchlint.library.lookup import Library

    Process = TypeVar("Process")
    Fact = TypeVar("Fact")

DEEPEST = 16
"""Groups and includes around a node; with more of them comparing it with another one would cost more than it saves."""


class _Made(NamedTuple):
    """An instance with all that it was made from; ``params`` are those that were asked for."""

    made_of: tuple[object, ...]
    params: Mapping[str, Any]
    instance: Instance


class Earlier:
    """The nodes of the configurations of one entry file that were connected before."""

    def __init__(self) -> None:
        self._processes: dict[tuple[str, Place], tuple[Node, Any]] = {}
        self._made: dict[tuple[str, Place, int], _Made] = {}
        self._facts: dict[tuple[int, object], tuple[Instance, Any]] = {}
        self._with_params: dict[tuple[int, object], tuple[Instance, Mapping[str, Any], bool, Any]] = {}

    def process(self, node: Node, make: Callable[[Node], Process]) -> Process:
        """What ``make`` gives for ``node``, which must depend on nothing else; that of an equal node if there was one."""
        if _is_deep(node):
            return make(node)
        key = _key(node)
        known = self._processes.get(key)
        if known is not None and known[0] == node:
            process: Process = known[1]
        else:
            process = make(node)
            self._processes[key] = (node, process)
        return process

    def instance(
        self, node: Node, made_of: tuple[object, ...], parameters: Parameters, make: Callable[[], Instance], number: int = 0
    ) -> Instance:
        """What ``make`` gives for ``node``; the same as before where all params it asks for are the same, and all that it is ``made_of``.

        Texts among these are the same where they are equal, everything else where it is one and the same. ``number`` is that of the nodes
        of this configuration that have the same name and place and come before it: each of them is an instance of its own.
        """
        key = (*_key(node), number)
        known = self._made.get(key)
        if (
            known is not None
            and len(known.made_of) == len(made_of)
            and all(map(_is_one, known.made_of, made_of))
            and all(_is_same(parameters.value(name), value) for name, value in known.params.items())
        ):
            return known.instance
        parameters.noted()
        instance = make()
        self._made[key] = _Made(made_of, parameters.noted(), instance)
        return instance

    def fact(self, instance: Instance, work: Callable[[Instance, Library], Fact], library: Library) -> Fact:
        """What ``work`` makes of an instance and a library, which is always the same one, and of nothing else; once for each instance."""
        key = (id(instance), work)
        if key not in self._facts:
            self._facts[key] = (instance, work(instance, library))  # the instance stays alive, and so its id its own
        fact: Fact = self._facts[key][1]
        return fact

    def with_params(
        self,
        instance: Instance,
        params: Callable[[], Mapping[str, Any]],
        work: Callable[[Instance, Mapping[str, Any]], Fact],
        *,
        own: bool,
    ) -> Fact:
        """What ``work`` makes of an instance and values of ``params``, and of nothing else; once for each instance with the same values.

        ``own``: they are those of the node itself, which are always the same.
        """
        key = (id(instance), work)
        known = self._with_params.get(key)
        values = known[1] if known is not None and own and known[2] else params()
        if known is None or (values is not known[1] and not _is_same(known[1], values)):
            known = self._with_params[key] = (instance, values, own, work(instance, values))
        fact: Fact = known[3]
        return fact


def _key(node: Node) -> tuple[str, Place]:
    return node.full_name, node.origin.place


def _is_deep(node: Node) -> bool:
    scope, depth = node.scope, 0
    while scope is not None and depth <= DEEPEST:
        scope, depth = scope.parent, depth + 1
    return depth > DEEPEST


def _is_one(one: object, other: object) -> bool:
    return one is other or (isinstance(one, str) and one == other)


def _is_same(value: Any, other: Any) -> bool:
    """Whether two values of a param are the same for whatever is made of them: 1, 1.0 and true are not."""
    if value is other:
        return True
    if type(value) is not type(other):
        return False
    if isinstance(value, dict):
        return list(value) == list(other) and all(_is_same(value[key], other[key]) for key in value)
    if isinstance(value, list):
        return len(value) == len(other) and all(map(_is_same, value, other))
    return isinstance(value, (str, int, float)) and repr(value) == repr(other)
