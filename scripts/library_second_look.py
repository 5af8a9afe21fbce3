"""A second look at programs that were read from source: is there a call in their files that was not followed?

Following a program may miss a call without knowing it. So each file that a fact of the program stands in is searched for calls that make a
name and are given it as text. Where the program has no such name, the category is open: too much doubt is better than a false promise.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping

from library_shelf import Program, entries_of

_CATEGORIES = {
    "advertise": "publishers",
    "advertiseCamera": "publishers",
    "Publisher": "publishers",
    "subscribe": "subscribers",
    "subscribeCamera": "subscribers",
    "Subscriber": "subscribers",
    "advertiseService": "services",
    "Service": "services",
    "serviceClient": "clients",
    "ServiceProxy": "clients",
    "SimpleActionClient": "actions",
    "SimpleActionServer": "actions",
    "create_publisher": "publishers",
    "create_subscription": "subscribers",
    "create_service": "services",
    "create_client": "clients",
    "create_server": "actions",
}
_CALL = re.compile(rf"\b({'|'.join(_CATEGORIES)})\s*(?:<[^;()]{{0,120}}?>)?\s*\(\s*(?:[\w>.*-]{{1,60}}\s*,\s*)?[\"']([~/\w]{{1,200}})[\"']")
_COMMENT = re.compile(r"\s*(?://|#|\*)")
_BLOCK = re.compile(r"/\*.*?\*/", re.DOTALL)


def not_followed(program: Program, text_of: Callable[[str], str]) -> dict[str, str]:
    """Category → reason, for calls whose names the program lacks. ``text_of`` gives the text of a file (``owner/name@commit:path``)."""
    names = " ".join(entry["name"] for _, entry in entries_of(program))
    files = {evidence["at"].rpartition(":")[0] for _, entry in entries_of(program) for evidence in entry["evidence"]}
    found: dict[str, str] = {}
    for file in sorted(files):
        for number, category, name in _calls(text_of(file)):
            if name.lstrip("~/") not in names:
                found.setdefault(category, f"a call that was not followed ({file.partition(':')[2]}:{number})")
    return found


def _blank(comment: re.Match[str]) -> str:
    return "\n" * comment[0].count("\n")


def _calls(text: str) -> Iterator[tuple[int, str, str]]:
    for number, line in enumerate(_BLOCK.sub(_blank, text).splitlines(), 1):
        if not _COMMENT.match(line):
            for call in _CALL.finditer(line):
                yield number, _CATEGORIES[call[1]], call[2]


def open_what_was_missed(program: Program, text_of: Callable[[str], str]) -> Mapping[str, str]:
    """Leave the categories open of which a call was not followed; they are told."""
    missed = not_followed(program, text_of)
    for variant in program["variants"].values():
        variant["open"] = {**missed, **variant["open"]}
    return missed
