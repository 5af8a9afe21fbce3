"""``$(…)`` as roslaunch reads it (roslaunch.substitution_args.resolve_args, _collect_args, _eval).

A value that begins with ``$(eval `` and ends with ``)`` is one expression. In every other one each ``$(…)`` is a substitution; its words
stand between blanks. One that another ``$`` or a ``(`` stands in makes roslaunch refuse the value; one that is never closed, and ``$()``,
stay as they are, without a word: as do all the slips of the pen that are not quite a substitution.

roslaunch reads a value twice, since the path behind ``$(find pkg)`` takes part in the search: see :func:`parse_again`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice

from launchlint.late import late
from launchlint.syntax.parts import Expression, Literal, Malformed, Part, Parts, Substitution, Word

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.tree import Attribute

COMMANDS = ("find", "env", "optenv", "dirname", "anon", "arg")
"""What may stand first in a substitution; ``eval`` must fill the whole value."""

NESTED, PARENTHESIS = "nested", "parenthesis"
"""Kinds of :class:`~launchlint.syntax.parts.Malformed` that are refused: a ``$``, or a ``(``, stands in a substitution."""
LIKE, EXTRA = "like", "extra"
"""Kinds that stay in the value: nearly a substitution, and a ``)`` too many behind one."""

MOST_PARTS = 20_000
"""What stands behind that many parts is taken as text: it bounds memory. No evaluation of a value with so many comes to an end."""

_REFUSED = {
    "$": (NESTED, "a substitution cannot stand inside another one"),
    "(": (PARENTHESIS, "a parenthesis cannot stand inside a substitution"),
}
_EVAL = "$(eval "
_OPENED = re.compile(r"\$\(([^$()]*)(\)?)")
_WORD = re.compile(r"[^ ]+")
_LIKE = late(
    r"\$\s+\((?:find|env|optenv|dirname|anon|arg|eval)\b(?:\s+[\w./\-]+)*\s*\)?"
    r"|\$\{(?:find|env|optenv|anon|arg) [\w./\- ]*\}?"
    r"|\$\((?:find|env|optenv|dirname|anon|arg|eval)\b(?:\s+[\w\-]+)?[}\]]?"
    r"|\$(?:find|env|optenv|anon|arg) +[\w\-]+(?: +[^()$ ]+)*\)"
    r"|\$(?:find|env|optenv|anon|arg)\( *[\w\-]+ *\)"
    r"|(?<![\w$)])\((?:find|optenv|anon|arg) [\w\-]+\)"
    r"|\$\[(?:find|arg|env) [\w./\- ]*\]?"
)
_MEANT = late(r"[^\s$(){}\[\]]+")


def is_plain(text: str) -> bool:
    """Whether nothing in ``text`` is, or looks like, a substitution: told without taking it apart."""
    return "$" not in text and "(" not in text


def opens(text: str) -> bool:
    """Whether a ``$(`` stands in ``text``, closed or not, so that some of it may be computed: told without taking it apart."""
    return "$(" in text


def parts_of(attribute: Attribute) -> Parts:
    """The value of ``attribute``, taken apart the first time that this is asked for."""
    known = attribute.parts
    if known is None:
        known = attribute.parts = parse(attribute.value)
    return known


def is_computed(attribute: Attribute) -> bool:
    """Whether something is put in place of any of the value of ``attribute``."""
    return "$" in attribute.value and parts_of(attribute).computed


def parse(text: str) -> Parts:
    """Take ``text`` apart, in time that grows with its length."""
    if "$" not in text and "(" not in text:
        return Parts(text, (Literal(text, 0, len(text)),) if text else ())
    if text.startswith(_EVAL) and text.endswith(")"):
        whole = Expression(text, 0, len(text), text[len(_EVAL) : -1], len(_EVAL))
        return Parts(text, (whole,), whole)
    return parse_again(text)


def parse_again(text: str) -> Parts:
    """Take apart what is left of a text after roslaunch has read it once: nothing is an expression any more."""
    parts: list[Part] = []
    refused: Malformed | None = None
    done = 0
    for match in _OPENED.finditer(text):
        start, end = match.span()
        if len(parts) > MOST_PARTS:
            return Parts(text, (*parts, Literal(text[done:], done, len(text))), refused=refused)
        if match[2]:
            if not match[1]:
                continue  # "$()" is text
            found: Substitution | Malformed = Substitution(match[0], start, end, _words(match[1], start + 2))
        elif end < len(text):
            kind, reason = _REFUSED[text[end]]
            found = Malformed(match[0], start, end, kind, _words(match[1], start + 2), reason)
            refused = refused or found
        else:
            break  # never closed: text
        if done < start:
            parts += _between(text[done:start], done)
        parts.append(found)
        done = end
    if done < len(text):
        parts += _between(text[done:], done)
    alone = parts[0] if len(parts) == 1 else None
    return Parts(text, tuple(_with_extra(parts)), alone if isinstance(alone, Substitution) else None, refused)


def expression_in(text: str) -> str | None:
    """The expression that ``text`` is, without the ``$(eval …)`` around it; None where it is none."""
    return text[len(_EVAL) : -1] if text.startswith(_EVAL) and text.endswith(")") else None


def only_arg(parts: Parts) -> str:
    """The name of the arg where the value is ``$(arg name)`` and nothing else: most of what launch files hold. Else empty."""
    alone = parts.alone
    return alone.only if isinstance(alone, Substitution) and alone.command == "arg" else ""


def slip(parts: Parts) -> Malformed | None:
    """The first part that stays in the value though it looks like a substitution; where there is none, a parenthesis too many."""
    found = None
    for part in parts.parts:
        if isinstance(part, Malformed) and not part.refused:
            if part.kind == LIKE:
                return part
            found = part
    return found


def _words(inner: str, at: int) -> tuple[Word, ...]:
    return tuple(Word(match[0], at + match.start(), at + match.end()) for match in _WORD.finditer(inner))


def _between(text: str, at: int) -> Iterator[Literal | Malformed]:
    """The parts of a text that begins at ``at``, between two substitutions."""
    done = 0
    if not is_plain(text):
        for match in islice(_LIKE.finditer(text), MOST_PARTS):
            start, end = match.span()
            if done < start:
                yield Literal(text[done:start], at + done, at + start)
            words = tuple(Word(word[0], at + start + word.start(), at + start + word.end()) for word in _MEANT.finditer(match[0]))
            yield Malformed(match[0], at + start, at + end, LIKE, words)
            done = end
    if done < len(text):
        yield Literal(text[done:], at + done, at + len(text))


def _with_extra(parts: list[Part]) -> list[Part]:
    """``parts``, the first ``)`` right behind a substitution as one of its own where more are closed than were opened."""
    literals = [part.text for part in parts if not isinstance(part, Substitution)]
    if sum(map(_closed, literals)) <= 0:
        return parts
    for number in range(1, len(parts)):
        part = parts[number]
        if isinstance(part, Literal) and part.text[0] == ")" and isinstance(parts[number - 1], Substitution):
            extra = Malformed(")", part.start, part.start + 1, EXTRA)
            rest = [Literal(part.text[1:], part.start + 1, part.end)] if len(part.text) > 1 else []
            return [*parts[:number], extra, *rest, *parts[number + 1 :]]
    return parts


def _closed(text: str) -> int:
    return text.count(")") - text.count("(")
