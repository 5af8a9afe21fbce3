"""What of a launch file is not in the one that is written, and what stands in it in another way: in words for people."""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.loops import is_loop

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.syntax.ros2.description import Action


class Lost(NamedTuple):
    """Something that is not in what is written: ``what`` and ``why`` in plain words; at ``place`` in the original."""

    place: Place
    what: str
    why: str

    @property
    def words(self) -> str:
        """Both, without the place."""
        return f"{self.what}: {self.why}" if self.why else self.what


class Remark(NamedTuple):
    """What is written in another way, and means the same only where ``words`` hold."""

    place: Place
    words: str


class Left(Exception):
    """This part cannot be carried over, or has no counterpart; ``why`` in plain words."""

    def __init__(self, place: Place, why: str) -> None:
        super().__init__(why)
        self.place = place
        self.why = why


def shown(place: Place) -> str:
    """What is written at a place, in one line."""
    return cut(" ".join(place.text.split()))


def cut(text: str) -> str:
    """A text, or how it begins."""
    return text if len(text) <= 60 else f"{text[:57]}…"


def no_tag(action: Action) -> str:
    """Why an action has no tag."""
    if isinstance(action, described.Handler):
        return f"what follows an event ({action.event}) cannot be said in XML and YAML"
    if isinstance(action, (described.Maybe, described.Open)):
        return action.reason
    if isinstance(action, described.Fails):
        return "launch stops here"
    return "it is never called as this is exported" if isinstance(action, described.Opaque) else "XML and YAML have nothing for it"


_WORDS = {
    "Handler": "an event handler",
    "Opaque": "a function",
    "Transition": "a transition of lifecycle nodes",
    "Maybe": "what may be there",
    "Open": "what else may be there",
    "Fails": "the rest",
    "Argument": "an arg",
    "Let": "a let",
    "Include": "an include",
    "Group": "a group",
    "Executable": "an executable",
    "Component": "a composable node",
    "LoadComponents": "a load_composable_node",
    "Process": "a process",
    "Remap": "a remap",
    "Pair": "a pair",
    "PushNamespace": "a push_ros_namespace",
    "SetUseSimTime": "a set_use_sim_time",
    "Timer": "a timer",
    "Log": "a log",
}


def in_words(item: Any) -> str:
    """A part of a launch file in words."""
    if isinstance(item, described.Node):
        name = item.name.literal if item.name is not None else None
        executable = item.executable.literal
        return f"the node {name or executable}" if name or executable else "a node"
    if isinstance(item, described.Opaque) and is_loop(item):
        return "a loop"
    return _WORDS.get(type(item).__name__, type(item).__name__)
