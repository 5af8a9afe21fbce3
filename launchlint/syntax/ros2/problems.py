"""What launch's front ends refuse in a launch file as it is written: one class for each kind of :class:`~launchlint.problem.Problem`.

``refused`` is set on all of them but :class:`UnreadText`: each alone is enough for launch to refuse the file.
"""

from __future__ import annotations

from launchlint.problem import Problem

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    from launchlint.syntax.ros2.description import Text

    Where = Literal["tag", "attribute", "substitution", "words"]
    Broken = Literal["any-all", "modules", "number", "flag"]
    Form = Literal["from-and-name", "neither", "substs-without-from", "value-and-nested", "type-and-nested", "empty"]
    Shape = Literal["entities", "entity", "children", "mapping", "one-action"]


class MalformedXml2(Problem):
    """The file is not well-formed XML: fields as in :class:`launchlint.syntax.problems.MalformedXml`."""

    message: str
    code: str
    hint: str
    opened: str
    closed: str


class MalformedYaml(Problem):
    """The file is no YAML that launch loads: ``message`` in plain words, ``reason`` as in :class:`~launchlint.yaml.refusals.YamlError`."""

    message: str
    reason: str


class WrongRoot(Problem):
    """The document element, or the only key of the YAML mapping, is not ``launch``.

    ``tag`` is the one that stands there; empty where YAML has no key (``keys`` 0) or several.
    """

    tag: str
    keys: int = 1


class UnknownAction(Problem):
    """A tag that launch does not know, in ``parent``, which may have ``known`` ones; ``child``: it stands where no actions do."""

    tag: str
    parent: str
    known: tuple[str, ...]
    child: bool = False


class MisplacedEntity(Problem):
    """A tag that launch knows, and not in ``parent``.

    ``holders`` are the tags that take it inside; ``action``: it stands where actions do. ``known`` are those that ``parent`` takes.
    """

    tag: str
    parent: str
    holders: tuple[str, ...]
    action: bool
    known: tuple[str, ...]


class OfRos1(Problem):
    """What belongs to launch files of ROS 1; ``instead`` is the way of ROS 2, empty where it has none.

    ``renamed`` is the name that it has in ROS 2 if that is all there is to it; ``words`` are what stands behind the name of a substitution.
    """

    tag: str
    what: Literal["tag", "attribute", "substitution"]
    construct: str
    instead: str
    renamed: str = ""
    words: str = ""


class UnreadAttribute(Problem):
    """An attribute (in YAML: a key) that launch does not read.

    ``known`` are those of the tag that are not given yet, ``given`` those that are; ``owners`` the tags that have one of this name.
    """

    tag: str
    attribute: str
    known: tuple[str, ...]
    given: tuple[str, ...]
    owners: tuple[str, ...]


class LacksAttribute(Problem):
    """An attribute that must be there and is not; ``given`` are those that are. ``child``: it is an inner tag that must be there."""

    tag: str
    attribute: str
    given: tuple[str, ...]
    child: bool = False


class BothConditions(Problem):
    """``if`` and ``unless`` on one element, at the second of the two."""

    tag: str


class WrongValue(Problem):
    """A ``value`` as written that the attribute does not take; ``expected`` says in words what it does."""

    tag: str
    attribute: str
    value: str
    expected: str
    choices: tuple[str, ...] = ()


class NegativeValue(Problem):
    """A number of seconds below zero."""

    tag: str
    attribute: str
    value: str


class OpenQuote(Problem):
    """A command line that cannot be split into words, for this ``reason``."""

    tag: str
    attribute: str
    reason: str


class WantsText(Problem):
    """YAML has a value that is no text where launch takes only text; ``found`` says what it is (``an integer``)."""

    tag: str
    attribute: str
    found: str


class WantsFraction(Problem):
    """YAML has an integer where launch takes only a number with a point."""

    tag: str
    attribute: str
    value: str


class YamlForm(Problem):
    """YAML of another form than launch reads here.

    ``shape`` says which: a list of mappings (``entities``), each item one (``entity``), actions as a list or under ``children``, a mapping,
    one action with one key.
    """

    tag: str
    attribute: str
    shape: Shape


class ParameterForm(Problem):
    """A ``<param>`` with attributes that do not go together, or too few of them: see ``form``."""

    form: Form


class UnreadableSubstitution(Problem):
    """What begins like a substitution and cannot be read: ``reason`` in plain words; ``text`` is the whole value."""

    text: str
    reason: str


class UnknownSubstitution(Problem):
    """A substitution whose name launch does not know; ``words`` are what is written behind it, joined."""

    name: str
    words: str
    known: tuple[str, ...]


class SubstitutionArity(Problem):
    """A substitution with ``count`` words, where it takes ``fewest`` to ``most``."""

    name: str
    count: int
    fewest: int
    most: int


class NotInDistribution(Problem):
    """What this ``distro`` does not have, and another has ``since`` it (``later``: one newer than the tables).

    ``sure``: no update of the distribution can have brought it. ``words`` are those of a substitution.
    """

    sure: bool
    what: Where
    name: str
    tag: str
    distro: str
    since: str
    words: tuple[Text, ...] = ()


class BrokenInFrontend(Problem):
    """What launch has, and its front ends for XML and YAML cannot make.

    ``any-all``: these two substitutions; ``modules``: the second word of ``$(eval …)`` is computed; ``number`` and ``flag``:
    the attribute ``name`` is.
    """

    what: Broken
    name: str


class KeyTwice(Problem):
    """A key that stands twice in one mapping of YAML: launch sees the last one. ``same``: both have the same value."""

    key: str
    same: bool


class UnreadText(Problem):
    """Text between the tags of XML, in ``parent``: launch reads none. ``behind_tag``: nothing stands between it and the end of a tag."""

    text: str
    parent: str
    behind_tag: bool


class TooDeep(Problem):
    """Tags that stand in each other deeper than launch's recursion reaches."""

    deepest: int
