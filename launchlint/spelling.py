"""Did you mean: the closest of the names that exist, never one that says something else."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import islice

from launchlint.late import late

_OPPOSITES = (
    ("min", "max"), ("minimum", "maximum"), ("minimal", "maximal"), ("left", "right"), ("upper", "lower"), ("top", "bottom"),
    ("up", "down"), ("front", "rear"), ("front", "back"), ("forward", "backward"), ("fore", "aft"), ("first", "last"),
    ("first", "second"), ("second", "third"), ("start", "stop"), ("start", "end"), ("begin", "end"), ("open", "close"), ("in", "out"),
    ("inner", "outer"), ("internal", "external"), ("on", "off"), ("enable", "disable"), ("enabled", "disabled"), ("true", "false"),
    ("yes", "no"), ("high", "low"), ("long", "short"), ("width", "height"), ("width", "depth"), ("height", "depth"),
    ("horizontal", "vertical"), ("north", "south"), ("east", "west"), ("roll", "yaw"), ("roll", "pitch"), ("pitch", "yaw"),
    ("pan", "tilt"), ("linear", "angular"), ("source", "target"), ("master", "slave"), ("read", "write"), ("pre", "post"),
    ("with", "without"), ("static", "dynamic"), ("x", "y"), ("x", "z"), ("y", "z"), ("red", "green"), ("red", "blue"),
    ("pub", "sub"), ("publish", "subscribe"), ("client", "server"), ("request", "response"), ("parent", "child"), ("lat", "lon"),
    ("tx", "rx"), ("row", "col"), ("even", "odd"), ("from", "to"), ("send", "receive"), ("sender", "receiver"), ("sent", "received"),
    ("incoming", "outgoing"), ("request", "reply"),
)  # fmt: skip
"""Words that take each other's place in two names for two different things."""
_NEGATIONS = ("un", "non", "no", "not", "dis", "anti", "de")
_WORD = late(r"[^\W\d_]+")
_BETWEEN = late(r"[\s_-]+")
_NUMBER = late(r"\d+")
_HUMP = late(r"(?<=[a-z])(?=[A-Z])")
_OFF = frozenset(
    ("off", "disable", "disabled", "no", "not", "dont", "old", "orig", "original", "backup", "bak", "unused", "ignore", "ignored", "skip",
     "hide", "hidden", "todo", "comment", "commented", "deactivated", "inactive", "removed", "dead")
)  # fmt: skip
"""Words that people put to the name of a tag or attribute to switch it off."""


MOST_LOOKED_AT = 8_000
MOST_COMPARED = 2_000
"""Names that one is looked up in, and those of about its length and letters that it is compared with, letter by letter."""


@lru_cache(maxsize=8192)  # the same misspelt names come up in every configuration
def distance(left: str, right: str, limit: int = 3) -> int:
    """Damerau-Levenshtein distance (insert, delete, replace, swap neighbours), at most ``limit`` + 1."""
    if left == right:
        return 0
    if abs(len(left) - len(right)) > limit:
        return limit + 1
    alike = _alike(left, right)  # what both begin and end with takes no slip
    left, right = left[alike:], right[alike:]
    alike = _alike(left[::-1], right[::-1])
    left, right = left[: len(left) - alike], right[: len(right) - alike]
    before: list[int] = []
    previous = list(range(len(right) + 1))
    for row, char in enumerate(left, 1):
        current = [row]
        for column, other in enumerate(right, 1):
            cost = min(previous[column] + 1, current[column - 1] + 1, previous[column - 1] + (char != other))
            if row > 1 and column > 1 and char == right[column - 2] and left[row - 2] == other:
                cost = min(cost, before[column - 2] + 1)
            current.append(cost)
        if min(current) > limit:
            return limit + 1
        before, previous = previous, current
    return previous[-1]


def _alike(left: str, right: str) -> int:
    """How many characters two names begin with alike."""
    return next((index for index, (one, other) in enumerate(zip(left, right, strict=False)) if one != other), min(len(left), len(right)))


