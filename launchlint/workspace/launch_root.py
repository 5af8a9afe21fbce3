"""Whether a file is a launch file at all, by its outermost element or key."""

from __future__ import annotations

import re

from launchlint.late import late

_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_ROOT = re.compile(r"<launch(?=[\s/>])")
_PARTS = ("group", "node", "include", "arg", "param", "rosparam", "remap", "env", "machine", "test", "master")
_START = re.compile(r"<([^\W\d][\w:.-]*)")
# What stands before the root element: declaration, processing instructions, a document type (with or without an internal part).
_PROLOG = re.compile(r"\ufeff?(?:\s+|<\?.*?\?>|<!--.*?-->|<!DOCTYPE[^\[>]*(?:\[[^\]]*\]\s*)?>)*", re.DOTALL)

_NODES = late(r"<node(?:_container)?\b([^<>]{0,2000})>")
_PROGRAM = late(r"\b(?:pkg|exec|type|plugin)\s*=")
_OTHER_TAGS = late(r"<(?:include|composable_node|executable|test)\b")

_LAUNCH_KEY = late(r"""(?m)^(?:launch|"launch"|'launch')[ \t]*:(?:[ \t\r]|$)|\A\s*\{\s*["']?launch["']?\s*:""")


def decoded(data: bytes) -> str:
    """XML text for looking at, never wrong enough to raise: by byte order mark, else as UTF-8, else as Latin-1."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16", "replace")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def has_launch_root(data: bytes) -> bool:
    """Whether the document that starts with ``data`` has ``<launch>`` as its root element."""
    text = decoded(data)
    prolog = _PROLOG.match(text)
    return _ROOT.match(text, prolog.end() if prolog else 0) is not None


def other_root(data: bytes) -> str | None:
    """Name of the root element where the file is of another program: an Eclipse ``<launchConfiguration>``, a ``<concert>`` with a
    ``<launch>`` in it (which roslaunch would take, see roslaunch.xmlloader.XmlLoader._parse_launch).

    A root that is nearly ``launch`` is a slip, and one that is another tag of roslaunch has lost its ``<launch>``: None for these.
    """
    text = decoded(data)
    prolog = _PROLOG.match(text)
    start = _START.match(text, prolog.end() if prolog else 0)
    if start is None or start[1] == "launch":
        return None
    from launchlint.spelling import closest

    if closest(start[1], ("launch",)) is not None:
        return None
    is_part = start[1] in _PARTS and _ROOT.search(_COMMENT.sub("", text)) is None
    return None if is_part else start[1]


def names_no_program(data: bytes) -> bool:
    """Whether a ``<launch>`` has several nodes and none of them says a package or program: another program reads it, launch never could."""
    text = _COMMENT.sub("", decoded(data))
    nodes = _NODES.findall(text)
    return len(nodes) > 1 and not any(map(_PROGRAM.search, nodes)) and _OTHER_TAGS.search(text) is None


def has_launch_key(data: bytes) -> bool:
    """Whether the YAML that starts with ``data`` has ``launch`` among its outermost keys, as far as can be told without reading it."""
    return _LAUNCH_KEY.search(decoded(data).removeprefix("\ufeff")) is not None
