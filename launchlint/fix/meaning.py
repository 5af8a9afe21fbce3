"""Everything roslaunch would do with a launch file, without where it is written: two texts mean the same where this is equal."""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable

from launchlint.model import Command, Condition, Include, Launch, Node, Remap, ScopedSetting, Unknown
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Facts = tuple[tuple[str, Any], ...]


class Meaning(NamedTuple):
    """What one entry file does in one configuration; equal (``==``) for equal effects.

    ``refused``: the kinds of all problems for which roslaunch refuses the file. ``arguments``: what the file can be given, with defaults
    and fixed values, in no order. ``nodes`` and ``tests``: in the order they are started, each with its remaps and environment in order.
    ``parameters``: final values by name with their exact types. ``nested``: in the order they are set, the names of parameters below
    which there are others (roslaunch.parent: what is set last wins there). ``commands``: the ``command=`` lines in the order roslaunch runs
    them. ``steps``: the rosparam dump and delete steps. ``left_open``: what could not be followed or decided, with all that would act
    on it.
    """

    refused: tuple[str, ...]
    arguments: tuple[Facts, ...]
    nodes: tuple[Facts, ...]
    tests: tuple[Facts, ...]
    parameters: Facts
    nested: tuple[str, ...]
    commands: Facts
    clear_params: tuple[str, ...]
    machines: Facts
    steps: tuple[tuple[str, str, str], ...]
    left_open: tuple[Facts, ...]


class Exact(str):
    """How Python writes a value: ``1``, ``1.0``, ``True`` and ``'1'`` are four of them, though 1 == 1.0 == True."""

    __slots__ = ()

    def __new__(cls, value: object) -> Exact:
        """Of ``value``."""
        if isinstance(value, Unknown):
            return super().__new__(cls, f"what is not known here, {value.text!r} ({value.reason})")
        return super().__new__(cls, repr(value))

    def __repr__(self) -> str:
        return str(self)


def meaning(launch: Launch) -> Meaning:
    """What ``launch`` does, without places. Never raises."""
    return Meaning(
        refused=tuple(sorted(problem.kind for problem in launch.problems if problem.refused)),
        arguments=_arguments(launch),
        nodes=tuple(_node(node) for node in launch.nodes),
        tests=tuple(_node(test) for test in launch.tests),
        parameters=tuple((name, Exact(launch.parameters[name].value)) for name in sorted(launch.parameters)),
        nested=_nested(launch.parameters),
        commands=tuple((each.name, each.value.line) for each in launch.parameter_settings if isinstance(each.value, Command)),
        clear_params=tuple(namespace for namespace, _ in launch.clear_params),
        machines=tuple((name, Exact(launch.machines[name][:-1])) for name in sorted(launch.machines)),
        steps=launch.executables,
        left_open=tuple(_left_open(launch)),
    )


def difference(before: Meaning, after: Meaning) -> str:
    """One plain sentence (no full stop) on what differs first; empty where nothing does."""
    for field, one, singular in _FIELDS:
        old, new = getattr(before, field), getattr(after, field)
        if old != new:
            found: str = one(old, new, singular)
            return found
    return ""


def _arguments(launch: Launch) -> tuple[Facts, ...]:
    own = (each for each in launch.declared if each.origin.step is None and not each.passed and not each.in_group)
    return tuple(sorted((("name", each.name), ("value", Exact(each.value)), ("default", Exact(each.default))) for each in own))


_NODE_FIELDS = (
    "package", "executable", "machine", "arguments", "output", "respawn", "respawn_delay", "required", "cwd", "launch_prefix",
    "test_name", "time_limit", "retry",
)  # fmt: skip


def _node(node: Node) -> Facts:
    facts: list[tuple[str, Any]] = [("name", node.full_name)]
    facts += [(field, getattr(node, field)) for field in _NODE_FIELDS]
    facts += [
        ("remaps", _remaps(node)),
        ("environment", tuple((setting.name, setting.value) for setting in node.environment)),
        ("unknown", tuple(sorted(node.unknown))),
        ("conditions of unknown value", _assumed(node.conditions)),
    ]
    return tuple(facts)


def _remaps(node: Node) -> tuple[tuple[str, str], ...]:
    """The remaps in order, without those of a name to itself: they do nothing, unless another remap has the same source."""
    pairs = [(remap.source, remap.target) for remap in node.remaps]
    if not node.knows("name", "namespace", "remaps"):
        return tuple(pairs)
    count = Counter(_resolved(source, node) for source, _ in pairs)
    return tuple((source, target) for source, target in pairs if source != target or count[_resolved(source, node)] > 1)


def _resolved(name: str, node: Node) -> str:
    if name.startswith("/"):
        return name
    return f"{node.full_name}/{name[1:].lstrip('/')}" if name.startswith("~") else f"{node.namespace}{name}"


def _assumed(conditions: tuple[Condition, ...]) -> tuple[tuple[str, str], ...]:
    return tuple((each.attribute, each.place.text.strip()) for each in conditions if each.assumed)


def _nested(names: Iterable[str]) -> tuple[str, ...]:
    """Of ``names``, in their order, those above or below another one: where roslaunch sets ``/a`` and ``/a/b``, the order counts."""
    listed = list(names)
    known = set(listed)
    family: set[str] = set()
    for name in listed:
        outer = name.rpartition("/")[0]
        while outer:
            if outer in known:
                family.update((name, outer))
            outer = outer.rpartition("/")[0]
    return tuple(name for name in listed if name in family)


