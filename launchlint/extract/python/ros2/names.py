"""The names that values make when they are given to rclpy, spelled as in the library format, and the classes of messages."""

from __future__ import annotations

import re

from launchlint.extract.python.outside import NAMESPACE, NODE, MessageClass, Param
from launchlint.python.text import ANY, ANYS, template
from launchlint.python.values import LONGEST_TEXT, UNKNOWN, External, Handle, Seq, Text, Unknown, Value

_NAME = re.compile(r"~|(?:~/|/)?[A-Za-z_]\w*(?:/[A-Za-z_]\w*)*", re.ASCII)
"""rcl_validate_topic_name: no part begins with a digit, none is empty; ``~`` stands for the node, and only at the beginning."""
_PARAM = re.compile(r"[^\s/{}~][^\s{}~]*")
_LITERAL = re.compile(r"[\w/~]*", re.ASCII)
_INNER = re.compile(r"\{[^{}]*\}")
_INTERFACE = re.compile(r"(\w+)\.(msg|srv|action)\.(?:_\w+\.)?([A-Za-z]\w*)")
_DEEPEST = 20


def spelled(value: Value, category: str) -> str:
    """The name that a value makes: of params ``~name``, of all others as rcl expands it (``{any}`` where nothing is known of it)."""
    if isinstance(value, (Handle, Seq)):
        return ANY
    text = ANYS.sub(ANY, template(value))
    if len(text) > LONGEST_TEXT or text == ANY:
        return ANY
    return param_name(text) if category == "params" else _name(text)


def param_name(text: str) -> str:
    """The template of the name of a param, in the library format."""
    if NODE in text or NAMESPACE in text or text == ANY:
        return ANY
    return f"~{text}" if "{" in text or "}" in text or _PARAM.fullmatch(text) else ANY


def _name(text: str) -> str:
    text = text.replace("{{node}}", "{node}")  # what rcl itself puts in
    for sign in ("{{ns}}", "{{namespace}}", f"/{NAMESPACE}"):
        text = NAMESPACE + text[len(sign) :] if text.startswith(sign) else text
    text = text.removeprefix("/") if text.startswith(f"/{NODE}") else text
    if text.startswith(NAMESPACE):
        if not text[len(NAMESPACE) :].startswith("/"):
            return ANY
        text = text[len(NAMESPACE) :].lstrip("/")
    elif text.startswith(NODE):
        if not f"{text[len(NODE) :]}/".startswith("/"):
            return ANY
        text = f"~{text[len(NODE) :]}"
    if NODE in text or NAMESPACE in text or not text:
        return ANY
    if "{" not in text and "}" not in text:
        return text.replace("~/", "~", 1) if _NAME.fullmatch(text) else ANY
    if text.startswith("{param:") and text.endswith("|}"):
        text = f"{text[:-2]}}}"  # an empty name is none
    text = text.replace("|~/", "|~")
    text = f"~{text[2:]}" if text.startswith("~/") else text
    text = text if len(text) == 1 else text.removesuffix("/")
    rest = text
    for _ in range(_DEEPEST):
        rest, count = _INNER.subn("", rest)
        if not count:
            break
    return text if _LITERAL.fullmatch(rest) and "~" not in rest[1:] and "{{" not in text else ANY


def interface_type(value: Value) -> str:
    """The type that a message, service or action class stands for, as ``package/msg/Name``; empty where it is not known."""
    if isinstance(value, MessageClass):
        return value.type
    match = _INTERFACE.fullmatch(value.name) if isinstance(value, External) else None
    return "" if match is None else f"{match[1]}/{match[2]}/{match[3]}"


class NodeParam(Param):
    """The value of a param of a node: its name, ``~name`` as in the library format, may have dots, and it has nothing in it by name."""

    __slots__ = ()
    pattern = re.compile(r"~[^\s/{}~|][^\s{}~|]*")

    def item(self, index: Value) -> Value:
        """One value of a list: any of them where it is not known which."""
        return self.each() if isinstance(index, Unknown) else UNKNOWN

    def each(self) -> Value:
        """Each value of a list: there is one name for each of them."""
        return Text(f"{{each:{self.name}}}") if self.pattern.fullmatch(self.name) else UNKNOWN


def is_of_each(value: Value) -> bool:
    """Whether a value is made of each value of a param."""
    if isinstance(value, Seq):
        return any(map(is_of_each, value.items))
    return isinstance(value, Text) and "{each:" in value.template
