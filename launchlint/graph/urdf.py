"""The links of a robot description (URDF): the frames that a robot_state_publisher publishes."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from launchlint.named_tuple import NamedTuple

LARGEST = 4 << 20
"""Characters of a description that is read."""


class Joint(NamedTuple):
    """The joint above a link: the link it hangs from, and whether it is ``fixed``: then its transform is always published.

    ``origin`` is where it sits on that link, as it is written: place and angles, each number without what does not change it.
    """

    parent: str
    fixed: bool
    origin: tuple[str, ...] = ("0.0",) * 6


def _origin(joint: Mapping[str, str]) -> tuple[str, ...]:
    """Six numbers; what is not given is 0 (urdfdom, parsePose)."""
    return tuple(_number(word) for name in ("xyz", "rpy") for word in (joint.get(name) or "0 0 0").split())


def _number(word: str) -> str:
    try:
        return str(float(word) + 0.0)
    except ValueError:
        return word


@lru_cache(maxsize=4)
def joints(text: str) -> Mapping[str, Joint] | None:
    """The joint above each link of a plain URDF; None where it cannot be told: it is no XML, no robot, or has macros (xacro) in it."""
    from pyexpat import ExpatError, ParserCreate

    if len(text) > LARGEST or "<!ENTITY" in text:
        return None
    found: dict[str, Joint] = {}
    path: list[str] = []
    joint: dict[str, str] = {}
    plain = True

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal plain
        plain = plain and ":" not in tag and (bool(path) or tag == "robot")
        path.append(tag)
        if path == ["robot", "joint"]:
            joint.clear()
            joint["type"] = attributes.get("type", "")
        elif path[:2] == ["robot", "joint"] and len(path) == 3 and tag in ("parent", "child"):
            joint[tag] = attributes.get("link", "")
        elif path == ["robot", "joint", "origin"]:
            joint["xyz"], joint["rpy"] = attributes.get("xyz", ""), attributes.get("rpy", "")

    def end(_: str) -> None:
        if path == ["robot", "joint"] and joint.get("child") and joint.get("parent"):
            found[joint["child"]] = Joint(joint["parent"], joint["type"] == "fixed", _origin(joint))
        path.pop()

    parser = ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = start, end
    try:
        parser.Parse(text, True)
    except (ExpatError, ValueError, RecursionError):
        return None
    return found if plain and not any("$" in name for name in found) else None
