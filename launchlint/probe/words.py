"""What a word in a probe's configuration may look like. Each of them ends up in a command, a path or a file name somewhere, so none may
begin
with ``-``, lead out of a directory, or hold anything that a shell, git, apt, pip or Docker would take for something else.
"""

from __future__ import annotations

import re

_OWNER_AND_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,99}/[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}")
_URL = re.compile(r"(?:https?|ssh|git|file)://[A-Za-z0-9/][\w.:@/~+%-]{0,499}", re.ASCII)
_SCP = re.compile(r"[A-Za-z0-9_][\w.-]{0,63}@[A-Za-z0-9][\w.-]{0,199}:[\w~/][\w./~+-]{0,299}", re.ASCII)
_PASSWORD = re.compile(r"[a-z]+://[^/@:]*:[^/@]*@")

_PIP_VERSION = r"(?:==|>=|<=|!=|~=|<|>)[A-Za-z0-9][\w.*+!-]{0,49}"
_SYNTAX = {
    "base": r"[A-Za-z0-9][A-Za-z0-9_.-]*(?::[0-9]{1,5})?(?:/[A-Za-z0-9][A-Za-z0-9_.-]*)*(?::[\w][\w.-]{0,127})?(?:@sha256:[0-9a-f]{64})?",
    "ref": r"(?!.*(?:\.\.|//|@\{|\.lock(?:/|$)))[A-Za-z0-9_][\w./+-]{0,199}(?<![./])",
    "apt": r"[a-z0-9][a-z0-9+.-]{1,99}(?::[a-z0-9]{1,20})?(?:=[A-Za-z0-9][A-Za-z0-9.+:~-]{0,99})?",
    "pip": rf"[A-Za-z0-9][\w.-]{{0,99}}(?:\[[A-Za-z0-9][\w.,-]{{0,99}}\])?(?:{_PIP_VERSION}(?:,{_PIP_VERSION}){{0,4}})?",
    "package": r"[A-Za-z][A-Za-z0-9_-]{0,199}",
    "program": r"[A-Za-z][A-Za-z0-9_-]{0,199}/[A-Za-z0-9_][\w.+-]{0,199}|[A-Za-z_]\w{0,199}(?:(?:/|::)\w{1,199}){1,5}",
    "variant": r"[A-Za-z0-9][\w.-]{0,99}",
    "variable": r"[A-Za-z_]\w{0,199}",
    "param": r"[~/]?[A-Za-z]\w*(?:/\w+){0,20}",
    "name": r"[~/]?[A-Za-z]\w*(?:/\w+){0,20}",
    "arg": r"[A-Za-z_][\w-]{0,199}",
    "file": r"[A-Za-z0-9_][\w.+-]{0,199}",
    "launch": r"[A-Za-z][A-Za-z0-9_-]{0,199}(?:/(?!\.\.?/)[A-Za-z0-9_][\w.+-]{0,199}){1,10}",
    "memory": r"[1-9][0-9]{0,5}[mg]",
}
_COMPILED = {kind: re.compile(pattern, re.ASCII) for kind, pattern in _SYNTAX.items()}

MEANT = {
    "base": "the name of an image, such as debian:bookworm or osrf/ros:noetic-desktop-full",
    "ref": "a branch, tag or commit",
    "apt": "the name of an apt package, with =version if need be",
    "pip": "the name of a package on PyPI, with ==version if need be",
    "package": "the name of a ROS package",
    "program": "package/executable, or the class of a nodelet or component",
    "variant": "a name of letters, digits, _, - and .",
    "variable": "the name of an environment variable",
    "param": "the name of a param: ~private, relative or /global",
    "name": "a ROS name",
    "arg": "the name of a launch arg",
    "file": "a plain file name without directories",
    "launch": "package/path/of.launch",
    "memory": "a number with m or g, such as 2g",
}
"""What a word of each kind is, for messages."""


def is_a(kind: str, text: str) -> bool:
    """Whether ``text`` is a word of a kind (a key of :data:`MEANT`)."""
    return _COMPILED[kind].fullmatch(text) is not None


def repository_url(text: str) -> str | None:
    """The URL that ``owner/name`` or a URL stands for; None where it is neither, or holds a password."""
    if _OWNER_AND_NAME.fullmatch(text) and ".." not in text:
        return f"https://github.com/{text.removesuffix('.git')}"
    if ".." in text or "@-" in text or _PASSWORD.match(text):
        return None
    return text if _URL.fullmatch(text) or _SCP.fullmatch(text) else None


def is_package(text: str) -> bool:
    """Whether a container may call a package so."""
    return is_a("package", text)


def plain(text: str, longest: int = 300) -> str:
    """What a container or a build has said, for people: in one line, without control characters, cut."""
    cut = text[: longest + 1]
    shown = "".join(character if character.isprintable() else " " for character in cut)
    return " ".join(shown[:longest].split()) + ("…" if len(cut) > longest else "")
