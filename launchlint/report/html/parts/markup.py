"""HTML that cannot be made by accident: what is not written in launchlint's own code is escaped."""

from __future__ import annotations

from collections.abc import Iterable

_ESCAPES = (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("'", "&#39;"), ('"', "&#34;"))


class Markup(str):
    """HTML as it stands in the page; any other text is content, or the value of an attribute in quotes."""

    __slots__ = ()


NOTHING = Markup()


def escaped(value: object) -> Markup:
    """``value`` as content or as the value of an attribute in quotes; markup stays what it is."""
    if type(value) is Markup:
        return value
    text = str(value)
    if not text.isalnum():
        for character, reference in _ESCAPES:
            text = text.replace(character, reference)
    return Markup(text)


def markup(template: str, **values: object) -> Markup:
    """``template``, a literal of launchlint's own code, with each ``{name}`` replaced by that of ``values``, escaped."""
    return Markup(template.format_map({name: escaped(value) for name, value in values.items()}))


def joined(parts: Iterable[Markup]) -> Markup:
    """All parts, one behind the other."""
    return Markup("".join(parts))