def closest(name: str, names: Iterable[str]) -> str | None:
    """The name of ``names`` that ``name`` is most likely a slip for; ``None`` where none is near enough.

    Near enough is one slip in a name of up to four letters, two in one of up to eight, three in a longer one. Letter case and
    the difference between ``-`` and ``_`` count as one slip together. Of several, the nearest and then alphabetically first. A name that
    says something else (:func:`differs_in_meaning`) is never near, nor one with another word: in ``min_height`` and ``scan_height`` most
    letters are the same, and no word is a slip for the other. Where more than :data:`MOST_COMPARED` look alike at first sight, none is;
    behind the first :data:`MOST_LOOKED_AT` nobody looks.
    """
    if not name:
        return None
    limit = _most_slips(len(name))
    bare = folded(name)
    letters = frozenset(name)
    best: tuple[int, str] | None = None
    compared = 0
    for candidate in islice(names, MOST_LOOKED_AT):
        if candidate == name or not candidate or abs(len(candidate) - len(name)) > limit:
            continue  # one slip changes the length by one
        if folded(candidate) == bare:
            apart = 1
        elif len(letters.difference(candidate)) > limit:
            continue  # and takes away one letter at most
        else:
            compared += 1
            if compared > MOST_COMPARED:
                return None
            apart = distance(name, candidate, limit if best is None else best[0])
        if (
            apart <= limit
            and apart < len(candidate)
            and (best is None or (apart, candidate) < best)
            and not differs_in_meaning(name, candidate)
            and not _has_another_word(name, candidate)
        ):
            best = (apart, candidate)
    return None if best is None else best[1]


def _most_slips(letters: int) -> int:
    """How many slips there may be in so many letters."""
    return 1 if letters <= 4 else 2 if letters <= 8 else 3


def _has_another_word(name: str, other: str) -> bool:
    """Whether one of the words of ``name`` is another one in ``other``, and not a slip for it or its beginning."""
    words, others = _words(name), _words(other)
    if len(words) != len(others) or len(words) < 2:
        return False
    return not all(_is_near(word, another) for word, another in zip(words, others, strict=True))


def _is_near(word: str, other: str) -> bool:
    """Whether two words may stand for one: by a slip, or because one of them is cut short."""
    shorter, longer = sorted((word, other), key=len)
    limit = _most_slips(len(longer))
    return longer.startswith(shorter) or distance(word, other, limit) <= limit


def one_slip(name: str, names: Iterable[str]) -> str | None:
    """The only name of ``names`` that is exactly one slip away; ``None`` where there is none or more than one.

    A name that says something else (:func:`differs_in_meaning`) is no slip.
    """
    near = slips(name, names)
    return near.pop() if len(near) == 1 else None


def slips(name: str, names: Iterable[str]) -> set[str]:
    """All names of ``names`` that are exactly one slip away, as :func:`one_slip` has it."""
    bare = folded(name)
    letters = frozenset(name)
    return {
        other
        for other in names
        if other != name
        and (folded(other) == bare or (len(letters.difference(other)) <= 1 and distance(name, other, 1) == 1))
        and not differs_in_meaning(name, other)
    }


def surely(name: str, names: Iterable[str]) -> str | None:
    """The name that ``name`` must be a slip for: the only one that is one slip away. A name of one or two letters may be anything."""
    return one_slip(name, names) if len(name) > 2 else None


def is_part(short: str, name: str) -> bool:
    """Whether ``name`` is ``short`` with words before or behind it: ``thermal_video_device`` says ``video_device``, too, with two words.

    A single word is too little: ``left_arm_name`` and ``name`` are two things.
    """
    return "_" in short.strip("_") and (name.endswith(f"_{short}") or name.startswith(f"{short}_"))


def same_letters(name: str, names: Iterable[str]) -> str | None:
    """The only name of ``names`` that is ``name`` but for blanks, ``_``, ``-``, letter case, and a ``_test`` or ``_node`` at its end."""
    wanted, without = _bare(name), _bare(name, shortened=True)
    same = {other for other in names if other != name and wanted and (wanted in _both(other) or without == _bare(other))}
    return same.pop() if len(same) == 1 else None


def _both(name: str) -> tuple[str, str]:
    return _bare(name), _bare(name, shortened=True)


