"""The library format, version 1, as data: which keys there are and what they hold. The validator and the JSON Schema come from it.

A *shape* is one of the small classes below. ``docs/library-format.md`` says what each key means.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from launchlint.library.terms import CATEGORIES as CATEGORIES
from launchlint.library.terms import DEEPEST_CONDITION as DEEPEST_CONDITION
from launchlint.library.terms import FRAMES as FRAMES
from launchlint.library.terms import KINDS as KINDS
from launchlint.library.terms import LISTS as LISTS

FORMAT = "launchlint-library"
VERSION = 1

LONGEST_NAME = 1_000
"""Characters of a name, type or other single word."""
LONGEST_TEXT = 100_000
"""Characters of a message definition or a build error."""


class Text(NamedTuple):
    """A string; ``one_of`` where only some are allowed, ``syntax`` names a finer check of the validator."""

    one_of: tuple[str, ...] = ()
    syntax: str = ""
    longest: int = LONGEST_NAME


class Number(NamedTuple):
    """A whole number, at least ``least``."""

    least: int = 0


class Flag(NamedTuple):
    """True or false."""


class Plain(NamedTuple):
    """Any JSON value: a param's default, a probe's own notes."""


class Rule(NamedTuple):
    """Something with a grammar of its own: ``condition`` or ``each``."""

    grammar: str


class Items(NamedTuple):
    """A list of ``each``."""

    each: Shape


class Entries(NamedTuple):
    """A mapping from names to ``each``; ``named`` says in messages what its keys are."""

    each: Shape
    named: str


class Keys(NamedTuple):
    """A mapping with known keys; ``name`` says in messages what it is."""

    name: str
    keys: Mapping[str, Shape]
    required: tuple[str, ...] = ()


Shape = Text | Number | Flag | Plain | Rule | Items | Entries | Keys

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
_QUEUE: Mapping[str, Shape] = {"queue": Number(), "transport": Text(("image",))}
_VALUE_TYPES = ("*", "bool", "int", "double", "str", "list", "dict")

INTERFACES: Mapping[str, Keys] = {
    "publishers": Keys("a publisher", {**_TYPED, "latched": Flag(), "by_hand": Flag(), **_QUEUE, **_WHEN}, ("name",)),
    "subscribers": Keys("a subscriber", {**_TYPED, **_QUEUE, **_WHEN}, ("name",)),
    "services": Keys("a service", {**_TYPED, **_WHEN}, ("name",)),
    "clients": Keys("a service client", {**_TYPED, **_WHEN}, ("name",)),
    "actions": Keys("an action", {**_TYPED, "role": Text(("server", "client")), **_WHEN}, ("name", "role")),
    "params": Keys(
        "a param",
        {**_NAMED, "type": Text(_VALUE_TYPES), "default": Plain(), "min": Plain(), "max": Plain(), "removed": REMOVED, **_WHEN},
        ("name",),
    ),
    FRAMES: Keys(
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
    ),
}
"""What an entry of each list holds; the order of the keys is that in which they are written."""

VARIANT = Keys(
    "a variant",
    {
        "match": Rule("condition"),
        "args": Text(longest=LONGEST_TEXT),
        "env": Entries(Text(), "variable"),
        "remap": Entries(Text(), "name"),
        "run": Plain(),
        **{each: Items(INTERFACES[each]) for each in LISTS},
        "open": Keys("what is open", {category: Text() for category in CATEGORIES}),
        "literals": Items(Text()),
    },
)

PROGRAM = Keys(
    "an executable or nodelet",
    {
        "class": Text(("roscpp", "rospy", "nodelet", "none", "other")),
        "status": Text(("ok", "failed")),
        "like": Text(),
        "removed": REMOVED,
        "hash": Text(),
        "options": Entries(Number(), "option"),
        "problems": Items(Keys("a problem", {"code": Text(), "detail": Text(longest=LONGEST_TEXT)}, ("code",))),
        "variants": Entries(VARIANT, "variant"),
    },
)

PACKAGE = Keys(
    "a package",
    {
        "version": Text(),
        "source": Text(),
        "complete": Items(Text(("executables", "nodelets"))),
        "build": Keys("a build", {"result": Text(("ok", "partial", "failed")), "errors": Items(Text(longest=LONGEST_TEXT))}),
        "launch": Items(Plain()),
        "executables": Entries(PROGRAM, "executable"),
        "nodelets": Entries(PROGRAM, "nodelet class"),
    },
)

LIBRARY = Keys(
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
        "packages": Entries(PACKAGE, "package"),
    },
    ("format", "version", "packages"),
)
