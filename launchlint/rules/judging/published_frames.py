"""The transforms that the nodes of a launch publish, as far as the library and plain robot descriptions say."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.graph.command_line import command_line
from launchlint.graph.connections import ConnectionGraph, Instance
from launchlint.graph.frames import Frame
from launchlint.graph.urdf import LARGEST, Joint, joints
from launchlint.model import Command
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.pose import Pose, pose_of_joint, pose_of_words
from launchlint.words import split_words
from launchlint.workspace.looking import note
from launchlint.workspace.reading import read_bytes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

STATIC = frozenset({"tf/static_transform_publisher", "tf2_ros/static_transform_publisher"})
TOPICS = ("/tf", "/tf_static")


class Published(NamedTuple):
    """A transform that ``instance`` publishes. ``topic`` is where, without ``_static``; frames have no ``/`` before them.

    ``certain``: it is published whenever the node runs and has what it needs. ``upon``: the topic without whose messages it is not.
    ``pose``: where the child is in its parent, where that never changes and is known.
    """

    instance: Instance
    topic: str
    parent: str
    child: str
    certain: bool
    upon: str = ""
    pose: Pose | None = None


def bare(frame: str) -> str:
    """A frame as tf knows it: a ``/`` before it is taken off."""
    return frame.removeprefix("/")


def has_prefix(graph: ConnectionGraph) -> bool:
    """Whether a ``tf_prefix`` is set anywhere: then frames have other names than their params say."""
    return any(name.endswith("/tf_prefix") for name in graph.launch.parameters) or any(
        "tf_prefix" in instance.node.arguments for instance in graph.instances
    )


def published(graph: ConnectionGraph) -> Iterator[Published]:
    """All transforms of which parent and child are known, in the order of the nodes."""
    for instance in graph.instances:
        for frame in instance.frames:
            if frame.role != "child":
                continue
            if frame.urdf:
                for child, joint in (description(graph, frame) or {}).items():
                    yield Published(
                        instance,
                        topic(instance),
                        bare(joint.parent),
                        bare(child),
                        frame.certain and joint.fixed,
                        "",
                        pose_of_joint(joint.origin) if joint.fixed else None,
                    )
            elif frame.name and frame.parent:
                heard = _heard(instance, frame)
                yield Published(instance, topic(instance), bare(frame.parent), bare(frame.name), frame.certain, heard, _pose(instance))


def _pose(instance: Instance) -> Pose | None:
    """What a static_transform_publisher is told."""
    if instance.program not in STATIC:
        return None
    line = command_line(instance.node)
    words = [word for word in line.words if isinstance(word, str)] if line.known else []
    return pose_of_words(words[: -3 if instance.program == "tf/static_transform_publisher" else -2])


def _heard(instance: Instance, frame: Frame) -> str:
    """The topic after whose messages a transform is published, after remapping."""
    heard = (each.name for each in instance.endpoints if each.role == "subscriber" and each.unremapped == frame.upon)
    return next(heard, "") if frame.upon else ""


def topic(instance: Instance) -> str:
    """Where a node publishes its transforms, after remapping."""
    names = (endpoint.name for endpoint in instance.endpoints if endpoint.role == "publisher" and endpoint.unremapped in TOPICS)
    return next(names, TOPICS[0]).removesuffix("_static")


def description(graph: ConnectionGraph, frame: Frame) -> Mapping[str, Joint] | None:
    """The joints of the robot description that the node reads; None where it cannot be read as it stands."""
    setting = graph.parameters.setting(frame.urdf)
    value = None if setting is None else setting.value
    text = _printed(value.line) if isinstance(value, Command) else value
    return joints(text) if isinstance(text, str) else None


def _printed(line: str) -> str | None:
    """What ``cat FILE`` prints."""
    try:
        words = split_words(line)
        if len(words) != 2 or words[0] not in ("cat", "/bin/cat") or not words[1].startswith("/"):
            return None
        note((words[1],))
        return read_bytes(words[1], LARGEST).decode("utf-8")
    except (OSError, ValueError):
        return None
