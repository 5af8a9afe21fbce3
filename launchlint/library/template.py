"""Names that take parts from the instance of a node: ``{arg:2|{arg:1}_relay}`` (see ``docs/library-format.md``).

A template is parsed once into a tuple of parts, plain strings and :class:`Slot`. Filling it in gives the text, None where a part has no
value (the entry does not exist), or an :class:`Undetermined` where a part cannot be known statically.
"""

from __future__ import annotations

from functools import lru_cache

from launchlint.late import late
from launchlint.library.terms import DEEPEST_CONDITION
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Final, Protocol

    class Situation(Protocol):
        """What templates and conditions look into: one node as it is started. Values may be :data:`UNKNOWN`."""

        node: Any

        def argument(self, position: int) -> Any:
            """The positional argument, counted from 1 or from -1; None where there is none."""

        def arguments_from(self, position: int) -> Any:
            """All positional arguments from one on."""

        def option(self, name: str) -> Any:
            """The value of an option of the command line (True where it takes none); None where it is not given."""

        def param(self, name: str) -> Any:
            """The value of a param as the launch file sets it; None where it does not."""

        def resolved(self, name: str) -> str:
            """A name, resolved and remapped."""

        def is_remapped(self, name: str) -> bool:
            """Whether a remapping acts on the name."""


class Undetermined:
    """A value that exists but cannot be known without running the system; ``pattern`` is what is known of its text, ``*`` for the rest."""

    __slots__ = ("pattern",)

    def __init__(self, pattern: str) -> None:
        self.pattern = pattern

    def __repr__(self) -> str:
        return f"Undetermined({self.pattern!r})"


UNKNOWN: Final = Undetermined("*")
"""A value of which nothing is known."""


class TemplateError(ValueError):
    """A template that is not well formed; ``str(error)`` says why."""


class Slot(NamedTuple):
    """``{kind:key|default}``. The key of ``remap`` and ``parent`` may hold templates: it is in ``inner``."""

    kind: str
    key: str
    default: Template | None
    inner: Template = ()


Template = tuple[str | Slot, ...]

SLOTS = {"arg": True, "option": True, "param": True, "remap": True, "parent": True, "each": False, "node": False, "any": False}
"""The kinds of slots, and whether they must have a key."""
_NAMES = ("remap", "parent")
_ARGUMENT = late(r"-?[1-9][0-9]{0,3}")


@lru_cache(maxsize=4096)
def parse(text: str) -> Template:
    """The parts of a template.

    Raises:
        TemplateError: it is not well formed.
    """
    parts, end = _parts(text, 0, 0)
    if end < len(text):
        raise TemplateError("it has a } that closes nothing; a brace itself is written twice")
    return parts


def _parts(text: str, start: int, depth: int) -> tuple[Template, int]:
    """The parts from ``start`` to the end, or to the brace that closes this level."""
    if depth > DEEPEST_CONDITION:
        raise TemplateError("its templates are nested too deep")
    parts: list[str | Slot] = []
    plain: list[str] = []
    at = start
    while at < len(text):
        char = text[at]
        if char in "{}" and text[at : at + 2] == char * 2 and not (char == "}" and depth):
            plain.append(char)
            at += 2
        elif char == "{":
            if plain:
                parts.append("".join(plain))
                plain = []
            slot, at = _slot(text, at + 1, depth + 1)
            parts.append(slot)
        elif char == "}":
            break
        else:
            plain.append(char)
            at += 1
    if plain:
        parts.append("".join(plain))
    return tuple(parts), at