def _left_open(launch: Launch) -> Iterable[Facts]:
    """Includes that could not be followed; and where there are any, or conditions of unknown value, every setting that may act there.

    A remap, an ``env`` or a ``~param`` acts on what follows it in its scope, so it is told with the number of such includes it covers.
    """
    followed = set(launch.files)
    unfollowed = [each for each in launch.includes if each.source is None or each.file not in followed]
    undecided = any(branch.taken is None for branch in launch.branches)
    for namespace in launch.more_parameters:
        yield (("name", "parameters of unknown names"), ("namespace", namespace.rstrip("/") or "/"))  # as roslaunch.names.ns_join takes it
    if not unfollowed and not undecided and launch.complete:
        return
    starts = _starts(unfollowed)
    for each in unfollowed:
        passed = tuple(sorted((name, _text(value)) for name, value in each.arguments.items()))
        yield (
            ("name", each.file), ("namespace", each.namespace), ("arguments", passed), ("pass_all_args", each.pass_all_args),
            ("conditions of unknown value", _assumed(each.conditions)),
        )  # fmt: skip
    for setting in launch.settings:
        yield (
            ("name", setting.key), ("kind", setting.kind), ("value", _value(setting)), ("includes", _covered(setting, starts)),
            ("conditions of unknown value", _assumed(setting.conditions)),
        )  # fmt: skip
    for parameter in launch.parameter_settings:
        yield (
            ("name", parameter.name), ("value", Exact(parameter.value)), ("conditions of unknown value", _assumed(parameter.conditions)),
        )  # fmt: skip


def _value(setting: ScopedSetting) -> str:
    return setting.value.target if isinstance(setting.value, Remap) else _text(setting.value)


def _text(value: object) -> str:
    return value if isinstance(value, str) else repr(value)


def _starts(includes: Iterable[Include]) -> dict[int, list[int]]:
    """For each file as it was entered (the identity of its include step), the offsets of the includes that lead to ``includes``."""
    found: dict[int, set[int]] = {}
    for include in includes:
        place, step = include.origin
        while True:
            offsets = found.setdefault(id(step), set())
            if place.span.start in offsets:
                break
            offsets.add(place.span.start)
            if step is None:
                break
            place, step = step
    return {key: sorted(offsets) for key, offsets in found.items()}


def _covered(setting: ScopedSetting, starts: dict[int, list[int]]) -> int:
    offsets = starts.get(id(setting.origin.step), [])
    return bisect_left(offsets, setting.scope_end) - bisect_left(offsets, setting.origin.place.span.start)


# -- in words ------------------------------------------------------------------------------------------------------


def _kinds(old: tuple[str, ...], new: tuple[str, ...], _: str) -> str:
    if not old:
        return f"roslaunch would refuse the file ({_plain(_first_extra(new, old))})"
    if not new:
        return f"roslaunch would no longer refuse the file ({_plain(_first_extra(old, new))})"
    extra = _first_extra(new, old)
    if extra:
        return f"roslaunch would refuse the file for another reason ({_plain(extra)})"
    return f"roslaunch would no longer see one reason to refuse the file ({_plain(_first_extra(old, new))})"


def _plain(kind: str) -> str:
    return kind.replace("-", " ")


def _first_extra(longer: tuple[str, ...], shorter: tuple[str, ...]) -> str:
    return next(iter(Counter(longer) - Counter(shorter)), "")


def _items(old: tuple[Facts, ...], new: tuple[Facts, ...], singular: str) -> str:
    names, names_after = (tuple(str(dict(each)["name"]) for each in items) for items in (old, new))
    gone, extra = _first_extra(names, names_after), _first_extra(names_after, names)
    if gone:
        return f"the {singular} {gone!r} would be gone"
    if extra:
        return f"there would be another {singular} {extra!r}"
    for name, name_after, before, after in zip(names, names_after, old, new, strict=True):
        if name != name_after:
            return f"the order of the {_plural(singular)} would change, beginning with {name!r}"
        for (field, was), (_, becomes) in zip(before, after, strict=False):
            if was != becomes:
                return f"the {singular} {name!r} would change: {field.replace('_', ' ')} from {_shown(was)} to {_shown(becomes)}"
        if before != after:
            return f"the {singular} {name!r} would change"
    return ""


def _plural(singular: str) -> str:
    return singular + "s"


def _values(old: Facts, new: Facts, singular: str) -> str:
    before, after = dict(old), dict(new)
    for name in sorted({*before, *after}):
        if name not in after:
            return f"the {singular} {name!r} would be gone"
        if name not in before:
            return f"there would be another {singular} {name!r}"
        if before[name] != after[name]:
            return f"the {singular} {name!r} would change from {_shown(before[name])} to {_shown(after[name])}"
    return ""


def _order(old: tuple[Any, ...], new: tuple[Any, ...], singular: str) -> str:
    gone, extra = Counter(old) - Counter(new), Counter(new) - Counter(old)
    if not gone and not extra:
        return f"the order of the {_plural(singular)} would change"
    if gone:
        return f"the {singular} {_shown(next(iter(gone)))} would be gone"
    return f"there would be another {singular} {_shown(next(iter(extra)))}"


def _shown(value: object) -> str:
    if value in (None, ()):
        return "nothing"
    text = repr(value)
    return text if len(text) <= 120 else f"{text[:117]}…"


_FIELDS = (
    ("refused", _kinds, ""),
    ("arguments", _items, "arg"),
    ("nodes", _items, "node"),
    ("tests", _items, "test"),
    ("parameters", _values, "parameter"),
    ("nested", _order, "nested parameter"),
    ("commands", _order, "param command"),
    ("clear_params", _order, "cleared namespace"),
    ("machines", _values, "machine"),
    ("steps", _order, "rosparam step"),
    ("left_open", _items, "unresolved item"),
)