def _bare(name: str, *, shortened: bool = False) -> str:
    """``name`` in small letters alone, with its ending; ``shortened`` without a last ``_test`` or ``_node``."""
    stem, dot, end = name.casefold().rpartition(".")
    stem, end = (stem, dot + end) if dot else (end, "")
    words = [word for word in _BETWEEN.split(stem) if word]
    if shortened and len(words) > 1 and words[-1] in ("test", "node"):
        words.pop()
    return "".join(words) + end if words else ""


def did_you_mean(name: str, names: Iterable[str]) -> str:
    """A help text, ``did you mean …?``, or the empty string."""
    near = closest(name, names)
    return "" if near is None else f"did you mean {near}?"


def differs_in_meaning(name: str, other: str) -> bool:
    """Whether two names that look alike stand for two things: other numbers in them, or opposites in the same place.

    ``laser_1`` and ``laser_2``, ``min_range`` and ``max_range``, ``goal_x`` and ``goal_y``, ``arm_l`` and ``arm_r``, ``known`` and
    ``unknown``: whoever writes one of them does not mean the other.
    """
    if _NUMBER.findall(name) != _NUMBER.findall(other):
        return True
    words, others = _words(name), _words(other)
    if len(words) != len(others):
        return False
    return any(word != another and _are_opposites(word, another) for word, another in zip(words, others, strict=True))


def _words(name: str) -> list[str]:
    return [word.lower() for part in _WORD.findall(name) for word in _HUMP.split(part)]


def _are_opposites(word: str, other: str) -> bool:
    if len(word) == len(other) == 1:
        return True
    if any(word == negation + other or other == negation + word for negation in _NEGATIONS):
        return True
    before = _shared(word, other)
    after = _shared(word[::-1], other[::-1])
    return any(
        _stands_for(word, other, one, another, before, after) or _stands_for(word, other, another, one, before, after)
        for one, another in _OPPOSITES
    )


def _stands_for(word: str, other: str, part: str, opposite: str, before: int, after: int) -> bool:
    """Whether ``other`` is ``word`` with ``opposite`` in the place of ``part``; they begin with ``before`` and end with ``after`` letters
    alike.
    """
    if len(word) - len(part) != len(other) - len(opposite):
        return False
    start = word.find(part)
    while 0 <= start <= before:
        if len(word) - start - len(part) <= after and other.startswith(opposite, start):
            return True
        start = word.find(part, start + 1)
    return False


def _shared(word: str, other: str) -> int:
    """How many letters two words have in common at their beginning."""
    return next((at for at, (one, another) in enumerate(zip(word, other, strict=False)) if one != another), min(len(word), len(other)))


def switched_off(name: str, names: Iterable[str]) -> str | None:
    """The name of ``names`` that stands whole in ``name``, with something put before or after it to switch it off, if there is one.

    That is one letter or mark in front (``anode``, ``_if``, ``xxnode``), an ``x``, digit or mark behind (``node_``), or a word that says
    so (``launch-prefix-off``, ``DISABLED_node``). No such thing are the slips: a letter written twice (``nnode``), a plural (``nodes``),
    another letter behind (``noder``).
    """
    for known in sorted(names, key=lambda each: (-len(each), each)):
        if name.endswith(known) and _is_off(name[: -len(known)], known[:1], front=True):
            return known
        if name.startswith(known) and _is_off(name[len(known) :], known[-1:], front=False):
            return known
    return None


def _is_off(added: str, neighbour: str, *, front: bool) -> bool:
    word = added.strip("_-.:").lower()
    if not added or word in _OFF or not word:
        return bool(added)
    if len(set(word)) > 1:
        return False
    if front:
        return len(word) < len(added) or len(word) > 1 or word != neighbour.lower()
    return (word[0] == "x" or word.isdigit()) and (len(word) < len(added) or neighbour.lower() != word[0])


def same_digits(name: str, other: str) -> bool:
    """Whether two names have the same digits: ``drive1`` and ``drive2`` are neighbours, and neither is a slip for the other.

    What :func:`closest` and :func:`one_slip` find has them anyway.
    """
    return "".join(filter(str.isdigit, name)) == "".join(filter(str.isdigit, other))


def folded(name: str) -> str:
    """``name`` as far as packages and their repositories are called alike: ``FAST-LIO`` holds ``fast_lio``."""
    return name.casefold().replace("-", "_")
