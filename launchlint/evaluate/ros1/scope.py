"""What is in force at one point of a launch file: namespace, args, remaps, environment, ``~params`` (roslaunch.loader.LoaderContext)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.block import PrivateParameter, Value
from launchlint.late import late
from launchlint.model import Condition, EnvironmentSetting, Remap, Scope, Unknown
from launchlint.source import Origin, Place
from launchlint.syntax.tree import Element

PrivateParameters = dict[str, PrivateParameter]
"""The ``~params`` that are set, by key, in the order in which they were set last."""
_WORD = late(r"[\w./-]+")
"""As the name of an arg is written in a condition."""
_MOST_ASKED = 12
_LONGEST_ASKED = 1_000
_LONGEST_VALUE = 100
"""Declarations of one arg, characters of a condition, and of a value, for which it is worked out on which args they hang."""


class Missing(Unknown):
    """The value of an arg that was read before it had one: this has been told of, and a declaration that follows still gives it its
    value.
    """

    __slots__ = ()


class ActiveSetting:
    """A remap, env or ``~param`` outside a node, while its scope is open: counts the nodes it acts on."""

    __slots__ = ("before", "conditions", "ended", "key", "kind", "origin", "reached", "replaced", "value")

    def __init__(
        self,
        kind: str,
        key: str,
        value: object,
        origin: Origin,
        before: tuple[Place, ...],
        replaced: Place | None,
        conditions: tuple[Condition, ...],
    ) -> None:
        self.kind = kind
        self.key = key
        self.value = value
        self.origin = origin
        self.before = before
        self.replaced = replaced
        self.conditions = conditions
        self.ended = False
        self.reached = 0


class Context:
    """One scope: a launch file or a group in it.

    ``arguments`` are the known values; ``declared`` the args declared in this scope or one around it in the same file, with their places.
    ``lenient`` is set in a file entered with ``pass_all_args``: there, and not in its groups, an arg may be declared again.
    """

    __slots__ = (
        "anonymous",
        "arguments",
        "declared",
        "environment",
        "lenient",
        "namespace",
        "nodes_above",
        "parent",
        "private",
        "remaps",
        "scope",
        "settings",
    )

    def __init__(self, namespace: str, parent: Context | None) -> None:
        self.namespace = namespace
        self.parent = parent
        self.remaps: dict[object, Remap] = {}
        self.settings: list[ActiveSetting] = []
        self.nodes_above: list[Place] = []
        self.lenient = False
        self.arguments: dict[str, Value] = {}
        self.declared: dict[str, Place] = {}
        self.anonymous: dict[str, str] = {}
        self.environment: list[EnvironmentSetting] = []
        self.private: PrivateParameters = {}
        self.scope: Scope | None = None
        if parent is not None:
            self.arguments = dict(parent.arguments)
            self.declared = dict(parent.declared)
            self.anonymous = dict(parent.anonymous)
            self.environment = list(parent.environment)
            self.private = dict(parent.private)
            self.scope = parent.scope

    def has_value(self, name: str) -> bool:
        """Whether the arg ``name`` has a value, known or not."""
        return name in self.arguments and not isinstance(self.arguments[name], Missing)

    def add_remap(self, remap: Remap) -> Remap | None:
        """Add ``remap``; a rule of this very scope with the same spelling is replaced and returned."""
        replaced = self.remaps.pop(remap.key, None)
        self.remaps[remap.key] = remap
        return replaced

    def remaps_in_force(self) -> list[Remap]:
        """The remaps of this file that act here, in the order roslaunch passes them (LoaderContext.remap_args)."""
        own = list(self.remaps.values())
        return own if self.parent is None else overlay(self.parent.remaps_in_force(), own)

    def set_private(self, parameter: PrivateParameter) -> PrivateParameter | None:
        """Set a ``~param`` for the nodes that follow; the earlier one of the same key is replaced and returned."""
        return set_private(self.private, parameter)

    def enclosing(self) -> Iterator[Context]:
        """This scope and those around it in the same file, innermost first."""
        context: Context | None = self
        while context is not None:
            yield context
            context = context.parent

    def reach(self, count: int) -> None:
        """Note that ``count`` nodes stand here: every setting in force acts on them."""
        if count:
            for context in self.enclosing():
                for setting in context.settings:
                    if not setting.ended:
                        setting.reached += count


def overlay(outer: list[Remap], inner: list[Remap]) -> list[Remap]:
    """The rules of ``outer`` that ``inner`` does not respell, then those of ``inner``."""
    respelled = {remap.key for remap in inner}
    return [remap for remap in outer if remap.key not in respelled] + inner


def set_private(parameters: PrivateParameters, parameter: PrivateParameter) -> PrivateParameter | None:
    """Put ``parameter`` last and take out, and return, the earlier one of the same key."""
    replaced = parameters.pop(parameter.key, None)
    parameters[parameter.key] = parameter
    return replaced


def asked_of(elements: Sequence[Element], context: Context, reads: set[str]) -> Iterator[tuple[str, str]]:
    """The args that the conditions of ``elements`` may ask, with their values as far as these are known; ``reads`` takes their names."""
    if len(elements) > _MOST_ASKED:
        return
    texts = (element.attributes[name].value for element in elements for name in ("if", "unless") if name in element.attributes)
    for name in sorted({word for text in texts for word in _WORD.findall(text[:_LONGEST_ASKED])} & context.arguments.keys()):
        reads.add(name)
        value = context.arguments[name]
        if isinstance(value, str) and len(value) < _LONGEST_VALUE:
            yield name, value
