"""What one text gives to launch files by name: `roslaunch x.launch name:=…` anywhere, `<arg>` within an include."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.late import late
from launchlint.named_tuple import NamedTuple

# Whole files of any kind are looked through, none is read as a launch file: what is found here only keeps rules silent.
_FILE = late(r"(?<![\w.-])[\w.-]{1,200}\.(?:launch|test|xml)\b")
_GIVEN = late(r"(?<![\w/~])([A-Za-z]\w{0,200}):=")
_COMMENT = late(r"(?s)<!--.*?(?:-->|\Z)")
_ARGS = late(r"""\bargs\s{0,20}=\s{0,20}("[^"<]*"|'[^'<]*')""")
_INCLUDED = late(r"\bfile\s*=\s*[\"']([^\"']{0,1000})[\"']")
_PASSED = late(r"<arg\b[^<>]{0,1000}?\bname\s*=\s*[\"'](\w+)[\"']")
ANY = ""
"""Instead of the name of a launch file where that is computed."""
_STARTS = ":"
_INCLUDES = "<"


class Uses(NamedTuple):
    """What one file gives: the launch files that it starts, and those that it includes, each with names of args."""

    starts: tuple[tuple[str, frozenset[str]], ...]
    includes: tuple[tuple[str, frozenset[str]], ...]


NOTHING = Uses((), ())


def in_launch_file(text: str) -> Sequence[str]:
    """What a launch file gives, in lines that :func:`uses_of` reads."""
    text = _COMMENT.sub("", text)
    return [*_lines(_STARTS, _starts(text, is_launch=True)), *_lines(_INCLUDES, _includes(text))]


def elsewhere(text: str) -> Sequence[str]:
    """The same of a text that is no launch file."""
    return list(_lines(_STARTS, _starts(text, is_launch=False)))


def _lines(kind: str, given: Iterator[tuple[str, frozenset[str]]]) -> Iterator[str]:
    for name, args in given:
        yield f"{kind}{' '.join(sorted(args))}/{name}"


def uses_of(lines: Sequence[str]) -> Uses:
    """What such lines say."""
    if not lines:
        return NOTHING
    found: dict[str, list[tuple[str, frozenset[str]]]] = {_STARTS: [], _INCLUDES: []}
    for line in lines:
        args, _, name = line[1:].partition("/")
        found.get(line[:1], []).append((name, frozenset(args.split())))
    return Uses(tuple(found[_STARTS]), tuple(found[_INCLUDES]))


def _starts(text: str, *, is_launch: bool) -> Iterator[tuple[str, frozenset[str]]]:
    """Launch files that the text names with the args that it gives: those of the same line; in a launch file, those of any node's args."""
    if ":=" not in text:
        return
    lines = text.replace("\\\n", " ").splitlines()
    if is_launch:
        lines = [" ".join([*_ARGS.findall(text), *_FILE.findall(text)])]
    for line in lines:
        names = frozenset(_GIVEN.findall(line)) if ":=" in line else frozenset()
        for started in dict.fromkeys(_FILE.findall(line)) if names else ():
            yield started, names


def _includes(text: str) -> Iterator[tuple[str, frozenset[str]]]:
    """The launch files that the text includes, with the args that it passes."""
    for part in text.split("<include")[1:]:
        inside, _, _ = part.partition("</include>")
        file = _INCLUDED.search(inside[:2_000])
        if file is not None:
            name = file[1].rpartition("/")[2]
            yield ANY if "$(" in name or ")" in name else name, frozenset(_PASSED.findall(inside))
