"""What source code says of one name of a node."""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Hashable
    from typing import Any


ELSEWHERE = "which is not in these sources"
"""How the reason of a doubt ends that is about a header of a ROS package."""


class Qos(NamedTuple):
    """Quality of service as far as the source says it, in the words of the library format; None is what it does not say.

    Words and numbers may be templates: ``{param:~reliability|reliable}``. Times are in seconds. ``overrides`` says that params of the node
    may change it (``QosOverridingOptions``).
    """

    reliability: str | None = None
    durability: str | None = None
    history: str | None = None
    depth: int | str | None = None
    deadline: float | str | None = None
    lifespan: float | str | None = None
    liveliness: str | None = None
    lease: float | str | None = None
    overrides: bool = False


class Descriptor(NamedTuple):
    """What the declaration of a param of ROS 2 says beside its type and default; None is what it does not say."""

    description: str = ""
    read_only: bool = False
    dynamic: bool = False
    minimum: float | None = None
    maximum: float | None = None
    step: float | None = None
    one_of: tuple[bool | int | float | str, ...] = ()


class Fact(NamedTuple):
    """One call site that makes, or asks for, a name.

    Args:
        category: ``publishers``, ``subscribers``, ``services``, ``clients``, ``actions`` or ``params``, as in the library format.
        name: as the library format spells it: ``chatter``, ``~state``, ``/tf``, or a template such as ``{param:~topic|scan}``; parts that
            cannot be known are ``{any}``. A name of which nothing is known is ``{any}``. Params of ROS 2 are ``~base_frame``, with the dots
            that they have: ``~controller.gains.p``.
        path: the source file, relative to the directory that was given, with ``/``.
        line: from 1.
        type: ``package/Type``, of ROS 2 ``package/msg/Type``, ``package/srv/Type``, ``package/action/Type``; empty where it is not known.
        role: of actions: ``server`` or ``client``.
        transport: ``image`` where the name goes through image_transport.
        latched: of publishers.
        queue: of publishers and subscribers; None where it is not known.
        default: of params; None where there is none or it is not known.
        value_type: of params: ``bool``, ``int``, ``double``, ``str``, ``list``, ``dict``, ``*`` for any; in ROS 2 ``bool``,
            ``integer``, ``double``, ``string``, ``byte_array``, ``bool_array``, ``integer_array``, ``double_array``, ``string_array``
            or ``*``; empty where it is not known.
        condition: the source text of the conditions around the call, joined with ``and``; empty where there are none.
        when: ``start``, or ``message`` where the call stands in a callback.
        node: of programs of ROS 2, the :attr:`Made.key` of the node that the name belongs to; empty for the first one, or the only one.
        qos: of publishers and subscribers of ROS 2, where anything of it is known.
        exists: of lifecycle nodes: ``configured`` or ``active``, where the name is made with that; empty where it is there from the start.
        declared: of params of ROS 2: True where the call declares it, False where it only asks for it; None where there is no such thing.
        descriptor: of declared params.
    """

    category: str
    name: str
    path: str
    line: int
    type: str = ""
    role: str = ""
    transport: str = ""
    latched: bool = False
    queue: int | None = None
    default: Any = None
    value_type: str = ""
    condition: str = ""
    when: str = "start"
    node: str = ""
    qos: Qos | None = None
    exists: str = ""
    declared: bool | None = None
    descriptor: Descriptor | None = None


def key_of(fact: Fact) -> Hashable:
    """What is the same for facts that say the same. A truth value is not the number that Python takes for equal to it."""
    default = fact.default
    return fact[:9], fact[10:14], fact[15], default.__class__, repr(default), repr(fact.qos), repr(fact[16:])


class Made(NamedTuple):
    """One node that a program of ROS 2 makes.

    Args:
        key: what the facts of this node have as their ``node``; empty for the first one.
        name: what it calls itself where nobody gives it another name; a template where that depends on something, empty where not known.
        namespace: likewise.
        lifecycle: whether it is a lifecycle node.
        managed: whether the program itself asks it to configure or to activate.
        undeclared: whether it takes params that it does not declare.
        condition: the source text of the conditions around the call, joined with ``and``.
        path, line: where it is made.
    """

    key: str = ""
    name: str = ""
    namespace: str = ""
    lifecycle: bool = False
    undeclared: bool = False
    condition: str = ""
    path: str = ""
    line: int = 0
    managed: bool = False


class Plugin(NamedTuple):
    """A class of a plugin description: the name that it is loaded by, its C++ type, and the class that it is derived from."""

    name: str
    type: str
    base: str


class Doubt(NamedTuple):
    """Why a program may have more of a category than was found: what is called, and where."""

    category: str
    reason: str
    path: str
    line: int


class Program(NamedTuple):
    """What was found for one executable or nodelet class."""

    package: str
    name: str
    client: str
    facts: tuple[Fact, ...]
    doubts: tuple[Doubt, ...]
