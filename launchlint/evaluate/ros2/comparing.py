"""What launch configurations are compared with: the values that somebody would give them.

Only those count whose value is that of an arg as a whole, and so can be given on the command line.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from launchlint.evaluate.ros2.performing import Performer
from launchlint.syntax.ros2.description import Substitution, Text

TRUTH = ("true", "false")
CAPITALS = ("True", "False")
_MOST_KEPT = 512
_MARK = "configuration_"


def same_as(performer: Performer, text: Text) -> str | None:
    """The arg whose value ``text`` stands for as a whole, if it does."""
    name = _only_variable(text)
    setting = None if name is None else performer.context.get(name)
    return setting.same if setting is not None else name


def _only_variable(text: Text) -> str | None:
    if len(text.pieces) != 1 or isinstance(text.pieces[0], str) or text.pieces[0].name != "var" or not text.pieces[0].arguments:
        return None
    return text.pieces[0].arguments[0].literal


def _words_of_default(text: Text) -> tuple[str, str] | None:
    """How Python writes truth values, where what stands for a configuration that is not set is written so."""
    if _only_variable(text) is None or not isinstance(piece := text.pieces[0], Substitution) or len(piece.arguments) < 2:
        return None
    return CAPITALS if piece.arguments[1].literal in CAPITALS else None


def _note(performer: Performer, name: str | None, values: Iterable[str]) -> None:
    if name is not None:
        performer.compared.append((name, tuple(values)))


def note_choices(performer: Performer, name: str, choices: tuple[str, ...] | None) -> None:
    """The choices of an arg."""
    setting = performer.context.get(name)
    if choices is not None and setting is not None:
        _note(performer, setting.same, choices)


def note_truth(performer: Performer, text: Text) -> None:
    """A text that is asked whether it is true: a configuration, or ``not``, ``and``, ``or`` and ``if`` of some."""
    _note(performer, same_as(performer, text), _words_of_default(text) or TRUTH)
    for piece in text.pieces:
        if isinstance(piece, Substitution) and piece.name in ("not", "and", "or", "if"):
            for argument in piece.arguments[:1] if piece.name == "if" else piece.arguments:
                note_truth(performer, argument)


def note_equals(performer: Performer, substitution: Substitution) -> None:
    """``$(equals left right)``."""
    if len(substitution.arguments) == 2:
        left, right = substitution.arguments
        for side, other in ((left, right), (right, left)):
            literal = other.literal
            if literal is not None:
                _note(performer, same_as(performer, side), (literal,))


def note_expression(performer: Performer, substitution: Substitution) -> None:
    """``$(eval …)``: each ``$(var x)`` in it, in quotes or not, is taken for a name that is compared with something."""
    if not substitution.arguments:
        return
    written: list[str] = []
    names: list[str | None] = []
    for piece in substitution.arguments[0].pieces:
        if isinstance(piece, str):
            written.append(piece)
        else:
            written.append(f"{_MARK}{len(names)}")
            names.append(same_as(performer, Text((piece,), piece.place)))
    if not any(name is not None for name in names):
        return
    for place, values in _compared("".join(written), len(names)):
        _note(performer, names[place], values)


@lru_cache(maxsize=_MOST_KEPT)
def _compared(text: str, count: int) -> tuple[tuple[int, tuple[str, ...]], ...]:
    """The places among the configurations of an expression, with what each is compared with; quotes around them are taken away."""
    from launchlint.evaluate.ros1.expression import compared_literals

    for place in reversed(range(count)):
        for quote in ("'", '"'):
            text = text.replace(f"{quote}{_MARK}{place}{quote}", f"{_MARK}{place}")
    found = compared_literals(text, parts=False)
    return tuple((place, found[f"{_MARK}{place}"]) for place in range(count) if f"{_MARK}{place}" in found)
