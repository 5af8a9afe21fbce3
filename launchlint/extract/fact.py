"""What source code says of one name of a node."""

from __future__ import annotations

from typing import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


ELSEWHERE = "which is not in these sources"
"""How the reason of a doubt ends that is about a header of a ROS package."""


class Fact(NamedTuple):
    """One call site that makes, or asks for, a name.

    Args:
        category: ``publishers``, ``subscribers``, ``services``, ``clients``, ``actions`` or ``params``, as in the library format.
        name: as the library format spells it: ``chatter``, ``~state``, ``/tf``, or a template such as ``{param:~topic|scan}``; parts that
            cannot be known are ``{any}``. A name of which nothing is known is ``{any}``.
        path: the source file, relative to the directory that was given, with ``/``.
        line: from 1.
        type: ``package/Type``; empty where it is not known.
        role: of actions: ``server`` or ``client``.
        transport: ``image`` where the name goes through image_transport.
        latched: of publishers.
        queue: of publishers and subscribers; None where it is not known.
        default: of params; None where there is none or it is not known.
        value_type: of params: ``bool``, ``int``, ``double``, ``str``, ``list``, ``dict``, ``*`` for any; empty where it is not known.
        condition: the source text of the conditions around the call, joined with ``and``; empty where there are none.
        when: ``start``, or ``message`` where the call stands in a callback.
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
