"""What a remap, env or ``~param`` that stands outside a node acts on."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.model import Launch, ScopedSetting
from launchlint.source import Origin

_STARTS = ("<node", "<test", "<group", "<include")


def settings_of(launch: Launch, kind: str) -> Iterator[tuple[ScopedSetting, bool | None]]:
    """Each setting of ``kind`` with whether it acts on any node; None where that cannot be known.

    It cannot be known where the setting itself, or an element behind it in its scope that may hold nodes, stands under a condition that
    is not met here and may be met elsewhere. A setting that a later one of its scope replaces is left out where it acts on nothing.
    """
    replaced = {(setting.replaced.source.path, setting.replaced.span.start) for setting in launch.settings if setting.replaced is not None}
    leaked = {_key(setting.origin) for setting in launch.parameter_settings if setting.node is not None} if kind == "param" else set()
    for setting in launch.settings:
        if setting.kind != kind:
            continue
        if setting.reached or _key(setting.origin) in leaked:
            yield setting, True
        elif _key(setting.origin) not in replaced:
            unsure = any(condition.assumed for condition in setting.conditions) or _may_reach(launch, setting)
            yield setting, None if unsure else False


def _key(origin: Origin) -> tuple[str, int]:
    return (origin.place.source.path, origin.place.span.start)


def _may_reach(launch: Launch, setting: ScopedSetting) -> bool:
    """Whether nodes behind the setting, in its file or in the files included there, are left out by a condition."""
    source, span = setting.origin.place
    for branch in launch.branches:
        left_out = branch.open if branch.taken is False else branch.taken is None and branch.attribute == "unless"
        if left_out and branch.element.text.startswith(_STARTS):
            for place in (branch.element, *branch.origin.chain):
                if place.source is source and span.start < place.span.start < setting.scope_end:
                    return True
    return False
