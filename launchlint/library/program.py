"""A program's interface as the graph needs it: typed, templates parsed. Made from validated JSON when a node asks for it."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.library.condition import holds
from launchlint.library.template import is_template
from launchlint.library.terms import CATEGORIES, FRAMES
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.library.template import Situation


class Declared(NamedTuple):
    """What a node of ROS 2 says of a param when it declares it; the fields are the keys of the format.

    ``declared``: False where it only asks for it, None where that is not known.
    """

    type: str
    declared: bool | None = None
    dynamic: bool = False
    read_only: bool = False
    min: Any = None
    max: Any = None
    step: Any = None
    one_of: tuple[Any, ...] = ()


class Declaration(NamedTuple):
    """One name that a program declares; the fields are the keys of the format. ``category`` is one of CATEGORIES.

    The last ones are of ROS 2: ``qos`` has what is known of it, ``node`` is the node of the program that has the name (empty: the first).
    """

    category: str
    name: str
    type: str = ""
    md5: str = ""
    role: str = ""
    when: str = "start"
    latched: bool = False
    transport: str = ""
    condition: Any = None
    each: Any = None
    default: Any = None
    evidence: tuple[Mapping[str, str], ...] = ()
    removed: Mapping[str, str] | None = None
    by_hand: bool = False
    qos: Mapping[str, Any] | None = None
    overrides: bool = False
    node: str = ""
    exists: str = "constructed"
    declared: Declared | None = None


class FrameDeclaration(NamedTuple):
    """One coordinate frame that a program publishes (role ``child``), asks for (``used``) or writes into messages (``label``).

    The fields are the keys of the format.
    """

    name: str
    role: str
    parent: str = ""
    urdf: str = ""
    through: str = ""
    condition: Any = None
    upon: str = ""


class Variant(NamedTuple):
    """One way a program can be started. ``match`` is the condition for it (None: always); ``open`` the categories that may hold more.

    ``literals`` are texts in its sources that may be names; ``has_template``: some name depends on how it is started. In ROS 2 ``node``
    and ``namespace`` are those that the program gives itself (templates; empty: not known), ``lifecycle``: somebody has to activate it,
    ``managed``: it does that itself, or may, ``undeclared``: it takes params that it does not declare.
    """

    name: str
    match: Any
    declarations: tuple[Declaration, ...]
    open: Mapping[str, str]
    frames: tuple[FrameDeclaration, ...] = ()
    literals: tuple[str, ...] = ()
    has_template: bool = False
    node: str = ""
    namespace: str = ""
    lifecycle: bool = False
    managed: bool = False
    undeclared: bool = False


class Program(NamedTuple):
    """An executable, a nodelet class or a component. ``client`` is what the format calls ``class``; ``options`` how its args are read."""

    package: str
    name: str
    client: str
    options: Mapping[str, int] | None
    variants: tuple[Variant, ...]

    def variant(self, situation: Situation) -> tuple[Variant, ...]:
        """The variants that a node in this situation may be in: one, or more where what decides cannot be known."""
        possible = []
        for variant in self.variants:
            matched = True if variant.match is None else holds(variant.match, situation)
            if matched is not False:
                possible.append(variant)
            if matched:
                break
        return tuple(possible)


def program(package: str, name: str, data: Mapping[str, Any]) -> Program:
    """The program that validated JSON describes."""
    given = data.get("variants", {})
    variants = [_variant(key, given[key]) for key in sorted(given) if key != "default" and "match" in given[key]]
    if "default" in given or data.get("class") == "none":
        variants.append(_variant("default", {**given.get("default", {}), "match": None}))
    return Program(package, name, data.get("class", "other"), data.get("options"), tuple(variants))


def _variant(name: str, data: Mapping[str, Any]) -> Variant:
    declarations = [_declaration(category, entry) for category in CATEGORIES for entry in data.get(category, ())]
    frames = [_frame(entry) for entry in data.get(FRAMES, ())]
    return Variant(
        name,
        data.get("match"),
        tuple(declarations),
        data.get("open", {}),
        tuple(frames),
        tuple(data.get("literals", ())),
        any(is_template(each.name) for each in declarations),
        data.get("node", ""),
        data.get("namespace", ""),
        data.get("lifecycle", False),
        data.get("managed", False),
        data.get("undeclared", False),
    )


def _frame(entry: Mapping[str, Any]) -> FrameDeclaration:
    parent, urdf, through = (entry.get(key, "") for key in ("parent", "urdf", "through"))
    return FrameDeclaration(entry["name"], entry["role"], parent, urdf, through, entry.get("condition"), entry.get("upon", ""))


def _declaration(category: str, entry: Mapping[str, Any]) -> Declaration:
    return Declaration(
        category,
        entry["name"],
        entry.get("type", ""),
        entry.get("md5", ""),
        entry.get("role", ""),
        entry.get("when", "start"),
        entry.get("latched", False),
        entry.get("transport", ""),
        entry.get("condition"),
        entry.get("each"),
        entry.get("default"),
        tuple(entry.get("evidence", ())),
        entry.get("removed"),
        entry.get("by_hand", False),
        entry.get("qos"),
        entry.get("overrides", False),
        entry.get("node", ""),
        entry.get("exists", "constructed"),
        _declared(entry) if category == "params" else None,
    )


def _declared(entry: Mapping[str, Any]) -> Declared:
    dynamic, read_only = entry.get("dynamic", False), entry.get("read_only", False)
    limits = (entry.get("min"), entry.get("max"), entry.get("step"), tuple(entry.get("one_of", ())))
    return Declared(entry.get("type", ""), entry.get("declared"), dynamic, read_only, *limits)
