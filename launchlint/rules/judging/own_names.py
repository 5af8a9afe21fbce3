"""The names in the code of one node: what a remap can act on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.graph.connections import Doubt, Endpoint, Instance, Reading
from launchlint.graph.names import absolute
from launchlint.library.template import Template, is_template, parse
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.library.lookup import Library


class OwnNames(NamedTuple):
    """The names of a node: place on the graph before remapping → how the code says it, or a remap must where that means another name there.

    ``below`` are names with more beneath them.

    ``derived`` are those that the code makes from others, ``used`` the names on the graph after remapping; ``otherwise`` are names that
    it would have if it were started in another way.
    """

    spelled: Mapping[str, str]
    below: tuple[str, ...]
    derived: frozenset[str]
    used: frozenset[str]
    otherwise: tuple[Doubt, ...]


def own_names(instance: Instance, library: Library) -> OwnNames | None:
    """The names of a node; None where they are not all known, params apart."""
    if (
        instance.is_unknown
        or instance.open.keys() - {"params"}
        or not instance.certain
        or instance.kind == "manager"
        or instance.client == "none"
    ):
        return None  # a manager's remaps act on whatever is loaded into it
    if not instance.node.knows("arguments", "name", "namespace", "remaps"):
        return None
    namer = instance.namer
    spelled: dict[str, str] = dict(instance.looked_up)
    derived: set[str] = set()
    below: set[str] = set()
    used: set[str] = set()
    entries: list[Endpoint | Reading] = [*instance.endpoints, *instance.readings]
    for entry in entries:
        used.add(entry.name)
        plain = absolute(entry.declared, namer.namespace, namer.node)
        spelled[plain] = entry.declared if absolute(entry.declared, namer.home, namer.node) == plain else plain
        if entry.unremapped != plain:
            derived.add(entry.unremapped)
            spelled.setdefault(entry.unremapped, _relative(entry.unremapped, instance))
        elif "{remap:" in entry.declaration.name or "{parent:" in entry.declaration.name:
            derived.add(plain)
        for applied in entry.applied:
            spelled.setdefault(applied.source, _relative(applied.source, instance))
        if entry.declaration.transport or entry.declaration.type == "dict":
            below.update((plain, entry.name))
    return OwnNames(spelled, tuple(below), frozenset(derived), frozenset(used), tuple(_otherwise(instance, library)))


def _otherwise(instance: Instance, library: Library) -> Iterator[Doubt]:
    """What the program would have with other args and params, ``*`` for what these would fill in."""
    node, namer = instance.node, instance.namer
    for program in (library.executable(node.package, node.executable), library.nodelet(instance.program)):
        if program is None:
            continue
        for variant in program.variants:
            for entry in variant.declarations:
                if entry.condition is None and entry.each is None and len(program.variants) == 1 and not is_template(entry.name):
                    continue
                parts = parse(entry.name) if is_template(entry.name) else (entry.name,)
                for pattern in _patterns(parts):
                    full = pattern if pattern.startswith("*") else absolute(pattern, namer.namespace, namer.node)
                    yield Doubt(entry.category, full, entry.name)
                    if entry.category == "actions" or entry.transport:
                        yield Doubt(entry.category, f"{full}/*", entry.name)


def _patterns(parts: Template) -> Iterator[str]:
    """What a name may be, ``*`` for what is filled in; of one that is filled in as a whole what it is where nothing is given."""
    whole = parts[0] if len(parts) == 1 else ""
    for each in (parts, () if isinstance(whole, str) else whole.default or ()):
        pattern = "".join(part if isinstance(part, str) else "*" for part in each)
        if pattern.strip("*/~"):
            yield pattern


def _relative(full: str, instance: Instance) -> str:
    return full.removeprefix(instance.namer.home.rstrip("/") + "/")
