"""What a remap, env or ``~param`` that stands outside a node acts on."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator

from launchlint.model import Launch, ScopedSetting

_STARTS = frozenset(("node", "test", "group", "include"))


def settings_of(launch: Launch, kind: str) -> Iterator[tuple[ScopedSetting, bool | None]]:
    """Each setting of ``kind`` with whether it acts on any node; None where that cannot be known.

    It cannot be known where the setting itself stands under a condition of unknown value, or where an element behind it in its scope that
    may hold nodes is left out by its condition: what one switches off by hand (``if="false"``) may come back as well. An include that
    could not be followed counts as a node. A setting that a later one of its scope replaces is left out where it acts on nothing.
    """
    replaced = {setting.replaced.key for setting in launch.settings if setting.replaced is not None}
    leaked = {setting.origin.place.key for setting in launch.parameter_settings if setting.node is not None} if kind == "param" else set()
    left_out: dict[int, list[int]] | None = None
    for setting in launch.settings:
        if setting.kind != kind:
            continue
        if setting.reached or setting.origin.place.key in leaked:
            yield setting, True
        elif setting.origin.place.key not in replaced:
            if left_out is None:
                left_out = _left_out(launch)
            unsure = any(condition.assumed for condition in setting.conditions) or _may_reach(setting, left_out)
            yield setting, None if unsure else False


def _left_out(launch: Launch) -> dict[int, list[int]]:
    """Where elements that may hold nodes are left out by their conditions: sorted offsets by source.

    For one that stands in an included file, the ``<include>`` elements that lead to it count too.
    """
    found: dict[int, set[int]] = {}
    for branch in launch.branches:
        skipped = branch.taken is False or (branch.taken is None and branch.attribute == "unless")
        if skipped and branch.tag in _STARTS:
            for place in (branch.element, *branch.origin.chain):
                found.setdefault(id(place.source), set()).add(place.span.start)
    return {source: sorted(starts) for source, starts in found.items()}


def _may_reach(setting: ScopedSetting, left_out: dict[int, list[int]]) -> bool:
    """Whether something is left out behind the setting, in its scope."""
    source, span = setting.origin.place
    starts = left_out.get(id(source), [])
    after = bisect_right(starts, span.start)
    return after < len(starts) and starts[after] < setting.scope_end
