"""Facts and doubts of one program, as the entries of a library."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from launchlint import model
from launchlint.extract.fact import Descriptor, Doubt, Fact, Made, Qos
from launchlint.machinery import ACTION_TOPICS, EVERYWHERE
from launchlint.named_tuple import NamedTuple

CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")
LONGEST_NAME = 1_000
ANY = "{any}"
_MOST_REASONS = 4
_MOST_EVIDENCE = 12

_UNKNOWN_PARAM = re.compile(r"\{param:[^{}|]*\{any\}[^{}|]*(?:\|[^{}]*)?\}")
"""The value of a param whose name is not known: nobody can look it up."""
_EACH = re.compile(r"\{each:(~[^\s{}|]+)\}")
"""One of the values of a param that holds a list, as it is spelled before it is an entry of a library."""
_WHEN = ("start", "subscriber", "message")
_EXISTS = ("", "configured", "active")


class _Middleware(NamedTuple):
    """What differs: how names, params and types are spelled, what every node has, and which topics follow from an action."""

    name: re.Pattern[str]
    param: re.Pattern[str]
    type: re.Pattern[str]
    everywhere: Mapping[str, tuple[str, ...]]
    action_topics: Mapping[str, Mapping[str, tuple[str, ...]]]
    wider: Mapping[frozenset[str], str]
    any_type: str


_NAME = re.compile(r"[~/]?[A-Za-z0-9_][\w/]*|~|/", re.ASCII)

ROS1 = _Middleware(
    _NAME,
    _NAME,
    re.compile(r"\*|[A-Za-z]\w*/[A-Za-z]\w*", re.ASCII),
    EVERYWHERE[model.ROS1],
    ACTION_TOPICS,
    {frozenset(("int", "double")): "double"},
    "*",
)
ROS2 = _Middleware(
    _NAME,
    re.compile(r"~[^\s~/{}][^\s~{}]*"),
    re.compile(r"\*|[A-Za-z]\w*/[A-Za-z]\w*/[A-Za-z]\w*", re.ASCII),
    EVERYWHERE[model.ROS2],
    {},
    {},
    "",
)


def variant_of(
    facts: Iterable[Fact], doubts: Iterable[Doubt], source: str, middleware: _Middleware = ROS1, nodes: Sequence[Made] = ()
) -> tuple[dict[str, Any], int]:
    """What a library says of a program, and how many of its names are not known as a whole.

    Args:
        facts: its names.
        doubts: why there may be more.
        source: the id of the source that the places of the facts are in.
        middleware: ``ROS1`` or ``ROS2``.
        nodes: the nodes that it makes, in ROS 2, the first one first.
    """
    groups: dict[str, dict[tuple[str, ...], list[Fact]]] = {category: {} for category in CATEGORIES}
    reasons: dict[str, dict[str, None]] = {}
    unresolved = 0
    for fact in (each._replace(name=_one_list(_UNKNOWN_PARAM.sub(ANY, each.name))) for each in facts):
        if fact.name in middleware.everywhere.get(fact.category, ()):
            continue
        if (fact.name == ANY and not middleware.type.fullmatch(fact.type)) or not _is_name(fact, middleware):
            unresolved += 1
            reasons.setdefault(fact.category, {})[f"a name that is not known ({fact.path}:{fact.line})"] = None
        else:
            groups[fact.category].setdefault((fact.name, fact.role, fact.node, fact.type), []).append(fact)
    for doubt in doubts:
        place = f" ({doubt.path}:{doubt.line})" if doubt.path else ""
        reasons.setdefault(doubt.category, {})[f"{doubt.reason}{place}"] = None
    _without_action_topics(groups, middleware)
    called = {each.key: each.name or ANY for each in nodes if each.key}
    variant = _of_nodes(nodes)
    lists = _lists(groups["params"])
    for category in CATEGORIES:
        entries = _entries(category, groups[category], source, middleware, called)
        for entry in entries:
            entry.update(_each(entry["name"], lists))
        if entries:
            variant[category] = entries
            unresolved += sum(ANY in entry["name"] for entry in entries)
    if reasons:
        variant["open"] = {category: _said(reasons[category]) for category in CATEGORIES if category in reasons}
    return variant, unresolved


def _one_list(name: str) -> str:
    """A name that is made of values of several lists is not known: an entry goes through one of them."""
    return _EACH.sub(ANY, name) if len(set(_EACH.findall(name))) > 1 else name


def _lists(params: Mapping[tuple[str, ...], Sequence[Fact]]) -> dict[str, list[Any]]:
    """The defaults of params that are lists, by the names of the params; none where there are several."""
    found: dict[str, list[list[Any]]] = {}
    for (name, *_), facts in params.items():
        found.setdefault(name, []).extend(fact.default for fact in facts if isinstance(fact.default, list))
    return {name: defaults[0] for name, defaults in found.items() if defaults and all(each == defaults[0] for each in defaults)}


def _each(name: str, lists: Mapping[str, list[Any]]) -> dict[str, Any]:
    """What of an entry says that there is one for each value of a param."""
    param = next(iter(_EACH.findall(name)), "")
    if not param:
        return {}
    return {"name": _EACH.sub("{each}", name), "each": {"param": param, **({"default": lists[param]} if param in lists else {})}}


def _of_nodes(nodes: Sequence[Made]) -> dict[str, Any]:
    """What is said of the nodes of a program: the name of the first one; of all of them what any is.

    Who brings its second node to life, as a planner does its costmap, may well wait for somebody else to do so for itself.
    """
    first = next((each for each in nodes if not each.key), None)
    said: dict[str, Any] = {}
    if first is not None:
        said.update({key: value for key, value in (("node", first.name), ("namespace", first.namespace)) if value})
    said.update({"lifecycle": True} if any(each.lifecycle for each in nodes) else {})
    said.update({"managed": True} if any(each.managed for each in [each for each in nodes if each.lifecycle][:1]) else {})
    said.update({"undeclared": True} if any(each.undeclared for each in nodes) else {})
    return said


def _without_action_topics(groups: dict[str, dict[tuple[str, ...], list[Fact]]], middleware: _Middleware) -> None:
    """The topics of an action follow from it and are not listed; others that are called so, such as the feedback of markers, are."""
    for name, role, _, action in groups["actions"]:
        for category, endings in middleware.action_topics.get(role, {}).items():
            names = [f"{name}/{ending}" for ending in endings]
            for key in [each for each in groups[category] if each[0] in names and _is_of_action(each[3], action)]:
                del groups[category][key]


def _is_of_action(type_: str, action: str) -> bool:
    """Whether messages of ``type_`` (empty: not known) may be those of an action of the type ``action``."""
    return not (type_ and action) or type_.startswith((action, "actionlib_msgs/", "action_msgs/"))


def _is_name(fact: Fact, middleware: _Middleware) -> bool:
    name = fact.name
    if len(name) > LONGEST_NAME:
        return False
    pattern = middleware.param if fact.category == "params" else middleware.name
    return "{" in name or "}" in name or pattern.fullmatch(name) is not None


def _said(reasons: Iterable[str]) -> str:
    listed = list(reasons)
    text = "; ".join(listed[:_MOST_REASONS]) + (f"; and {len(listed) - _MOST_REASONS} more" if len(listed) > _MOST_REASONS else "")
    text = _readable(text)
    return text if len(text) <= LONGEST_NAME else text[: LONGEST_NAME - 1] + "…"


def _readable(text: str) -> str:
    """Text without what a terminal obeys or no encoding can hold."""
    return text if text.isprintable() else "".join(char if char.isprintable() else " " for char in text)


def _entries(
    category: str, groups: dict[tuple[str, ...], list[Fact]], source: str, middleware: _Middleware, called: Mapping[str, str]
) -> list[dict[str, Any]]:
    """One entry for each name, role, node and type; of those without type what is said goes to the one that has one."""
    merged: dict[tuple[str, str, str], dict[str, list[Fact]]] = {}
    for (name, role, node, type_), facts in groups.items():
        merged.setdefault((name, role, node), {}).setdefault(type_, []).extend(facts)
    entries = []
    for (_, _, node), by_type in sorted(merged.items()):
        untyped = by_type.pop("", [])
        typed = sorted(by_type.items()) or [("", [])]
        conditions = [_condition([*facts, *untyped]) for _, facts in typed]
        if len(typed) > 1 and any(conditions.count(each) > 1 for each in conditions):
            typed = [("", [fact for _, facts in typed for fact in facts])]  # one name of two types: neither is promised
        for number, (type_, facts) in enumerate(typed):
            told = [*facts, *(untyped if number == 0 else ())]
            entries.append(_entry(category, type_, told, source, middleware, called.get(node, "")))
    return entries


def _entry(category: str, type_: str, facts: Sequence[Fact], source: str, middleware: _Middleware, node: str) -> dict[str, Any]:
    entry: dict[str, Any] = {"name": facts[0].name, **({"node": node} if node else {})}
    if category == "params":
        type_ = _value_type(facts, middleware)
        defaults = [fact.default for fact in facts if fact.default is not None]
        if defaults and all(each == defaults[0] and type(each) is type(defaults[0]) for each in defaults):
            entry["default"] = defaults[0]
        entry.update(_declared(facts))
    if type_ and (category == "params" or middleware.type.fullmatch(type_) or "{" in type_):
        entry["type"] = type_
    if facts[0].role:
        entry["role"] = facts[0].role
    if category == "publishers" and any(fact.latched for fact in facts):
        entry["latched"] = True
    if category in ("publishers", "subscribers"):
        queues = {fact.queue for fact in facts if fact.queue is not None}
        if len(queues) == 1:
            entry["queue"] = queues.pop()
        if {fact.transport for fact in facts} == {"image"}:
            entry["transport"] = "image"
        qos = _qos([fact.qos or Qos() for fact in facts])
        if any(fact.qos is not None and fact.qos.overrides for fact in facts):
            entry["overrides"] = True
        if qos:
            entry["qos"] = qos
    exists = min((_EXISTS.index(fact.exists) for fact in facts if fact.exists in _EXISTS), default=0)
    if exists:
        entry["exists"] = _EXISTS[exists]
    when = min((_WHEN.index(fact.when) for fact in facts if fact.when in _WHEN), default=0)
    if when:
        entry["when"] = _WHEN[when]
    condition = _condition(facts)
    if condition is not None:
        entry["condition"] = condition
    places = dict.fromkeys(_readable(f"{source}:{fact.path}:{fact.line}") for fact in facts)
    entry["evidence"] = [{"by": "static", "at": place} for place in sorted(places)[:_MOST_EVIDENCE] if len(place) <= LONGEST_NAME]
    return entry


def _qos(said: Sequence[Qos]) -> dict[str, Any]:
    """The quality of service that all the places agree on."""
    found: dict[str, Any] = {}
    for position, key in enumerate(Qos._fields):
        values = {each[position] for each in said}
        value = values.pop()
        if key != "overrides" and not values and value is not None:
            found[key] = value
    return found


def _declared(facts: Sequence[Fact]) -> dict[str, Any]:
    """What the declarations of a param say of it."""
    said: dict[str, Any] = {}
    declared = [fact.declared for fact in facts if fact.declared is not None]
    if declared:
        said["declared"] = any(declared)
    found = next((fact.descriptor for fact in facts if fact.descriptor is not None), None) or Descriptor()
    values: tuple[tuple[str, Any], ...] = (
        ("min", found.minimum),
        ("max", found.maximum),
        ("step", found.step),
        ("one_of", list(found.one_of) or None),
        ("read_only", found.read_only or None),
        ("dynamic", found.dynamic or None),
        ("description", _readable(found.description)[:LONGEST_NAME] or None),
    )
    said.update({key: value for key, value in values if value is not None})
    return said


def _value_type(facts: Sequence[Fact], middleware: _Middleware) -> str:
    types = frozenset(fact.value_type for fact in facts if fact.value_type)
    if types in middleware.wider:
        return middleware.wider[types]
    return next(iter(types)) if len(types) == 1 else middleware.any_type if types else ""


def _condition(facts: Sequence[Fact]) -> dict[str, Any] | None:
    conditions = dict.fromkeys(fact.condition for fact in facts)
    if "" in conditions or not conditions:
        return None
    texts = sorted(_readable(each)[:LONGEST_NAME] for each in conditions)
    if len(texts) > 4:
        return {"text": f"one of {len(texts)} conditions in the source"}
    return {"text": texts[0]} if len(texts) == 1 else {"any": [{"text": each} for each in texts]}
