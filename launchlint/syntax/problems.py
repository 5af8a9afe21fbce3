"""What can be wrong with a launch file as it is written: one class for each kind of :class:`~launchlint.problem.Problem`."""

from __future__ import annotations

from launchlint.problem import Problem

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    Conflict = Literal[
        "respawn-and-required",
        "param-sources",
        "empty-ns",
        "clear-params-without-ns",
        "clear-params-without-name",
        "test-attribute",
        "delete-with-file",
    ]
    Ineffective = Literal[
        "respawn-delay-without-respawn",
        "negative-respawn-delay",
        "required-on-test",
        "condition-on-launch",
        "empty-group",
        "empty-rosparam",
    ]


class UnreadableFile(Problem):
    """There is no file, or no text in it, for this ``reason``."""

    reason: str


class MalformedXml(Problem):
    """The file is not well-formed XML.

    ``message`` is in plain words, ``code`` expat's name of the error (or ``RecursionError``), ``hint`` may be empty; ``opened`` and
    ``closed`` are tag names, empty where it is not about tags.
    """

    message: str
    code: str
    hint: str
    opened: str
    closed: str


class RootNotLaunch(Problem):
    """The file has not exactly one ``<launch>``, or another element around it: ``tag`` of the root, and ``count`` of ``<launch>``."""

    tag: str = ""
    count: int = 0


class UnknownTag(Problem):
    """A tag that nobody knows; ``known`` are the tags allowed in ``parent``, ``ignored`` says that roslaunch says nothing at all."""

    tag: str
    parent: str
    known: tuple[str, ...]
    ignored: bool


class MisplacedTag(Problem):
    """A tag that does not belong in ``parent``, which starts at ``within`` (-1 for the file itself).

    ``name`` is what it names, if anything; ``reported`` says that roslaunch warns of it.
    """

    tag: str
    name: str
    parent: str
    within: int
    reported: bool


class UnknownAttribute(Problem):
    """An attribute that the tag does not have.

    ``known`` are the attributes of the tag that are not given yet, ``owners`` the tags that have this attribute; ``silent``
    says that roslaunch never checks it (attributes of ``<launch>``).
    """

    tag: str
    attribute: str
    known: tuple[str, ...]
    owners: tuple[str, ...]
    silent: bool


class MissingAttribute(Problem):
    """An attribute that must be there and is not."""

    tag: str
    attribute: str


class InvalidValue(Problem):
    """A ``value`` (resolved) that the attribute does not take: ``expected`` says in words what it does."""

    tag: str
    attribute: str
    value: str
    expected: str
    choices: tuple[str, ...] = ()


class IfAndUnless(Problem):
    """Both conditions on one element, at the second of the two."""

    tag: str


class ConflictingAttributes(Problem):
    """``attributes`` that exclude each other; at the last of them, at the tag name if there are none.

    roslaunch refuses it for each ``reason``. ``param-sources``: those given are none or several. ``environment``: an unset variable made
    the namespace of ``empty-ns`` empty.
    """

    tag: str
    attributes: tuple[str, ...]
    reason: Conflict
    environment: bool = False


class ArgValueAndDefault(Problem):
    """An arg (its name as written) with both, at the second of the two."""

    name: str


class IneffectiveAttribute(Problem):
    """An attribute, or an element (``attribute`` is empty then), that is accepted and has no effect."""

    tag: str
    attribute: str
    reason: Ineffective


class DeprecatedConstruct(Problem):
    """What ROS has given up: ``<master>``, ``machine env``, ``machine ros-root`` (and the other ros-*), ``rosparam ns``, ``xacro.py``."""

    construct: str
    instead: str


class WrongDialect(Problem):
    """What belongs to another dialect; ``instead`` is the way of this one (may be empty)."""

    tag: str
    what: Literal["tag", "attribute", "substitution"]
    construct: str
    instead: str


class StrayText(Problem):
    """Text that nobody reads.

    ``because`` is ``tag`` where the tag takes no text at all, or what makes this rosparam ignore its text: ``file``, ``dump``, ``delete``.
    ``behind_tag``: nothing stands between it and the end of a tag.
    """

    text: str
    parent: str
    because: str
    behind_tag: bool
