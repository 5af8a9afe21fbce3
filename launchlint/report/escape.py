"""Every way in which hostile text is made harmless before somebody reads it.

Names, paths and lines come from the checked repository. Whatever they hold, the terminal, the log of a CI system, a Markdown or HTML page
and an XML reader must see plain characters only.
"""

from __future__ import annotations

_WIDE_SPACE = "\u3000"
"""The space of East Asian texts: not printable for Python, yet harmless and common."""

_MARKDOWN = {ord(character): f"&#{ord(character)};" for character in "!\"$%&'()*+:<=>?[\\]^_`{|}~"} | {
    ord("@"): "&#64;&#8203;",
    ord("#"): "&#35;&#8203;",
}


def visible(text: str) -> str:
    r"""``text`` for a terminal, in one line.

    Control characters, ESC, line and paragraph separators, bidi marks, invisible format characters, lone surrogates and unassigned
    characters become escapes like ``\x1b`` or ``\u202e``; a byte of a file name that is no UTF-8 becomes ``\xff``. Tabs too: callers
    that show source lines expand them first. ``##[`` is broken, since GitHub takes it for a command wherever it stands in a line.
    """
    if not text.isprintable():
        text = "".join(character if character.isprintable() or character == _WIDE_SPACE else _escaped(character) for character in text)
    return text.replace("##[", "##\\x5b") if "##[" in text else text


def line_start(text: str) -> str:
    """A path that stands at the start of a line: as :func:`visible`, and never taken for a GitHub workflow command (``::name::``)."""
    shown = visible(text)
    return f"./{shown}" if shown.lstrip().startswith("::") else shown


def _escaped(character: str) -> str:
    code = ord(character)
    if character in "\t\n\r":
        return {"\t": "\\t", "\n": "\\n", "\r": "\\r"}[character]
    if 0xDC80 <= code <= 0xDCFF:  # how Python holds the bytes of a file name that are no UTF-8 (PEP 383)
        code -= 0xDC00
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def no_surrogates(text: str) -> str:
    """``text`` with lone surrogates as visible escapes: strict JSON readers refuse the whole document for one of them."""
    return (
        text if text.isascii() else "".join(_escaped(character) if "\ud800" <= character <= "\udfff" else character for character in text)
    )


def shell_word(text: str) -> str:
    """``text`` as one word of a POSIX shell; with characters that :func:`visible` would escape, in the form ``$'…'`` of bash and zsh."""
    if visible(text) == text:
        from shlex import quote

        return quote(text)
    out: list[str] = []
    for character in text:
        if character in "\\'":
            out.append("\\" + character)
        elif character.isprintable() or character == _WIDE_SPACE:
            out.append(character)
        else:
            out.append(_escaped(character))
    return "$'" + "".join(out).replace("##[", "##\\x5b") + "'"


def github_message(text: str) -> str:
    """The text after ``::`` of a GitHub workflow command; line feeds that are meant are kept, as ``%0A``."""
    return "%0A".join(visible(line).replace("%", "%25") for line in text.split("\n"))


def github_property(text: str) -> str:
    """The value of a property (``file=``, ``title=``) of a GitHub workflow command."""
    return visible(text).replace("%", "%25").replace(":", "%3A").replace(",", "%2C")


def html(text: str) -> str:
    """``text`` for HTML, as content or as an attribute value in quotes.

    Invisible characters are shown as escapes, line feeds and tabs are kept.
    """
    shown = "".join(character if character in "\n\t" else visible(character) for character in text)
    for character, entity in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;"), ("'", "&#39;")):
        shown = shown.replace(character, entity)
    return shown


def markdown(text: str) -> str:
    """``text`` as part of a line of Markdown (also in a table cell): never markup, HTML, a link, an issue or a mention.

    Punctuation becomes character references, which have no meaning for Markdown; a zero-width space after ``@`` and ``#`` keeps GitHub
    from finding users and issues.
    """
    return visible(text).translate(_MARKDOWN).replace("www.", "www&#46;")


def xml(text: str) -> str:
    """``text`` for XML 1.0, as content or as an attribute value in quotes.

    Characters that XML forbids and invisible ones are shown as escapes, line feeds are kept.
    """
    shown = "\n".join(visible(line) for line in text.split("\n"))
    for character, entity in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;")):
        shown = shown.replace(character, entity)
    return shown
