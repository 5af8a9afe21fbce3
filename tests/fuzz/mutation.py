"""Inputs like those that people write, with damage: pieces lost, doubled, swapped, put into each other, and signs that readers look for."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from random import Random

MOST_BYTES = 6000
TEXTS = (
    *"<>&;\"'=/\\$(){}[]:,-#%*@!|?~`\n\t \r\0",
    *"$( $(arg $(var $(eval $(find ${ <!-- --> <![CDATA[ ]]> <? ?> &b; &#0; &#x41; ? - &a *a !! !!python/object".split(),
    *"if( endif() foreach( ${${ #[[ ]] // /* */ :: template< -> ** //b /** null true 1e999 0x -1 .inf".split(),
    "<!DOCTYPE a [<!ENTITY b 'c'>]>", "---\n", "...\n", "<<: *a", ">\n", "|\n", "'''", '"""', "lambda: ", "def ", "class ", "if ",
    "for a in b:\n", "9" * 30, "é", "\u2028", "\ufeff", "😀", "launchlint: disable=", "launchlint: format off",
)  # fmt: skip
SIGNS = (*(text.encode("utf-8") for text in TEXTS), b"\xff", b"\xc3", b"\xed\xa0\x80", b"\xff\xfe", b"\xfe\xff")
_WORD = re.compile(rb"\w+")


def _place(random: Random, data: bytes) -> tuple[int, int]:
    start = random.randrange(len(data) + 1)
    return start, min(len(data), start + int(random.expovariate(0.08)))


def _lost(random: Random, data: bytes, other: bytes) -> bytes:
    start, end = _place(random, data)
    return data[:start] + data[end:]


def _doubled(random: Random, data: bytes, other: bytes) -> bytes:
    start, end = _place(random, data)
    times = random.choice((1, 1, 2, 40))
    return data[:end] + data[start:end] * times + data[end:]


def _sign(random: Random, data: bytes, other: bytes) -> bytes:
    start, end = _place(random, data)
    kept = start if random.random() < 0.7 else end
    return data[:start] + random.choice(SIGNS) * random.choice((1, 1, 1, 2, 60)) + data[kept:]


def _swapped(random: Random, data: bytes, other: bytes) -> bytes:
    (first, one), (second, two) = sorted((_place(random, data), _place(random, data)))
    one = min(one, second)
    return data[:first] + data[second:two] + data[one:second] + data[first:one] + data[two:]


def _joined(random: Random, data: bytes, other: bytes) -> bytes:
    start, end = _place(random, data)
    begin, stop = _place(random, other)
    return data[:start] + other[begin:stop] + data[end:]


def _byte(random: Random, data: bytes, other: bytes) -> bytes:
    at = random.randrange(len(data) + 1)
    return data[:at] + bytes((random.randrange(256),)) + data[at + 1 :]


def _word(random: Random, data: bytes, other: bytes) -> bytes:
    """One word is another one that is written there, or in the other file: what comes of it is often well formed."""
    words, others = list(_WORD.finditer(data)), _WORD.findall(data) + _WORD.findall(other)
    if not words or not others:
        return data
    at = random.choice(words)
    return data[: at.start()] + random.choice(others) + data[at.end() :]


def _line(random: Random, data: bytes, other: bytes) -> bytes:
    """A line goes, comes twice, or comes from the other file."""
    lines, others = data.splitlines(keepends=True), other.splitlines(keepends=True)
    if not lines or not others:
        return data
    at = random.randrange(len(lines))
    instead = random.choice(([], [lines[at]] * 2, [lines[at], random.choice(others)], [random.choice(lines)]))
    return b"".join((*lines[:at], *instead, *lines[at + 1 :]))


def _cut(random: Random, data: bytes, other: bytes) -> bytes:
    return data[: random.randrange(len(data) + 1)]


HOW: tuple[Callable[[Random, bytes, bytes], bytes], ...] = (
    _lost,
    _doubled,
    _sign,
    _sign,
    _swapped,
    _joined,
    _byte,
    _cut,
    *[_word] * 5,
    *[_line] * 3,
)


def mutated(random: Random, originals: Sequence[bytes]) -> bytes:
    """One of the originals with up to eight damages."""
    data = random.choice(originals)
    for _ in range(random.choice((1, 1, 2, 3, 5, 8))):
        data = random.choice(HOW)(random, data, random.choice(originals))[:MOST_BYTES]
    return data
