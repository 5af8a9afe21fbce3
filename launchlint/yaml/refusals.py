"""Why a text is no YAML, in plain words."""

from __future__ import annotations

from launchlint.late import late

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

COLON = late(r"[A-Za-z_][\w./~-]*:(?![:/\\])\S")
"""A ``key:value`` without the blank."""


class YamlError(Exception):
    """What a reader of YAML refuses: ``message`` in plain words, ``offset`` in the text, and a ``kind``.

    Kinds: ``syntax``, ``colon`` (a ``key:value`` without the blank; to the end of its line), ``character`` (one that YAML does not
    allow), ``documents`` (more than one), ``anchor`` (unknown alias, anchor used twice), ``tag`` (unknown), ``value`` (does not fit its
    tag), ``key`` (not a text, or not usable as a key), ``merge``. ``problem`` is what PyYAML says, if it is PyYAML that refuses.
    """

    def __init__(self, message: str, offset: int, kind: str, problem: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.problem = problem
        self.offset = offset
        self.kind = kind


_NEVER_CLOSED = "found unexpected end of stream"
_OUT_OF_STEP = ("expected ',' or", "expected <block end>", "could not find expected ':'", "mapping values are not allowed here")
"""What YAML says behind a text in quotes that has ended in another place than it was meant to."""
_LONGEST_SCANNED = 200_000

_PLAIN_WORDS = (
    (
        "expected alphabetic or numeric character, but found ':'",
        "this line is no YAML directive; files that OpenCV writes start with %YAML:1.0, and READER cannot load them",
    ),
    ("found character '\\t' that cannot start", "a tab stands here, and YAML wants blanks; replace the tab by blanks"),
    ("that cannot start any token", "a value cannot start with this character; put the value in quotes"),
    (
        "mapping values are not allowed here",
        "a second colon stands where no key can be; the indentation differs from the lines above, or the value needs quotes",
    ),
    ("could not find expected ':'", "a line before this place lacks its colon, or the blank behind it"),
    ("expected <block end>", "this line does not line up with the lines above it; give entries of one level the same indentation"),
    ("expected ',' or ']'", "a list that starts with [ lacks a comma or its ] here"),
    ("expected ',' or '}'", "a mapping that starts with { lacks a comma or its } here"),
    (_NEVER_CLOSED, "a text in quotes is never closed"),
    ("found unexpected document separator", "a text in quotes is never closed before the next document starts"),
    ("found unknown escape character", "this backslash sequence is not known; in double quotes, write a backslash as two"),
    ("expected the node content", "a value is missing here"),
    ("sequence entries are not allowed here", 'a "- " cannot stand here; start the list on a line of its own'),
)


def too_deep(error: Any) -> int | None:
    """Where libyaml refuses a text for its depth alone, as it does since version 0.2.6, before it says what comes first; else None."""
    is_depth = "exceeded maximum nesting depth" in str(getattr(error, "problem", None))
    return int(error.problem_mark.index) if is_depth else None


def explain(error: Any, text: str, reader: str) -> YamlError:
    """What the pure Python parser of PyYAML refused in ``text``, for people; ``reader`` names who cannot load it."""
    position = getattr(error, "position", None)
    if isinstance(position, int):
        return YamlError(
            f"YAML does not allow the character U+{ord(text[position]):04X}, which stands here" if position < len(text) else "bad text",
            min(position, len(text)),
            "character",
            str(error.reason),
        )
    mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
    offset = min(mark.index if mark is not None else 0, len(text))
    problem = str(getattr(error, "problem", None) or error)[:200]
    start = _missing_blank(text, offset) if "could not find expected ':'" in problem else None
    if start is not None:
        return YamlError(f"a blank lacks behind this colon (YAML says: {problem})", start, "colon", problem)
    opened = _opened(error, text, offset, problem)
    if opened is not None:
        return YamlError(f"{opened[1]} (YAML says: {problem})", opened[0], "syntax", problem)
    if "that cannot start any token" in problem and text[offset : offset + 1] == "\t":
        problem = "found character '\\t' that cannot start any token"  # libyaml does not say which
    for sign, words in _PLAIN_WORDS:
        if sign in problem:
            return YamlError(f"{words.replace('READER', reader)} (YAML says: {problem})", offset, "syntax", problem)
    return YamlError(f"this is not valid YAML (YAML says: {problem})", offset, "syntax", problem)


def _opened(error: Any, text: str, offset: int, problem: str) -> tuple[int, str] | None:
    """Where the quote stands whose other one is missing, and what to say of it: YAML notices that only at the next quote, or at the end."""
    context = getattr(error, "context_mark", None)
    if _NEVER_CLOSED in problem and context is not None:
        return min(context.index, len(text)), "the text in quotes that begins here is never closed"
    if len(text) > _LONGEST_SCANNED or not any(sign in problem for sign in _OUT_OF_STEP):
        return None
    import yaml

    try:
        for token in yaml.scan(text, Loader=yaml.SafeLoader):
            start, end = token.start_mark, token.end_mark
            if end.index > offset:
                break
            if (
                isinstance(token, yaml.ScalarToken)
                and token.style in ("'", '"')
                and start.line < end.line
                and not text[end.index : offset].strip()
            ):
                return (
                    start.index,
                    f"the text in quotes that begins here ends in line {end.line + 1}, in the middle of something; its quote is missing",
                )
    except yaml.YAMLError:
        return None
    return None


def _missing_blank(text: str, offset: int) -> int | None:
    """Where ``key:value`` stands in the line of ``offset`` or the last one before it with anything in it: YAML notices it only there."""
    before = text[:offset].rstrip()
    for end in (offset, len(before)):
        start = text.rfind("\n", 0, end) + 1
        line = text[start : text.find("\n", end) + 1 or len(text)]
        if COLON.match(line.strip()) is not None:
            return start + len(line) - len(line.lstrip())
    return None
