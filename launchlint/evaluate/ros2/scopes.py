"""What launch keeps to put it back later, and what is in force where two ways meet of which it is not known which one was taken.

A scope begins when the configurations and the environment are put on two stacks, and ends when they are taken off: a group does both, and
a program may do either by itself (``launch.actions.PushLaunchConfigurations`` and the like). Behind what may not have been executed a value
is known only where both ways give the same; a stack is compared from its top, since that is where it is taken from.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TypeVar

from launchlint.model import Remap, Unknown
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.context import Setting, Value
    from launchlint.evaluate.ros2.parameters import GlobalSource


class SavedConfigurations(NamedTuple):
    """The configurations as they were put on the stack, with the lists of remaps and params, which are configurations to launch, too.

    ``unread``, ``written`` and ``added`` are those of the context. Unless it is ``sure``, there may be no such thing on the stack.
    """

    configurations: dict[str, Setting]
    remaps: list[Remap] | None
    parameters: list[GlobalSource] | None
    remaps_count: int
    parameters_count: int
    unread: bool
    written: set[str]
    added: set[str]
    sure: bool = True


class SavedEnvironment(NamedTuple):
    """The environment likewise, as what differs from that of the start."""

    changes: dict[str, Value | None]
    unread: bool
    sure: bool = True


class Moment(NamedTuple):
    """All that is in force at one moment; ``written`` and ``placed`` say what had been set until then (see Uses)."""

    configurations: dict[str, Setting]
    remaps: list[Remap] | None
    parameters: list[GlobalSource] | None
    remaps_then: tuple[Remap, ...]
    parameters_then: tuple[GlobalSource, ...]
    environment: dict[str, Value | None]
    unread: bool
    unread_environment: bool
    here: tuple[Value | None, Value | None]
    saved: tuple[SavedConfigurations, ...]
    saved_environments: tuple[SavedEnvironment, ...]
    written: frozenset[str]
    placed: bool


_Saved = TypeVar("_Saved", SavedConfigurations, SavedEnvironment)


def either_stack(one: Sequence[_Saved], other: Sequence[_Saved], either: Callable[[_Saved, _Saved], _Saved]) -> list[_Saved]:
    """What is on a stack of which it is not known whether it is the ``one`` or the ``other``."""
    lower, higher = sorted((one, other), key=len)
    below = len(higher) - len(lower)
    found = [each._replace(sure=False) if each.sure else each for each in higher[:below]]
    for mine, yours in zip(lower, higher[below:], strict=True):
        found.append(mine if mine is yours else either(mine, yours))
    return found


def either_setting(name: str, one: Setting | None, other: Setting | None, reason: str) -> Setting:
    """A configuration that is what the ``one`` or the ``other`` way gives, of which None does not set it; they are not the same."""
    last = other if other is not None else one
    assert last is not None
    steer = last.steer if one is None or other is None else one.steer | other.steer
    return last._replace(value=Unknown(name, reason), steer=steer, same=None)


def either_configurations(one: SavedConfigurations, other: SavedConfigurations, reason: str) -> SavedConfigurations:
    """What is on one place of the stack where it is not known which of both."""
    before, after = one.configurations, other.configurations
    settings = {
        name: before[name]
        if is_same(before.get(name), after.get(name))
        else either_setting(name, before.get(name), after.get(name), reason)
        for name in (*before, *(name for name in after if name not in before))
    }
    remaps, parameters = one.remaps, one.parameters
    if other.remaps is not remaps:
        remaps = doubtful_remaps((*(one.remaps or ()), *(other.remaps or ())))
    if other.parameters is not parameters:
        parameters = doubtful_parameters((*(one.parameters or ()), *(other.parameters or ())), reason)
    return SavedConfigurations(
        settings,
        remaps,
        parameters,
        len(remaps or ()),
        len(parameters or ()),
        one.unread or other.unread,
        other.written,
        other.added,
        one.sure and other.sure,
    )


def either_environment(one: SavedEnvironment, other: SavedEnvironment, reason: str) -> SavedEnvironment:
    """The same for the environment."""
    changes = either_changes(one.changes, other.changes, reason)
    return SavedEnvironment(changes, one.unread or other.unread, one.sure and other.sure)


def either_changes(one: Mapping[str, Value | None], other: Mapping[str, Value | None], reason: str) -> dict[str, Value | None]:
    """The environment that is the ``one`` or the ``other``."""
    return {
        name: one[name] if name in one and name in other and one[name] == other[name] else Unknown(name, reason)
        for name in (*one, *(name for name in other if name not in one))
    }


def is_same(one: Setting | None, other: Setting | None) -> bool:
    """Whether it makes no difference which of both counts."""
    return one is other or (one is not None and other is not None and isinstance(one.value, str) and one.value == other.value)


def doubtful_remaps(remaps: Iterable[Remap]) -> list[Remap]:
    """Remaps that may be there."""
    return [each if each.patterns is not None else Remap("", "", each.origin, (each.source, each.target)) for each in remaps]


def doubtful_parameters(parameters: Iterable[GlobalSource], reason: str) -> list[GlobalSource]:
    """Params and files of params that may be there."""
    return [each.doubted(reason) for each in parameters]
