"""One program read: facts and doubts become what a library says of it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from launchlint.errors import UsageError
from launchlint.extract.fact import ELSEWHERE, Doubt, Fact
from launchlint.extract.literals import SOURCE_ENDS, literals
from launchlint.extract.plan import Task
from launchlint.extract.python.modules import PackageModules
from launchlint.extract.python.program import Extracted, python_program
from launchlint.python.source import SourceError
from launchlint.workspace.looking import read_bytes, watched

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.files import Trees

CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")
LONGEST_NAME = 1_000
_MOST_REASONS = 4
_MOST_EVIDENCE = 12

_PLAIN = re.compile(r"[~/]?[A-Za-z0-9_][\w/]*|~|/", re.ASCII)
_TYPE = re.compile(r"\*|[A-Za-z]\w*/[A-Za-z]\w*", re.ASCII)
_TALKS = re.compile(rb"ros::|<ros/|\"ros/|<nodelet/|actionlib|image_transport|rclcpp")
_EVERYWHERE = {
    "publishers": ("/rosout",),
    "subscribers": ("/clock",),
    "services": ("~get_loggers", "~set_logger_level"),
    "params": ("/use_sim_time",),
}
_ACTION_TOPICS: dict[str, dict[str, tuple[str, ...]]] = {
    "server": {"subscribers": ("goal", "cancel"), "publishers": ("status", "feedback", "result")},
    "client": {"publishers": ("goal", "cancel"), "subscribers": ("status", "feedback", "result")},
    "": {},
}
_UNKNOWN_PARAM = re.compile(r"\{param:[^{}|]*\{any\}[^{}|]*(?:\|[^{}]*)?\}")
"""The value of a param whose name is not known: nobody can look it up."""
_WHEN = ("start", "subscriber", "message")


class Reading(NamedTuple):
    """What was found for one task: the program as a library has it; None where it could not be read, and then ``problem`` says why.

    ``names`` counts its entries, ``unresolved`` those of them, and of the names left open, that are not known as a whole.
    """

    task: Task
    program: dict[str, Any] | None
    problem: str
    names: int
    unresolved: int


class ProgramReader:
    """Reads programs, and keeps the files that they share: the modules of ``packages`` (directory → name), and headers."""

    def __init__(self, packages: Mapping[str, str]) -> None:
        self._finder = PackageModules(packages)
        self._trees: Trees | None = None

    def read(self, task: Task) -> Reading:
        """Read one program. Never raises for what its source says."""
        reading, looked_at = watched(lambda: _read(task, self))
        for variant in () if reading.program is None else reading.program["variants"].values():
            if "open" in variant or any("{any}" in entry["name"] for category in CATEGORIES for entry in variant.get(category, ())):
                found = literals(path for path in looked_at if os.path.splitext(path)[1] in SOURCE_ENDS)
                variant.update({"literals": found} if found else {})
        return reading

    def python(self, task: Task) -> Extracted:
        """What a program of Python says."""
        return python_program(task.sources[0], task.origin.root, task.directory, self._finder)

    def cpp(self, task: Task) -> tuple[Sequence[Fact], tuple[Doubt, ...]]:
        """What a program of C++ says."""
        from launchlint.extract.cpp import Trees, cpp_program

        if self._trees is None:
            self._trees = Trees()
        entry = task.entry or None
        return cpp_program(task.sources, task.includes, task.origin.root, entry, task.plugins, task.templates, task.packages, self._trees)


def _read(task: Task, reader: ProgramReader) -> Reading:
    options: dict[str, int] = {}
    facts: Sequence[Fact]
    try:
        if task.client == "rospy":
            found = reader.python(task)
            facts, doubts, options, silent = found.facts, found.doubts, found.options, not found.uses_rospy
        else:
            facts, doubts = reader.cpp(task)
            foreign = any(each.reason.endswith(ELSEWHERE) for each in doubts)
            silent = not facts and not foreign and not any(_TALKS.search(_bytes(path)) for path in task.sources)
    except (SourceError, UsageError) as error:
        return Reading(task, None, str(error), 0, 0)
    if task.client != "rospy" and not facts and not doubts and not silent:
        doubts = tuple(Doubt(category, "no call that makes a name was found, though ROS is used", "", 0) for category in CATEGORIES)
    doubts = (*doubts, *(Doubt(category, reason, "", 0) for reason in task.doubts for category in CATEGORIES))
    if silent and not facts and (task.client == "roscpp" or not doubts):
        return Reading(task, {"class": "none", "variants": {"default": {}}}, "", 0, 0)
    variant, unresolved = _variant(facts, doubts, task.origin.id)
    program: dict[str, Any] = {"class": task.client}
    if options:
        program["options"] = options
    program["variants"] = {"default": variant}
    return Reading(
        task, program, "", sum(entry["name"] != "{any}" for category in CATEGORIES for entry in variant.get(category, ())), unresolved
    )


def _bytes(path: str) -> bytes:
    try:
        return read_bytes(path)
    except OSError:
        return b""


def _variant(facts: Iterable[Fact], doubts: Iterable[Doubt], source: str) -> tuple[dict[str, Any], int]:
    groups: dict[str, dict[tuple[str, str, str], list[Fact]]] = {category: {} for category in CATEGORIES}
    reasons: dict[str, dict[str, None]] = {}
    unresolved = 0
    for fact in (each._replace(name=_UNKNOWN_PARAM.sub("{any}", each.name)) for each in facts):
        if fact.name in _EVERYWHERE.get(fact.category, ()):
            continue
        if (fact.name == "{any}" and not _TYPE.fullmatch(fact.type)) or not _is_name(fact.name):
            unresolved += 1
            reasons.setdefault(fact.category, {})[f"a name that is not known ({fact.path}:{fact.line})"] = None
        else:
            groups[fact.category].setdefault((fact.name, fact.role, fact.type), []).append(fact)
    for doubt in doubts:
        place = f" ({doubt.path}:{doubt.line})" if doubt.path else ""
        reasons.setdefault(doubt.category, {})[f"{doubt.reason}{place}"] = None
    _without_action_topics(groups)
    variant: dict[str, Any] = {}
    for category in CATEGORIES:
        entries = _entries(category, groups[category], source)
        if entries:
            variant[category] = entries
            unresolved += sum("{any}" in entry["name"] for entry in entries)
    if reasons:
        variant["open"] = {category: _said(reasons[category]) for category in CATEGORIES if category in reasons}
    return variant, unresolved


def _without_action_topics(groups: dict[str, dict[tuple[str, str, str], list[Fact]]]) -> None:
    """The topics of an action follow from it and are not listed."""
    for name, role, _ in groups["actions"]:
        for category, endings in _ACTION_TOPICS[role].items():
            for key in [each for each in groups[category] if each[0] in [f"{name}/{ending}" for ending in endings]]:
                del groups[category][key]


def _is_name(name: str) -> bool:
    if len(name) > LONGEST_NAME:
        return False
    return "{" in name or "}" in name or _PLAIN.fullmatch(name) is not None


def _said(reasons: Iterable[str]) -> str:
    listed = list(reasons)
    text = "; ".join(listed[:_MOST_REASONS]) + (f"; and {len(listed) - _MOST_REASONS} more" if len(listed) > _MOST_REASONS else "")
    text = _readable(text)
    return text if len(text) <= LONGEST_NAME else text[: LONGEST_NAME - 1] + "…"


def _readable(text: str) -> str:
    """Text without what a terminal obeys or no encoding can hold."""
    return text if text.isprintable() else "".join(char if char.isprintable() else " " for char in text)


def _entries(category: str, groups: dict[tuple[str, str, str], list[Fact]], source: str) -> list[dict[str, Any]]:
    """One entry for each name, role and type; of those without type what is said goes to the one that has one."""
    merged: dict[tuple[str, str], dict[str, list[Fact]]] = {}
    for (name, role, type_), facts in groups.items():
        merged.setdefault((name, role), {}).setdefault(type_, []).extend(facts)
    entries = []
    for (name, role), by_type in sorted(merged.items()):
        untyped = by_type.pop("", [])
        typed = sorted(by_type.items()) or [("", [])]
        conditions = [_condition([*facts, *untyped]) for _, facts in typed]
        if len(typed) > 1 and any(conditions.count(each) > 1 for each in conditions):
            typed = [("", [fact for _, facts in typed for fact in facts])]  # one name of two types: neither is promised
        for number, (type_, facts) in enumerate(typed):
            entries.append(_entry(category, name, role, type_, [*facts, *(untyped if number == 0 else ())], source))
    return entries


def _entry(category: str, name: str, role: str, type_: str, facts: Sequence[Fact], source: str) -> dict[str, Any]:
    entry: dict[str, Any] = {"name": name}
    if category == "params":
        type_ = _value_type(facts)
        defaults = [fact.default for fact in facts if fact.default is not None]
        if defaults and all(each == defaults[0] and type(each) is type(defaults[0]) for each in defaults):
            entry["default"] = defaults[0]
    if type_ and (category == "params" or _TYPE.fullmatch(type_) or "{" in type_):
        entry["type"] = type_
    if role:
        entry["role"] = role
    if category == "publishers" and any(fact.latched for fact in facts):
        entry["latched"] = True
    if category in ("publishers", "subscribers"):
        queues = {fact.queue for fact in facts if fact.queue is not None}
        if len(queues) == 1:
            entry["queue"] = queues.pop()
        transports = {fact.transport for fact in facts}
        if transports == {"image"}:
            entry["transport"] = "image"
    when = min((_WHEN.index(fact.when) for fact in facts if fact.when in _WHEN), default=0)
    if when:
        entry["when"] = _WHEN[when]
    condition = _condition(facts)
    if condition is not None:
        entry["condition"] = condition
    places = dict.fromkeys(_readable(f"{source}:{fact.path}:{fact.line}") for fact in facts)
    entry["evidence"] = [{"by": "static", "at": place} for place in sorted(places)[:_MOST_EVIDENCE] if len(place) <= LONGEST_NAME]
    return entry


def _value_type(facts: Sequence[Fact]) -> str:
    types = {fact.value_type for fact in facts if fact.value_type}
    if types == {"int", "double"}:
        return "double"
    return types.pop() if len(types) == 1 else "*" if types else ""


def _condition(facts: Sequence[Fact]) -> dict[str, Any] | None:
    conditions = dict.fromkeys(fact.condition for fact in facts)
    if "" in conditions or not conditions:
        return None
    texts = sorted(_readable(each)[:LONGEST_NAME] for each in conditions)
    if len(texts) > 4:
        return {"text": f"one of {len(texts)} conditions in the source"}
    return {"text": texts[0]} if len(texts) == 1 else {"any": [{"text": each} for each in texts]}
