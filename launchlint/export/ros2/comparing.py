"""Whether two descriptions say the same, and whether two launches are the same, wherever and however they are written."""

from __future__ import annotations

import re
from collections.abc import Mapping

from launchlint.export.ros2.texts import joined
from launchlint.fix.meaning import Exact
from launchlint.model import Node, ParameterSource, Unknown, UnknownText
from launchlint.source import Origin, Place, Source
from launchlint.syntax.ros2.description import Substitution, Text, TypedValue

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import Any

    from launchlint.model import Launch
    from launchlint.syntax.ros2.description import Action

_WRITTEN = str.maketrans("", "", "'\"\\")
_KINDS = {"equals": "if", "not-equals": "unless"}
_OF_PLACES = ("origin", "places", "scope", "environment", "patterns", "own_origins", "own_as")


def normal(actions: Sequence[Action | Text]) -> list[object]:
    """All that is described, without places, in a line: equal for equal actions, however deep these are."""
    found: list[object] = []
    waiting: list[object] = list(reversed(actions))
    while waiting:
        item = waiting.pop()
        if isinstance(item, Place):
            continue
        if isinstance(item, Text):
            pieces = joined(item.pieces)
            found.append(("Text", len(pieces)))
            waiting.extend(reversed(pieces))
        elif isinstance(item, TypedValue):
            found.append(("TypedValue", item.type))
            waiting.extend(reversed(_value(item)))
        elif isinstance(item, Substitution):
            found.append((item.name, len(item.arguments)))
            waiting.extend(reversed(item.arguments))
        elif isinstance(item, tuple):
            found.append((type(item).__name__, len(item)))
            waiting.extend(reversed(item))
        else:
            found.append(Exact(item))
    return found


def _value(value: TypedValue) -> list[object]:
    """The texts of a value that are computed, and what is known of the others."""
    if isinstance(value.value, Text):
        return [value.value if value.plain is None else Exact(value.plain)]
    plain = value.plain if isinstance(value.plain, tuple) else (None,) * len(value.value)
    return [len(plain), *(text if known is None else Exact(known) for text, known in zip(value.value, plain, strict=True))]


def launched(launch: Launch, names: Mapping[str, str]) -> dict[str, list[Any]]:
    """What is started, set and declared, by what it is, in order; ``names`` are names of files that stand for others."""
    return {
        "refusal": sorted(problem.kind for problem in launch.problems if problem.refused),
        "arg": [_plain((*each, each.argument.name, each.argument.value, each.argument.default), names) for each in launch.declarations],
        "listed arg": [_plain(each, names) for each in launch.listed],
        "include": [_plain((each.file, each.namespace, each.arguments, each.pushed, each.deferred), names) for each in launch.includes],
        "node": [_node(each, names) for each in launch.nodes],
        "executable": [_by_field(each, names) for each in launch.programs],
        "late refusal": sorted(problem.kind for problem in launch.late),
        "completeness": [launch.complete],
    }


def started(launch: Launch) -> dict[str, list[Any]]:
    """The same of what is started alone, whichever file says so, and whatever conditions it has met."""
    found = launched(launch, {})
    for each in (*found["node"], *found["executable"]):
        del each["file"]
        each["conditions"] = "assumed" in each["conditions"]
    return {kind: found[kind] for kind in ("refusal", "node", "executable", "late refusal", "completeness")}


def renumbered(found: Mapping[str, list[Any]]) -> str:
    """All of it as text, with the names that ``$(anon)`` makes up numbered in the order in which they stand there."""
    numbers: dict[str, int] = {}
    return re.sub(r"_anon(\d+)", lambda match: f"_anon#{numbers.setdefault(match[1], len(numbers) + 1)}", repr(found))


def difference(before: Mapping[str, list[Any]], after: Mapping[str, list[Any]]) -> str:
    """What differs first, in one plain sentence without a full stop; empty where nothing does."""
    for kind, old in before.items():
        new = after[kind]
        if old == new:
            continue
        for number, (one, other) in enumerate(zip(old, new)):  # noqa: B905 - the shorter one ends it
            if one != other:
                return f"{kind} {number + 1} would differ{_fields(one, other)}"
        if len(old) > len(new):
            return f"{kind} {len(new) + 1} of {len(old)} would be missing: {str(old[len(new)])[:200]}"
        return f"there would be one more {kind}: {str(new[len(old)])[:200]}"
    return ""


def _fields(one: Any, other: Any) -> str:
    if not isinstance(one, dict) or not isinstance(other, dict):
        return f": {str(one)[:150]} before, {str(other)[:150]} after"
    name = next(name for name in one if one[name] != other.get(name))
    return f" in {name}: {str(one[name])[:150]} before, {str(other.get(name))[:150]} after"


def _node(node: Node, names: Mapping[str, str]) -> dict[str, Any]:
    found = _by_field(node, names)
    found["kind"] = "node" if node.kind == "lifecycle" else node.kind  # launch has states for it, and starts the same
    found["sources"] = _merged(node.sources, names)
    for role in node.unknown:  # their fields hold what is written
        found.pop(role, None)
        if role == "arguments" and isinstance(found["process"], tuple):
            found["process"] = None
    return found


def _by_field(item: Any, names: Mapping[str, str]) -> dict[str, Any]:
    found = {name: _plain(value, names) for name, value in zip(item._fields, item, strict=True) if name not in _OF_PLACES}
    found["conditions"] = ["assumed" if each.assumed else _KINDS.get(each.attribute, each.attribute) for each in item.conditions]
    return found


def _merged(sources: Iterable[ParameterSource], names: Mapping[str, str]) -> list[Any]:
    """What params come from; of several files beside each other that launch writes for the same node, one."""
    found: list[Any] = []
    for each in sources:
        content = _of_one_node(each.content)
        before = found[-1] if found else None
        if content is not None and each.of is None and isinstance(before, tuple) and before[0] == content[0]:
            before[1].update(content[1])
        elif content is not None and each.of is None:
            found.append((content[0], dict(content[1])))
        else:
            found.append(_plain((each.file, each.content, each.rule, each.of), names))
    return [_plain(each, names) for each in found]


def _of_one_node(content: object) -> tuple[str, dict[str, Any]] | None:
    if not isinstance(content, dict) or len(content) != 1:
        return None
    ((key, inner),) = content.items()
    values = inner.get("ros__parameters") if isinstance(inner, dict) else None
    return (str(key), values) if isinstance(values, dict) else None


def _plain(value: Any, names: Mapping[str, str]) -> Any:
    """``value`` without places; of what is not known, why."""
    if isinstance(value, (Place, Origin)):
        return None
    if isinstance(value, Source):
        return names.get(value.file, value.file)
    if isinstance(value, (Unknown, UnknownText)):
        return ("unknown", value.reason)
    if isinstance(value, str):
        text = names.get(value, value)
        return text.translate(_WRITTEN) if "$(" in text else text
    if isinstance(value, Mapping):
        return sorted(((_plain(key, names), _plain(inner, names)) for key, inner in value.items()), key=repr)
    if isinstance(value, (list, tuple)):
        return tuple(_plain(each, names) for each in value)
    return Exact(value)
