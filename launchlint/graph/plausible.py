"""What may be there although the graph does not show it: which nodes could be the partner of a name.

A node of which nothing is known, or that may have more of a kind than is known, could not have any name. Its relative names lie below its
namespace, those with one part may be global (``/cmd_vel``), and a name that a remap leads away from it is not its own. What its remaps,
args, params and the texts in its sources say are names that it may well have, wherever they lie. ``package.xml`` says nothing of this: in
public repositories one of five types that programs use is of a package on which theirs does not depend, not even in a roundabout way.

Everything is looked up by name; no question goes over all nodes.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property, partial
from itertools import islice

from launchlint.evaluate.names import UNKNOWN_NAMESPACE
from launchlint.graph.connections import Doubt, Instance
from launchlint.graph.earlier import Earlier
from launchlint.graph.names import absolute, around
from launchlint.graph.parameters import Parameters
from launchlint.graph.programs import may_talk, spelled
from launchlint.late import late
from launchlint.library.terms import CATEGORIES
from launchlint.model import Launch
from launchlint.named_tuple import NamedTuple
from launchlint.words import split_words

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_LOOKED_AT = 50
"""Nodes, or patterns, of one kind that are looked at for one name; with more of them it is taken for possible."""
MOST_ANSWERS = 5
_MOST_VALUES = 200
_CATEGORIES: Mapping[tuple[str, bool], tuple[str, ...]] = {
    ("topic", True): ("publishers", "actions"),
    ("topic", False): ("subscribers", "actions"),
    ("service", True): ("services",),
    ("service", False): ("clients",),
    ("action", True): ("actions",),
    ("action", False): ("actions",),
}
"""Categories of the library that offer, or use, each kind of name."""
_ACTION = frozenset({"goal", "cancel", "status", "feedback", "result"})
_NAME = late(r"[~/]?[A-Za-z][\w/]{0,200}", re.ASCII)
_NO_TOPIC = "frame"
"""Params with this in their names hold coordinate frames, which are called as topics are."""


class Possible(NamedTuple):
    """A node, or something else, that could have a name.

    ``node`` is its full name, empty for what is no node; ``reason`` says why it is not known, for people. ``named``: something says that
    it has just this name. ``anything``: it is of a kind that talks to whatever it finds: a window in which people choose,
    a loader of plugins, a launch file that is not here.
    """

    node: str
    reason: str
    named: bool
    anything: bool = False


class _Stranger(NamedTuple):
    """What is known of a node of which not everything is: its ``namespace`` (None: any), names it has, and names it has not."""

    possible: Possible
    namespace: str | None
    names: frozenset[str]
    moved: frozenset[str]


class Strangers:
    """The nodes of one launch that may have names of one category (of the library) that nobody knows of."""

    def __init__(self, category: str, launch: Launch, instances: Iterable[Instance], said: _Said) -> None:
        self._category = category
        self._launch = launch
        self._instances = instances
        self._said = said

    def who(self, name: str, type_: str) -> Iterator[Possible]:
        """Who could have ``name`` with the type ``type_`` (empty: any): first those of which something says so."""
        parents = list(around(name))
        for full in parents:
            if full in self._by_node and name not in self._by_node[full].moved:
                yield self._by_node[full].possible._replace(named=True)  # what lies below its own name
        for full in (name, *parents):
            for stranger in islice(self._named.get(full, ()), MOST_LOOKED_AT):
                if name not in stranger.moved:
                    yield stranger.possible._replace(named=True)
        for program in islice(self._literals.get(name.rpartition("/")[2], ()), MOST_LOOKED_AT):
            for namespace in (*parents, ""):
                stranger_there = self._programs[program].get(namespace)
                if stranger_there is not None and name not in stranger_there.moved:
                    yield stranger_there.possible._replace(named=True)
        for namespace in (*parents, ""):
            yield from self._of(self._around.get(namespace, ()), name)
        yield from self._of(self._anywhere, name)
        if not parents:
            yield from self._of(self._global, name)
        yield from self.doubted(name, type_)

    def doubted(self, name: str, type_: str) -> Iterator[Possible]:
        """Who has a name of which only a part is known, and that may be this one."""
        last = name.rpartition("/")[2]
        for known in dict.fromkeys((last, "")):
            doubts = self._doubts.get(known, {})
            for doubt, node in islice(doubts.items(), MOST_LOOKED_AT):
                if doubt.may_be(name) and doubt.speaks(type_):
                    yield Possible(node, f"{node} has {doubt.category} whose names cannot be known ({doubt.declared})", _says(doubt, name))
            if len(doubts) > MOST_LOOKED_AT:
                yield Possible("", f"many nodes have {self._category} whose names cannot be known", False, True)

    @staticmethod
    def _of(strangers: list[_Stranger] | tuple[()], name: str) -> Iterator[Possible]:
        looked_at = 0
        for stranger in islice(strangers, MOST_LOOKED_AT):
            looked_at += 1
            if name not in stranger.moved:
                yield stranger.possible
        if looked_at == MOST_LOOKED_AT:
            yield stranger.possible

    @cached_property
    def _all(self) -> list[_Stranger]:
        found = [self._said.stranger(each, self._category) for each in self._instances]
        strangers = [each for each in found if each is not None]
        for include in () if self._launch.complete else self._launch.includes:
            if include.source is None:
                names = (name for value in include.arguments.values() if isinstance(value, str) for name in _names([value], "/", "/"))
                possible = Possible("", f"an include could not be followed: {include.file}", False, True)
                strangers.append(_Stranger(possible, None, frozenset(names), frozenset()))
        for program in self._launch.programs:
            if may_talk(program):
                possible = Possible("", f"it is not known what {spelled(program)} does, which is started here", False, True)
                strangers.append(_Stranger(possible, None, frozenset(_names(program.command, "/", "/")), frozenset()))
        if not self._launch.complete and not any(not each.possible.node for each in strangers):
            strangers.append(
                _Stranger(Possible("", "not all of the launch file could be followed", False, True), None, frozenset(), frozenset())
            )
        return strangers

    @cached_property
    def _named(self) -> Mapping[str, list[_Stranger]]:
        found: dict[str, list[_Stranger]] = {}
        for stranger in self._all:
            for name in stranger.names:
                found.setdefault(name, []).append(stranger)
        if self._all:
            for name in self._said.params:
                found.setdefault(name, [self._all[0]])
        return found

    @cached_property
    def _by_node(self) -> Mapping[str, _Stranger]:
        return {stranger.possible.node: stranger for stranger in self._all if stranger.possible.node}

    @cached_property
    def _programs(self) -> Mapping[str, Mapping[str, _Stranger]]:
        """For each program whose sources were read, and each namespace that it runs in, one of its nodes."""
        found: dict[str, dict[str, _Stranger]] = {}
        for instance in self._instances:
            if instance.literals and instance.name in self._by_node:
                stranger = self._by_node[instance.name]
                found.setdefault(instance.program, {}).setdefault(stranger.namespace or "", stranger)
        return found

    @cached_property
    def _literals(self) -> Mapping[str, list[str]]:
        """The programs in whose sources a text is that ends so: names are put together of such texts."""
        found: dict[str, list[str]] = {}
        texts = {instance.program: instance.literals for instance in self._instances if instance.program in self._programs}
        for program, literals in texts.items():
            for last in {text.rpartition("/")[2].lstrip("~") for text in literals}:
                found.setdefault(last, []).append(program)
        return found

    @cached_property
    def _around(self) -> Mapping[str, list[_Stranger]]:
        found: dict[str, list[_Stranger]] = {}
        for stranger in self._all:
            if stranger.namespace is not None:
                found.setdefault(stranger.namespace, []).append(stranger)
        return found

    @cached_property
    def _anywhere(self) -> list[_Stranger]:
        return [each for each in self._all if each.namespace is None]

    @cached_property
    def _global(self) -> list[_Stranger]:
        return [each for each in self._all if each.namespace]

    @cached_property
    def _doubts(self) -> Mapping[str, Mapping[Doubt, str]]:
        """The names that are known in part, with the node of the first: by their last parts where those are known, else under nothing."""
        found: dict[str, dict[Doubt, str]] = {}
        for instance in self._instances:
            for doubt in instance.doubts:
                if doubt.category == self._category:
                    last = doubt.pattern.rpartition("/")[2]
                    found.setdefault("" if "*" in last else last, {}).setdefault(doubt, instance.name)
        return found


class _Said:
    """What the launch file says of the names of its nodes, worked out when it is asked for and once for all categories."""

    def __init__(self, launch: Launch, instances: tuple[Instance, ...], parameters: Parameters, earlier: Earlier) -> None:
        self._parameters = parameters
        self._earlier = earlier
        self._launch = launch
        self._known = {each.name for each in instances if not each.is_unknown}
        self._found: dict[int, tuple[frozenset[str], frozenset[str]]] = {}

    def stranger(self, instance: Instance, category: str) -> _Stranger | None:
        """The node as a stranger in ``category``; None where nothing of that is hidden."""
        if instance.is_unknown:
            reason = f"it is not known what {instance.name} does: {instance.reason}"
        elif category in instance.open:
            reason = f"{instance.name} may have more {category}: {instance.open[category]}"
        else:
            return None
        if id(instance) not in self._found:
            own = self._parameters.is_of(instance.name, instance.node)
            self._found[id(instance)] = self._earlier.with_params(instance, partial(self._below, instance.name), _names_of, own=own)
        names, moved = self._found[id(instance)]
        anything = not (instance.is_unknown or instance.literals)
        anywhere = anything or UNKNOWN_NAMESPACE in instance.namer.namespace
        namespace = None if anywhere else instance.namer.namespace.rstrip("/")
        return _Stranger(Possible(instance.name, reason, False, anything), namespace, names, moved)

    def _below(self, name: str) -> Mapping[str, Any]:
        """The values of the params below a node."""
        below = islice(self._parameters.below(name), _MOST_VALUES)
        return {full: self._parameters.value(full) for full in below if _NO_TOPIC not in full}

    @cached_property
    def params(self) -> frozenset[str]:
        """The names with more than one part in params that are not private to a node that is known: any node may read those."""
        found: set[str] = set()
        for name, setting in islice(self._launch.parameters.items(), MOST_LOOKED_AT * _MOST_VALUES):
            if name.rpartition("/")[0] not in self._known and isinstance(setting.value, str) and _NO_TOPIC not in name:
                found.update(each for each in _names([setting.value], "/", "/") if each.count("/") > 1)
        return frozenset(found)


def _names_of(instance: Instance, params: Mapping[str, Any]) -> tuple[frozenset[str], frozenset[str]]:
    """The names that something says it has, and those that its remaps lead away from it; ``params`` are its own."""
    namer, node = instance.namer, instance.node
    own = [applied for applied in namer.remappings.values() if applied.rule.remap is None or _is_inside(applied.rule.remap.origin, node)]
    targets = {applied.target for applied in own}
    moved = frozenset(namer.remappings) - {applied.target for applied in namer.remappings.values()}
    try:
        words = split_words(node.arguments)
    except ValueError:
        words = []
    texts = [part for word in words[:_MOST_VALUES] if ":=" not in word for part in word.split("=")]
    texts += [text for value in params.values() for text in _texts(value)]
    names = set(_names(texts, namer.namespace, namer.private))
    names |= targets
    names.update(f"{target.rpartition('/')[0]}/camera_info" for target in targets)  # image_transport takes it from beside the image
    return frozenset(namer.moved(name) for name in names), moved


def _is_inside(origin: Any, node: Any) -> bool:
    """Whether a ``<remap>`` stands inside the ``<node>``: those around it stand before it, or in another file."""
    at, home = origin.place, node.origin.place
    return at.source is home.source and at.span.start > home.span.start and origin.step is node.origin.step


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, list):
        yield from (each for each in value[:_MOST_VALUES] if isinstance(each, str))


def _names(texts: Iterable[str], namespace: str, node: str) -> Iterator[str]:
    """What ``texts`` that may be names stand for: relative and private ones may be meant either way."""
    for text in texts:
        if _NAME.fullmatch(text) is not None:
            yield absolute(text, namespace, node)
            if not text.startswith(("~", "/")):
                yield absolute(f"~{text}", namespace, node)


def _says(doubt: Doubt, name: str) -> bool:
    """Whether what is known of the doubt's name says that it may well be ``name``: more than a letter or two of its last part."""
    last = name.rpartition("/")[2]
    known = doubt.pattern.rpartition("/")[2].replace("*", "")
    return len(known) > 2 and known in last


