"""What can be wrong with the params of ROS 2 nodes when they are evaluated: one class for each kind of problem."""

from __future__ import annotations

from launchlint.problem import Problem

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal


class ParameterValueType(Problem):
    """A ``value`` that launch does not take for the param ``name``, for this ``reason``; ``type`` is what the file says it is."""

    name: str
    value: str
    type: str | None
    reason: str


class ContentNoYaml(Problem):
    """What a ``file`` of params becomes when the substitutions in it are performed is no YAML."""

    file: str
    reason: str


class ComponentFileRefused(Problem):
    """A ``file`` of params that launch itself reads for a composable node and cannot use, for this ``reason``."""

    file: str
    reason: str


# ---- what launch does not see, and rcl does


class ParametersFileDies(Problem):
    """A ``file`` of params that rcl refuses for this ``reason``, so that ``node`` dies when it starts; ``instead`` is what to write."""

    file: str
    reason: str
    node: str
    instead: str


class ParameterDies(Problem):
    """A ``<param>`` that rcl refuses for this ``reason`` when ``node`` starts, so that it dies."""

    reason: str
    node: str


class RemapDies(Problem):
    """A remap that rcl refuses for this ``reason``, so that ``node`` dies when it starts; ``side`` is the part in which that shows."""

    source: str
    target: str
    side: Literal["from", "to"]
    reason: str
    node: str


class SetParameterDies(Problem):
    """A ``<set_parameter>`` that makes every node behind it die when it starts; ``empty``: since its value is empty."""

    name: str
    value: str
    empty: bool
    reason: str


class ListBecomesText(Problem):
    """A list that ``<set_parameter>`` passes on as the text ``text``."""

    name: str
    text: str


class TextRetyped(Problem):
    """A ``value`` that is meant as a text and that a node gets as one of the ``type``; ``command_line``: through ``<set_parameter>``."""

    name: str
    value: str
    type: str
    command_line: bool


class NumberStaysText(Problem):
    """A ``value`` that every other node would get as a number, and that a composable node gets as a text."""

    name: str
    value: str
    in_file: bool


class LaterValueLost(Problem):
    """A param that the node ``node`` does not start with, although it is set later than, or for it more exactly than the one that counts.

    ``lost`` and ``kept`` are the values, ``lost_key`` and ``kept_key`` the keys of files under which they stand.
    """

    name: str
    node: str
    lost: str
    kept: str
    lost_key: str
    kept_key: str
    later: bool


class ParametersForNobody(Problem):
    """A ``file`` that is given to ``node`` and in which the key ``key`` does not reach it.

    ``reached``: something else in the file does. ``near``: the key is that of another namespace (``namespace``) or nearly the name
    (``spelling``); empty: it has nothing to do with the node. ``keys`` are those of the file. ``wildcards``: a key may have others than
    ``/**`` for this node. ``shared``: other programs are given the file, too.
    """

    file: str
    node: str
    key: str
    near: Literal["namespace", "spelling", ""]
    reached: bool
    keys: tuple[str, ...]
    wildcards: bool = True
    shared: bool = False

    def without_wildcards(self) -> ParametersForNobody:
        """The same for a composable node."""
        return ParametersForNobody(**vars(self) | {"wildcards": False})

    def among_others(self) -> ParametersForNobody:
        """The same of a file that other programs are given, too."""
        return ParametersForNobody(**vars(self) | {"shared": True})


class NamedForUnnamed(Problem):
    """A ``file`` of params under names (``keys``) that is given to a node whose name the launch does not say: its ``program`` has one.

    ``anonymous``: it has one that is made up for each start. ``certain``: whatever its name is, no key is for it, since none is in its
    ``namespace``. ``shared``: other programs are given the file, too.
    """

    file: str
    program: str
    keys: tuple[str, ...]
    namespace: str
    anonymous: bool
    certain: bool
    shared: bool = False


class CommandReadAsYaml(Problem):
    """The output of a command that writes XML, as the value of the param ``name``: launch reads it as YAML.

    ``typed``: it would take a type. ``file`` is what the command makes it from, absolute; empty where that is not known.
    """

    name: str
    typed: bool
    file: str


class ComponentKeyIgnored(Problem):
    """A ``key`` with wildcards in a ``file`` for the composable node ``node``: launch reads the file, and knows ``/**`` alone."""

    file: str
    key: str
    node: str
