"""The library format as data: which keys there are and what they hold, in each version. The validator and the JSON Schema come from it.

Version 1 is about ROS 1. Version 2 says of each package which middleware it is of; what it says of one of ROS 1 is what version 1 says.
``docs/library-format.md`` says what each key means.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from launchlint.library.shapes import (
    LONGEST_NAME,
    LONGEST_TEXT,
    Amount,
    Choice,
    Entries,
    Flag,
    Items,
    Keys,
    Number,
    Plain,
    Rule,
    Shape,
    Text,
)
from launchlint.library.terms import CATEGORIES as CATEGORIES
from launchlint.library.terms import DEEPEST_CONDITION as DEEPEST_CONDITION
from launchlint.library.terms import FRAMES as FRAMES
from launchlint.library.terms import KINDS as KINDS
from launchlint.library.terms import LISTS as LISTS
from launchlint.library.terms import TABLES as TABLES
from launchlint.library.terms import VERSION as VERSION
from launchlint.library.terms import VERSION_2 as VERSION_2
from launchlint.model import ROS1, ROS2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

__all__ = [
    "LONGEST_NAME",
    "LONGEST_TEXT",
    "Amount",
    "Choice",
    "Entries",
    "Flag",
    "Items",
    "Keys",
    "Number",
    "Plain",
    "Rule",
    "Shape",
    "Text",
]

FORMAT = "launchlint-library"
DISTRIBUTIONS = ("fuerte", "groovy", "hydro", "indigo", "jade", "kinetic", "lunar", "melodic", "noetic")
"""The distributions of ROS 1 that ``removed`` may name, the oldest first."""

REMOVED = Keys("a removal", {"in": Text(DISTRIBUTIONS), "instead": Text()}, ("in",))

EVIDENCE = Keys("evidence", {"by": Text(("manual", "dynamic", "static")), "at": Text(), "run": Text()}, ("by",))

_NAMED: Mapping[str, Shape] = {"name": Text(syntax="name")}
_TYPED: Mapping[str, Shape] = {**_NAMED, "type": Text(syntax="type"), "md5": Text(syntax="md5")}
_WHEN: Mapping[str, Shape] = {
    "when": Text(("start", "subscriber", "message")),
    "condition": Rule("condition"),
    "each": Rule("each"),
    "evidence": Items(EVIDENCE),
}
_TRANSPORT: Mapping[str, Shape] = {"transport": Text(("image",))}
_QUEUE: Mapping[str, Shape] = {"queue": Number(), **_TRANSPORT}
_VALUE_TYPES = ("*", "bool", "int", "double", "str", "list", "dict")
_ROLE: Mapping[str, Shape] = {"role": Text(("server", "client"))}
_LIMITS: Mapping[str, Shape] = {"default": Plain(), "min": Plain(), "max": Plain()}

_FRAME = Keys(
    "a frame",
    {
        "name": Text(syntax="frame"),
        "role": Text(("child", "used", "label")),
        "parent": Text(syntax="frame"),
        "urdf": Text(syntax="name"),
        "upon": Text(syntax="name"),
        "through": Text(("tf", "tf2")),
        "condition": Rule("condition"),
        "evidence": Items(EVIDENCE),
    },
    ("name", "role"),
)

INTERFACES: Mapping[str, Keys] = {
    "publishers": Keys("a publisher", {**_TYPED, "latched": Flag(), "by_hand": Flag(), **_QUEUE, **_WHEN}, ("name",)),
    "subscribers": Keys("a subscriber", {**_TYPED, **_QUEUE, **_WHEN}, ("name",)),
    "services": Keys("a service", {**_TYPED, **_WHEN}, ("name",)),
    "clients": Keys("a service client", {**_TYPED, **_WHEN}, ("name",)),
    "actions": Keys("an action", {**_TYPED, **_ROLE, **_WHEN}, ("name", "role")),
    "params": Keys("a param", {**_NAMED, "type": Text(_VALUE_TYPES), **_LIMITS, "removed": REMOVED, **_WHEN}, ("name",)),
    FRAMES: _FRAME,
}
"""What an entry of each list holds, of a node of ROS 1; the order of the keys is that in which they are written."""

TIMES = ("infinite",)
"""What a time of a QoS profile may be instead of seconds: never."""
QOS = Keys(
    "a QoS profile",
    {
        "reliability": Text(("reliable", "best_effort", "system_default", "best_available"), templates=True),
        "durability": Text(("volatile", "transient_local", "system_default", "best_available"), templates=True),
        "history": Text(("keep_last", "keep_all", "system_default"), templates=True),
        "depth": Amount(whole=True),
        "deadline": Amount(words=(*TIMES, "best_available")),
        "lifespan": Amount(words=TIMES),
        "liveliness": Text(("automatic", "manual_by_topic", "system_default", "best_available"), templates=True),
        "lease": Amount(words=(*TIMES, "best_available")),
    },
)
"""The policies of a publisher or subscriber; each may be left out: not known."""

_TYPED_2: Mapping[str, Shape] = {**_NAMED, "type": Text(syntax="type2")}
_WHERE: Mapping[str, Shape] = {"node": Text(syntax="node"), "exists": Text(("constructed", "configured", "active"))}
_WITH_QOS: Mapping[str, Shape] = {"qos": QOS, "overrides": Flag(), **_TRANSPORT}
VALUE_TYPES_2 = (
    "bool",
    "integer",
    "double",
    "string",
    "byte_array",
    "bool_array",
    "integer_array",
    "double_array",
    "string_array",
)
"""The types of a param in ROS 2."""

INTERFACES_2: Mapping[str, Keys] = {
    "publishers": Keys("a publisher", {**_TYPED_2, **_WITH_QOS, "by_hand": Flag(), **_WHERE, **_WHEN}, ("name",)),
    "subscribers": Keys("a subscriber", {**_TYPED_2, **_WITH_QOS, **_WHERE, **_WHEN}, ("name",)),
    "services": Keys("a service", {**_TYPED_2, **_WHERE, **_WHEN}, ("name",)),
    "clients": Keys("a service client", {**_TYPED_2, **_WHERE, **_WHEN}, ("name",)),
    "actions": Keys("an action", {**_TYPED_2, **_ROLE, **_WHERE, **_WHEN}, ("name", "role")),
    "params": Keys(
        "a param",
        {
            "name": Text(syntax="param2"),
            "type": Text(VALUE_TYPES_2),
            "dynamic": Flag(),
            "declared": Flag(),
            "read_only": Flag(),
            **_LIMITS,
            "step": Plain(),
            "one_of": Items(Plain()),
            "description": Text(longest=LONGEST_TEXT),
            **_WHERE,
            **_WHEN,
        },
        ("name",),
    ),
    FRAMES: _FRAME,
}
"""What an entry of each list holds, of a node of ROS 2."""

_VARIANT_START: Mapping[str, Shape] = {
    "match": Rule("condition"),
    "args": Text(longest=LONGEST_TEXT),
    "env": Entries(Text(), "variable"),
    "remap": Entries(Text(), "name"),
    "run": Plain(),
}
_VARIANT_END: Mapping[str, Shape] = {
    "open": Keys("what is open", {category: Text() for category in CATEGORIES}),
    "literals": Items(Text()),
}

VARIANT = Keys("a variant", {**_VARIANT_START, **{each: Items(INTERFACES[each]) for each in LISTS}, **_VARIANT_END})

VARIANT_2 = Keys(
    "a variant",
    {
        **_VARIANT_START,
        "node": Text(syntax="node"),
        "namespace": Text(syntax="name"),
        "lifecycle": Flag(),
        "managed": Flag(),
        "undeclared": Flag(),
        **{each: Items(INTERFACES_2[each]) for each in LISTS},
        **_VARIANT_END,
    },
)

_PROBLEMS = Items(Keys("a problem", {"code": Text(), "detail": Text(longest=LONGEST_TEXT)}, ("code",)))

PROGRAM = Keys(
    "an executable or nodelet",
    {
        "class": Text(("roscpp", "rospy", "nodelet", "none", "other")),
        "status": Text(("ok", "failed")),
        "like": Text(),
        "removed": REMOVED,
        "hash": Text(),
        "options": Entries(Number(), "option"),
        "problems": _PROBLEMS,
        "variants": Entries(VARIANT, "variant"),
    },
)

PROGRAM_2 = Keys(
    "an executable or component",
    {
        "class": Text(("rclcpp", "rclpy", "component", "container", "none", "other")),
        "status": Text(("ok", "failed")),
        "like": Text(),
        "hash": Text(),
        "options": Entries(Number(), "option"),
        "problems": _PROBLEMS,
        "variants": Entries(VARIANT_2, "variant"),
    },
)


def _package(name: str, first: Mapping[str, Shape], program: Keys, middleware: str) -> Keys:
    tables = TABLES[middleware]
    return Keys(
        name,
        {
            **first,
            "version": Text(),
            "source": Text(),
            "complete": Items(Text(tables)),
            "build": Keys("a build", {"result": Text(("ok", "partial", "failed")), "errors": Items(Text(longest=LONGEST_TEXT))}),
            "launch": Items(Plain()),
            **{table: Entries(program, KINDS[table]) for table in tables},
        },
    )


_MIDDLEWARE: Mapping[str, Shape] = {"middleware": Text((ROS1, ROS2))}

PACKAGE = _package("a package", {}, PROGRAM, ROS1)

PACKAGE_2 = Choice(
    "middleware",
    ROS1,
    {ROS1: _package("a package of ROS 1", _MIDDLEWARE, PROGRAM, ROS1), ROS2: _package("a package of ROS 2", _MIDDLEWARE, PROGRAM_2, ROS2)},
)


def _library(package: Shape) -> Keys:
    return Keys(
        "the library",
        {
            "format": Text((FORMAT,)),
            "version": Number(1),
            "generator": Text(),
            "environment": Keys("the environment", {"base": Text(), "image": Text(), "distro": Text(), "network": Text()}),
            "sources": Items(
                Keys("a source", {"id": Text(), "url": Text(), "ref": Text(), "commit": Text(), "dirty": Flag()}, ("id", "url")),
            ),
            "messages": Entries(Keys("a message", {"md5": Text(syntax="md5"), "text": Text(longest=LONGEST_TEXT)}), "type"),
            "packages": Entries(package, "package"),
        },
        ("format", "version", "packages"),
    )


LIBRARY = _library(PACKAGE)
LIBRARY_2 = _library(PACKAGE_2)
LIBRARIES: Mapping[int, Keys] = {VERSION: LIBRARY, VERSION_2: LIBRARY_2}
"""The shape of a library of each version that launchlint reads."""


def version_for(packages: Iterable[Mapping[str, Any]]) -> int:
    """The version that a library of these packages has: the first one, unless one of them says which middleware it is of."""
    return VERSION_2 if any("middleware" in package for package in packages) else VERSION


def shape_of(document: Mapping[str, Any]) -> Keys:
    """The shape of a validated library."""
    return LIBRARIES[document["version"]]
