"""The fix of a loose end whose name is one letter away from the only one that it can have been meant for."""

from __future__ import annotations

from functools import cached_property

from launchlint.finding import Fix, Severity
from launchlint.graph.connections import Endpoint, Instance, Reading
from launchlint.graph.names import absolute, kind
from launchlint.library.template import Slot, is_template, parse
from launchlint.named_tuple import NamedTuple
from launchlint.rules.edits import append_child, fix, remove_element, set_value, spot
from launchlint.rules.judging.loose_ends import Missed
from launchlint.rules.judging.name_places import TALKS, is_of_ros1, new_remap, write_remap
from launchlint.rules.judging.near_names import SLIP
from launchlint.rules.view import GraphView
from launchlint.source import Place
from launchlint.syntax.ros1.substitutions import opens
from launchlint.syntax.tree import Attribute


class _End(NamedTuple):
    """An end, its node, and the name that it is to have."""

    end: Endpoint
    instance: Instance
    name: str


class Repairs:
    """The fixes of the loose ends of one launch."""

    def __init__(self, view: GraphView) -> None:
        self._view = view

    def of(self, missed: Missed) -> Fix | None:
        """What joins the two ends: another name in the ``<remap>`` or ``<param>`` that makes one of them, else a new ``<remap>``.

        None where the other end is not the only one that is so near, where the name is not written out in a launch file, and in ROS 2,
        whose launch files are written in several languages.
        """
        if missed.how != SLIP or not missed.only or missed.level < Severity.WARNING or not is_of_ros1(missed.instance):
            return None
        wrong = self._wrong(missed)
        for way in (self._in_remap, self._in_param):
            for each in wrong:
                found = way(*each)
                if found is not None:
                    return found
        return self._remapped(*wrong[0])

    def _wrong(self, missed: Missed) -> list[_End]:
        """The end that is misspelt; both where that cannot be told, as of two that nobody else uses."""
        mine = _End(missed.end, missed.instance, missed.other.name)
        theirs = _End(missed.other, missed.partner, missed.end.name)
        if not missed.loose:
            return [mine]
        parts, others = set(missed.end.name.split("/")), set(missed.other.name.split("/"))
        known, others_known = parts - others <= self._words, others - parts <= self._words
        return [mine, theirs] if known == others_known else [theirs] if known else [mine]

    @cached_property
    def _words(self) -> frozenset[str]:
        """The parts of all names that come from code and from namespaces, not from remaps and params."""
        instances = self._view.graph.instances
        names = {each.unremapped for instance in instances for each in instance.endpoints if not is_template(each.declaration.name)}
        names.update(instance.name for instance in instances)
        return frozenset(part for name in names for part in name.split("/"))

    @cached_property
    def _remapped_by(self) -> dict[Place, set[str]]:
        """For each ``<remap>`` the nodes of which it makes a name."""
        found: dict[Place, set[str]] = {}
        for instance in self._view.graph.instances:
            entries: list[Endpoint | Reading] = [*instance.endpoints, *instance.readings]
            for applied in (each for entry in entries for each in entry.applied):
                if applied.rule.remap is not None:
                    found.setdefault(applied.rule.remap.origin.place, set()).add(instance.name)
        return found

    def _in_remap(self, end: Endpoint, instance: Instance, name: str) -> Fix | None:
        """The ``<remap>`` that makes the name of ``end``, and of no other node's, leads to ``name``."""
        remap = end.applied[0].rule.remap if len(end.applied) == 1 and end.applied[0].target == end.name else None
        if remap is None or len(self._remapped_by[remap.origin.place]) > 1:
            return None
        at = spot(self._view, remap.origin.place)
        to = at.element.attributes.get("to") if at is not None else None
        if to is None or not _is_literal(to):
            return None
        changes = _changes(end, name)
        if end.unremapped == name:
            return fix(f"remove the remap of {remap.source}", remove_element(at), safe=False, changes=changes)
        written = _spelled(to.value.strip(), end.name, name, instance)
        return fix(f'write to="{written}"', set_value(at, written, to), safe=False, changes=changes) if written else None

    def written(self, end: Endpoint, instance: Instance, name: str) -> str:
        """What to write so that ``end`` gets the name ``name``, for people: in the param that holds it, where one does."""
        full = self._param(end, instance)
        if full is None:
            return write_remap(end, instance, name)
        return f'let the param {full} hold "{_spelled(end.declared, end.name, name, instance) or name}"'

    def _param(self, end: Endpoint, instance: Instance) -> str | None:
        """The param (in full) whose value is the name of ``end``, where the launch sets it."""
        template = end.declaration.name
        slots = parse(template) if is_template(template) else ()
        if end.applied or len(slots) != 1 or not isinstance(slots[0], Slot) or slots[0].kind != "param":
            return None
        full = instance.namer.resolve(slots[0].key).name
        setting = self._view.graph.parameters.setting(full)
        return full if setting is not None and setting.value == end.declared else None

    def _in_param(self, end: Endpoint, instance: Instance, name: str) -> Fix | None:
        """The ``<param>`` that holds the name of ``end``, and that no other node reads, holds ``name``."""
        full, graph = self._param(end, instance), self._view.graph
        setting = None if full is None else graph.parameters.setting(full)
        if full is None or setting is None or setting.tag != "param":
            return None
        if any(reading.node != end.node for reading in graph.readers.get(full, ())):
            return None
        at = spot(self._view, setting.origin.place)
        value = at.element.attributes.get("value") if at is not None else None
        written = _spelled(end.declared, end.name, name, instance)
        if value is None or not _is_literal(value) or not written:
            return None
        return fix(f'write value="{written}"', set_value(at, written, value), safe=False, changes=_changes(end, name))

    def _remapped(self, end: Endpoint, instance: Instance, name: str) -> Fix | None:
        """A new ``<remap>`` in the ``<node>`` of ``end``, whose name is that of its code."""
        place = instance.node.origin.place
        if end.applied or instance.kind == "manager" or is_template(end.declaration.name):
            return None
        if sum(each.node.origin.place == place for each in self._view.graph.instances) > 1:
            return None
        source, target = new_remap(end, instance, name)
        child = f'<remap from="{source}" to="{target}"/>'
        at = spot(self._view, place)
        return fix(f"put {child} into the <node>", append_child(at, child), safe=False, changes=_changes(end, name))


def _spelled(written: str, current: str, wanted: str, instance: Instance) -> str:
    """``wanted`` as it is to be written in place of ``written``, which stands for ``current``: relative, private or global as that is.

    Global where it lies somewhere else; empty where it is not known what ``written`` is relative to.
    """
    namer = instance.namer
    if absolute(written, namer.namespace, namer.private) != current:
        return ""
    for way, mark, around in (("relative", "", namer.namespace), ("private", "~", namer.private)):
        inside = f"{around.rstrip('/')}/"
        if kind(written) == way and wanted.startswith(inside) and wanted[len(inside) :][:1].isalpha():
            return mark + wanted[len(inside) :]
    return wanted


def _is_literal(attribute: Attribute) -> bool:
    return attribute.raw == attribute.value and not opens(attribute.value)


def _changes(end: Endpoint, name: str) -> str:
    return f"{end.node} {TALKS[end.role]} {name}"