class Unseen:
    """All that may be there although the graph of one launch does not show it."""

    def __init__(self, launch: Launch, instances: tuple[Instance, ...], parameters: Parameters, earlier: Earlier) -> None:
        said = _Said(launch, instances, parameters, earlier)
        self._strangers = {category: Strangers(category, launch, instances, said) for category in CATEGORIES}
        self._known: dict[tuple[str, str, str, bool], tuple[Possible, ...]] = {}

    def who(self, kind: str, name: str, type_: str, *, offers: bool) -> tuple[Possible, ...]:
        """Who could offer (publish, serve) or use a ``topic``, ``service`` or ``action`` of that name and type (empty: any).

        Those of which something says so come first; at most MOST_ANSWERS. Several rules ask the same: it is worked out once.
        """
        key = (kind, name, type_, offers)
        if key not in self._known:
            self._known[key] = self._who(kind, name, type_, offers=offers)
        return self._known[key]

    def _who(self, kind: str, name: str, type_: str, *, offers: bool) -> tuple[Possible, ...]:
        found: dict[str, Possible] = {}
        for category in _CATEGORIES[kind, offers]:
            of_action = category == "actions" and kind == "topic"
            if of_action and name.rpartition("/")[2] not in _ACTION:
                continue
            for possible in islice(self._strangers[category].who(name, "" if of_action else type_), MOST_ANSWERS):
                known = found.setdefault(possible.reason, possible)
                if possible.named and not known.named:
                    found[possible.reason] = possible
        return tuple(sorted(found.values(), key=lambda each: not each.named)[:MOST_ANSWERS])

    def has(self, category: str, name: str) -> bool:
        """Whether some name of which only a part is known may be ``name``."""
        return next(self._strangers[category].doubted(name, ""), None) is not None