def _slot(text: str, start: int, depth: int) -> tuple[Slot, int]:
    end = start
    while end < len(text) and text[end] not in "|{}":
        end += 1
    kind, colon, key = text[start:end].partition(":")
    if kind in _NAMES and colon:
        inner, end = _parts(text, start + len(kind) + 1, depth)
        if not inner or text[end : end + 1] != "}":
            raise TemplateError(f"its {{{kind}}} {'is not closed' if inner else 'needs a name'}")
        if any(isinstance(part, str) and "|" in part for part in inner):
            raise TemplateError(f"{{{kind}}} always has a value: it takes no default")
        return Slot(kind, text[start + len(kind) + 1 : end], None, inner), end + 1
    if kind not in SLOTS:
        raise TemplateError(f"{{{kind}}} is no template; there are {', '.join(SLOTS)}")
    if bool(key) < SLOTS[kind] or (colon and kind in ("node", "any")):
        raise TemplateError(f"{{{kind}}} needs a {':' if SLOTS[kind] else '}'} after its name")
    if kind == "arg" and not _ARGUMENT.fullmatch(key):
        raise TemplateError(f"{{arg:{key}}} must be the number of an argument, counted from 1 or from -1")
    default: Template | None = None
    if text[end : end + 1] == "|":
        if kind in ("node", "any"):
            raise TemplateError(f"{{{kind}}} always has a value: it takes no default")
        default, end = _parts(text, end + 1, depth)
    if text[end : end + 1] != "}":
        raise TemplateError(f"its {{{kind}}} is not closed")
    return Slot(kind, key, default), end + 1


def is_template(name: str) -> bool:
    """Whether ``name`` depends on the instance."""
    return "{" in name or "}" in name


def fill(parts: Template, situation: Situation, each: Any = None) -> str | Undetermined | None:
    """The text of a template in a situation; ``each`` is the thing its entry is at.

    Returns None where a part has no value and no default; an :class:`Undetermined` where one cannot be known.
    """
    filled: list[str] = []
    unknown = False
    for part in parts:
        value: Any = part
        if isinstance(part, Slot):
            value = _value(part, situation, each)
            if value is None and part.default is not None:
                value = fill(part.default, situation, each)
        if value is None:
            return None
        if isinstance(value, (str, int, float)):
            filled.append(value if isinstance(value, str) else spelled(value))
        else:
            unknown = True
            filled.append(value.pattern if isinstance(value, Undetermined) else "*")
    text = "".join(filled)
    return Undetermined(text) if unknown else text


def spelled(value: float | bool) -> str:
    """A number or truth value as text."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def _value(slot: Slot, situation: Situation, each: Any) -> Any:
    if slot.kind == "arg":
        return situation.argument(int(slot.key))
    if slot.kind == "option":
        return situation.option(slot.key)
    if slot.kind == "param":
        return situation.param(slot.key)
    if slot.kind == "each":
        return member(each, slot.key)
    if slot.kind == "node":
        return situation.node
    if slot.kind == "any":
        return UNKNOWN
    name = fill(slot.inner, situation, each)
    if not isinstance(name, str):
        return name
    resolved = situation.resolved(name)
    return resolved if slot.kind == "remap" else resolved.rpartition("/")[0]


def member(each: Any, key: str) -> Any:
    """``{each}`` or ``{each:key}``: a :class:`Thing`, its name or a member of its value."""
    if each is None or isinstance(each, Undetermined):
        return each
    if not key:
        return each.name
    value = each.value
    for step in key.split("/"):
        if isinstance(value, Undetermined):
            return value
        value = value.get(step) if isinstance(value, dict) else None
    return value


class Thing(NamedTuple):
    """What ``each`` is at: an item of a list, or a key of a mapping with its value."""

    name: Any
    value: Any


def default_text(name: str) -> str:
    """``name`` with every slot at its default: what a node run without args and params would show. Slots without default stay as written.

    Two names with the same default text are the same interface, one with its template known.
    """
    if not is_template(name):
        return name
    text = _default_of(parse(name))
    return f"~{text[1:].lstrip('/')}" if text.startswith("~/") else text


def _default_of(parts: Template) -> str:
    return "".join(part if isinstance(part, str) else _default(part) for part in parts)


def _default(slot: Slot) -> str:
    if slot.default is not None:
        return _default_of(slot.default)
    if slot.kind in _NAMES:
        name = _default_of(slot.inner)
        return name if slot.kind == "remap" else name.rpartition("/")[0]
    return f"{{{slot.kind}{':' if slot.key else ''}{slot.key}}}"
