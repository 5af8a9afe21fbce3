"""Regular expressions of a followed program: worked out where they are certain to end soon."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from launchlint.python.failures import Raised
from launchlint.python.plain import LARGEST_TEXT, NotPlain, plain, value_of
from launchlint.python.values import MISSING, UNKNOWN, External, Failure, Handle, Seq, Value

PATTERN, MATCH = "pattern", "match"
"""A compiled pattern, and what one has found."""
_MOST_WORK = 1_000_000
_LONGEST = 300
_FLAGS: Mapping[str, int] = {name: int(getattr(re, name)) for name in ("I", "IGNORECASE", "M", "MULTILINE", "S", "DOTALL", "X", "VERBOSE")}
_ESCAPED = re.compile(r"\\.|\[\^?\]?(?:\\.|[^\]\\])*(?:\]|\\?\Z)", re.DOTALL)
_REPEATED = re.compile(r"[*+]|\{\d*,\d*\}|\{\d{3,}\}")
_FUNCTIONS = ("search", "match", "fullmatch", "findall", "split", "sub")


def flag(name: str) -> Value:
    """``re.IGNORECASE`` and the like; MISSING for all others."""
    return _FLAGS.get(name.removeprefix("re."), MISSING) if name.startswith("re.") else MISSING


def call(name: str, positional: list[Value], keywords: Mapping[str, Value], spend: Callable[[int], None]) -> Value:
    """A function of ``re``; MISSING where it is not worked out. ``spend`` counts the work. Raises Raised."""
    word = name.removeprefix("re.")
    if not name.startswith("re.") or word not in ("compile", "escape", *_FUNCTIONS) or not positional:
        return MISSING
    try:
        given = [plain(each) if not isinstance(each, Handle) else each for each in positional]
        flags = plain(keywords.get("flags", 0))
    except NotPlain:
        return MISSING
    if word == "escape":
        return re.escape(given[0]) if isinstance(given[0], str) else MISSING
    takes = 1 if word == "compile" else 3 if word == "sub" else 2
    if len(given) == takes + 1 and word not in ("sub", "split"):
        flags = given.pop()
    if len(given) != takes or keywords.keys() - {"flags"} or not isinstance(flags, int):
        return MISSING
    if isinstance(given[0], Handle):
        return _found(given[0], word, given[1:], spend) if given[0].kind == PATTERN else MISSING
    if not isinstance(given[0], str):
        return MISSING
    made = Handle(PATTERN, {"text": given[0], "flags": flags})
    return made if word == "compile" else _found(made, word, given[1:], spend)


def method(receiver: Handle, name: str, given: list[Value], spend: Callable[[int], None]) -> Value:
    """A method of a pattern or of a match; MISSING where it is not worked out. Raises Raised."""
    try:
        words = [plain(each) for each in given]
    except NotPlain:
        return MISSING
    if receiver.kind == PATTERN:
        return _found(receiver, name, words, spend) if name in _FUNCTIONS and len(words) == (2 if name == "sub" else 1) else MISSING
    match: re.Match[str] = receiver.state["match"]
    if name not in ("group", "groups", "groupdict", "start", "end", "span", "__getitem__"):
        return MISSING
    try:
        return value_of(getattr(match, name)(*words))
    except (IndexError, TypeError) as error:
        raise Raised(Failure(External(f"builtins.{type(error).__name__}"), (str(error),))) from None


def _found(pattern: Handle, name: str, given: list[Any], spend: Callable[[int], None]) -> Value:
    text, written = given[-1], pattern.state["text"]
    if not all(isinstance(each, str) for each in given) or not _is_soon(written, text):
        return MISSING
    spend(len(text))
    if name == "sub" and (len(text) + 1) * (len(given[0]) + 1) * (len(text) if "\\" in given[0] else 1) > LARGEST_TEXT:
        return MISSING
    try:
        found = getattr(re, name)(written, *given, flags=pattern.state["flags"])
    except (re.error, IndexError, OverflowError, RecursionError, ValueError) as error:
        raise Raised(Failure(External("re.error"), (str(error),))) from None
    if isinstance(found, re.Match):
        return Handle(MATCH, {"match": found})
    try:
        made = value_of(found)
    except NotPlain:
        return UNKNOWN
    return made if not isinstance(made, Seq) or made.is_sure else UNKNOWN


def _is_soon(pattern: str, text: str) -> bool:
    """Whether looking for a pattern ends soon whatever the text is: nothing repeated is repeated, nor are there many repetitions."""
    if len(pattern) > _LONGEST:
        return False
    bare = _ESCAPED.sub("x", pattern)
    repeated = [match.start() for match in _REPEATED.finditer(bare)]
    if any(bare[at - 1 : at] == ")" for at in repeated) or "(?P=" in bare or re.search(r"\\[1-9]", pattern):
        return False
    return float(len(text) + 1) ** (len(repeated) + 1) <= _MOST_WORK
