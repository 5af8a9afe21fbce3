"""What the format allows but makes an entry useless: names listed twice, references that lead nowhere, defaults that can never be used.

Only ``launchlint library validate`` asks: a library with such a fault can be read.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Iterator, Mapping

from launchlint.library.condition import pattern_of
from launchlint.library.format import KINDS, LISTS
from launchlint.library.lookup import LONGEST_LIKE, table_of
from launchlint.library.template import Slot, Template, is_template, parse
from launchlint.library.validate import MOST_PROBLEMS, Fault, Path
from launchlint.machinery import ACTION_TOPICS, EVERYWHERE
from launchlint.model import ROS1, ROS2
from launchlint.spelling import did_you_mean

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    FindPackage = Callable[[str, str], Mapping[str, Any] | None]

_WHOM = {ROS1: "the ROS master", ROS2: "other nodes"}
_LITERAL = re.compile(r"[\w/~]*", re.ASCII)
_LITERAL_OF_PARAM = re.compile(r"[^\s{}]*")


def inconsistencies(document: Mapping[str, Any], elsewhere: FindPackage) -> list[Fault]:
    """What is of no use in a (validated) library, in the order of the document; at most :data:`MOST_PROBLEMS`.

    Args:
        document: the library.
        elsewhere: finds packages that are not in it, by name and middleware: those of the library that launchlint ships.
    """
    found: list[Fault] = []
    for fault in _packages(document["packages"], elsewhere):
        found.append(fault)
        if len(found) == MOST_PROBLEMS:
            break
    return found


def _packages(packages: Mapping[str, Any], elsewhere: FindPackage) -> Iterator[Fault]:
    for package, known in packages.items():
        middleware = known.get("middleware", ROS1)
        family = _Family(packages, middleware, elsewhere)
        for table in KINDS:
            for name, program in known.get(table, {}).items():
                path = ("packages", package, table, name)
                yield from _program(program, path, middleware)
                if "like" in program:
                    yield from _like(program, path, family)


def _program(program: Mapping[str, Any], path: Path, middleware: str) -> Iterator[Fault]:
    variants = program.get("variants")
    if "like" in program:
        others = [key for key in ("variants", "options", "status") if key in program]
        if others:
            yield Fault((*path, others[0]), f"`like` says all there is to say: {others[0]} beside it has no effect")
            return
    elif not variants and "removed" not in program and program.get("status") != "failed" and program.get("class") != "none":
        yield Fault(path, 'this says nothing: give it `variants` or `like`; a program that is no node has "class": "none"')
    for name, variant in (variants or {}).items():
        here = (*path, "variants", name)
        if name == "default" and "match" in variant:
            yield Fault((*here, "match"), "the variant default stands where no other one does: its `match` is never asked")
        elif name != "default" and "match" not in variant:
            yield Fault(here, f"the variant {_quoted(name)} is never chosen: only default does without `match`, the condition for it")
        if program.get("class") == "none" and any(variant.get(category) for category in LISTS):
            yield Fault(here, f"a program of class none never talks to {_WHOM[middleware]}, so it cannot have these names")
        options = program.get("options")
        yield from _options_of_condition(variant.get("match"), options, (*here, "match"))
        for category in LISTS:
            yield from _entries(category, variant, options, (*here, category), middleware)


def _entries(category: str, variant: Mapping[str, Any], options: Any, path: Path, middleware: str) -> Iterator[Fault]:
    seen: dict[str, int] = {}
    everywhere = EVERYWHERE[middleware]
    derived = _derived(category, variant) if middleware == ROS1 else {}
    for index, entry in enumerate(variant.get(category, ())):
        here = (*path, index)
        name = entry["name"]
        same = json.dumps([entry.get(key) for key in ("name", "role", "node", "condition", "each")], sort_keys=True)
        if same in seen:
            yield Fault(
                here, f"{_quoted(name)} stands in this list already, as number {seen[same] + 1}: join the two, or give each a condition"
            )
        seen.setdefault(same, index)
        if name in everywhere.get(category, ()):
            yield Fault((*here, "name"), f"every node has {name}: leave it out")
        elif name in derived:
            yield Fault((*here, "name"), f"{_quoted(name)} follows from the action {_quoted(derived[name])}: leave it out")
        if entry.get("exists", "constructed") != "constructed" and not variant.get("lifecycle"):
            yield Fault((*here, "exists"), 'only nodes with a lifecycle are configured and activated: the variant lacks "lifecycle": true')
        yield from _options_of_condition(entry.get("condition"), options, (*here, "condition"))
        literal = _LITERAL_OF_PARAM if category == "params" and middleware == ROS2 else _LITERAL
        for key in ("name", "type", "parent"):
            if is_template(entry.get(key, "")):
                yield from (Fault((*here, key), said) for said in _template(parse(entry[key]), entry.get("each"), options, literal))
        if "each" in entry and not any(slot.kind == "each" for slot in _slots(parse(name))):
            yield Fault((*here, "each"), "each of these things gives the same name: put {each} into the name")


def _derived(category: str, variant: Mapping[str, Any]) -> Mapping[str, str]:
    """The names of a category that follow from actions, with the action."""
    found = {}
    for action in variant.get("actions", ()):
        for topic in ACTION_TOPICS.get(action["role"], {}).get(category, ()):
            found[f"{action['name'].rstrip('/')}/{topic}"] = action["name"]
    return found


def _template(parts: Template, each: Any, options: Any, literal: re.Pattern[str]) -> Iterator[str]:
    """What is of no use in a name or type with templates."""
    slots = list(_slots(parts))
    for part in _literals(parts):
        if not literal.fullmatch(part):
            yield f"{_quoted(part)} cannot be a part of a name: letters, digits, _, / and ~ can"
    for slot in slots:
        if slot.kind == "option" and slot.key not in (options or {}):
            yield f"{_spelled(slot)} has no value: {_option_advice(slot.key, options)}"
        if slot.kind == "each" and each is None:
            yield f"{_spelled(slot)} has no value: the entry has no `each`"
        elif slot.kind == "each" and slot.key and not _is_member(slot.key, each):
            yield f"{_spelled(slot)} has no value: only the things of a param have members, and args that are `like` a pattern"
        elif slot.kind == "each" and not slot.key and slot.default is not None:
            yield "{each} always has a value: its default is never used"
        for inner in _slots(slot.default or ()):
            if inner.default is None and _implied(slot, (inner,)):
                yield f"the default of {_spelled(slot)} is asked for only where {_spelled(inner)} has no value either"
    direct = [part for part in parts if isinstance(part, Slot)]
    needed = [slot for slot in direct if slot.default is None]
    for slot in direct:
        if slot.default is not None:
            implying = _implied(slot, needed)
            if implying is not None:
                yield f"the default of {_spelled(slot)} is never used: without {_spelled(implying)} there is no name at all"
            elif slot.kind == "arg" and each is not None and 0 < int(slot.key) <= each.get("args", 0):
                yield f"the default of {_spelled(slot)} is never used: `each` goes through later arguments"


def _is_member(key: str, each: Any) -> bool:
    pattern = pattern_of(each.get("like", ""))
    return "param" in each or (pattern is not None and key in pattern.groupindex)


def _implied(slot: Slot, needed: Iterable[Slot]) -> Slot | None:
    """The slot of ``needed`` that has a value only where ``slot`` has one."""
    for other in needed:
        if other.kind == slot.kind and other.kind in ("arg", "option", "param", "each"):
            later = slot.kind == "arg" and (0 < int(slot.key) <= int(other.key) or 0 > int(slot.key) >= int(other.key))
            if other.key == slot.key or later:
                return other
    return None


def _slots(parts: Template) -> Iterator[Slot]:
    """All slots of a template, also those inside others."""
    for part in parts:
        if isinstance(part, Slot):
            yield part
            yield from _slots(part.inner)
            yield from _slots(part.default or ())


def _literals(parts: Template) -> Iterator[str]:
    for part in parts:
        if isinstance(part, str):
            yield part
        else:
            yield from _literals(part.inner)
            yield from _literals(part.default or ())


def _spelled(slot: Slot) -> str:
    return f"{{{slot.kind}{':' if slot.key else ''}{slot.key}}}"


def _options_of_condition(condition: Any, options: Any, path: Path) -> Iterator[Fault]:
    if condition is None:
        return
    if "option" in condition and condition["option"] not in (options or {}):
        name = condition["option"]
        yield Fault((*path, "option"), f"the option {_quoted(name)} is never given: {_option_advice(name, options)}")
    if "not" in condition:
        yield from _options_of_condition(condition["not"], options, (*path, "not"))
    for kind in ("all", "any"):
        for index, each in enumerate(condition.get(kind, ())):
            yield from _options_of_condition(each, options, (*path, kind, index))


def _option_advice(name: str, options: Any) -> str:
    if not options:
        return "the program has no `options`, so every argument is positional"
    return did_you_mean(name, options) or f"`options` has {', '.join(options)}"


class _Family:
    """The programs of a middleware in this library and in the one that launchlint ships, for ``like``."""

    def __init__(self, packages: Mapping[str, Any], middleware: str, elsewhere: FindPackage) -> None:
        self._packages = {name: known for name, known in packages.items() if known.get("middleware", ROS1) == middleware}
        self._middleware = middleware
        self._elsewhere = elsewhere

    def table(self, table: str, like: str) -> str:
        return table_of(like, table, self._middleware)

    def executable(self, package: str, like: str) -> tuple[str, str]:
        other, slash, name = like.partition("/")
        return (other, name) if slash else (package, like)

    def nodelet(self, like: str) -> tuple[str, str]:
        own = [package for package in sorted(self._packages) if like in self._packages[package].get("nodelets", ())]
        return (own[0] if own else like.partition("/")[0]), like

    def program(self, package: str, table: str, name: str) -> Mapping[str, Any] | None:
        found: Mapping[str, Any] | None = self.programs(package, table).get(name)
        return found

    def programs(self, package: str, table: str) -> Mapping[str, Any]:
        known = self._packages[package] if package in self._packages else self._elsewhere(package, self._middleware)
        programs: Mapping[str, Any] = (known or {}).get(table, {})
        return programs


def _like(program: Mapping[str, Any], path: Path, family: _Family) -> Iterator[Fault]:
    """Whether ``like`` leads to a program that says something itself."""
    _, package, table, name = (str(step) for step in path)
    seen = [(package, name)]
    step = program
    while "like" in step:
        place = family.nodelet(step["like"]) if table == "nodelets" else family.executable(seen[-1][0], step["like"])
        if place in seen:
            yield Fault((*path, "like"), "`like` leads in a circle: " + " → ".join(_quoted(each[1]) for each in (*seen, place)))
            return
        if len(seen) > LONGEST_LIKE:
            yield Fault((*path, "like"), f"`like` leads over more than {LONGEST_LIKE} programs: name the last one directly")
            return
        table = family.table(table, place[1])
        found = family.program(place[0], table, place[1])
        if found is None:
            what = KINDS[table]
            hint = did_you_mean(place[1], family.programs(place[0], table))
            where = "" if table == "nodelets" else f"of the package {place[0]} "
            yield Fault(
                (*path, "like"),
                f"there is no {what} {_quoted(place[1])} {where}here or in the bundled library{'; ' + hint if hint else ''}",
            )
            return
        seen.append(place)
        step = found


def _quoted(text: str) -> str:
    return json.dumps(text if len(text) <= 80 else f"{text[:77]}…", ensure_ascii=False)
