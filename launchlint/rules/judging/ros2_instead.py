"""What does in all distributions of ROS 2 what a substitution does in some: for those who cannot wait for the next one."""

from __future__ import annotations

from collections.abc import Callable

from launchlint.source import Place

_MOST_LETTERS = 2_000


def instead_of(name: str, place: Place) -> str:
    """What to write for the substitution ``name`` at ``place``, with its own words; empty where there is nothing like it."""
    made = _INSTEAD.get(name)
    text = place.text
    if made is None or len(text) > _MOST_LETTERS or not text.startswith("$("):
        return ""
    words = _words(text[2:-1])[1:]
    quote = "&quot;" if place.source.text.lstrip().startswith("<") else '"'
    try:
        return made(words, quote)
    except (IndexError, ValueError):
        return ""


def _words(text: str) -> list[str]:
    """The words of a substitution, without the quotes around them; those in parentheses stay together."""
    words: list[str] = []
    word, depth, quoted = "", 0, ""
    for char in text.replace("&quot;", '"').replace("&apos;", "'"):
        if char == quoted or (not quoted and depth == 0 and char in "'\""):
            quoted = "" if quoted else char
            continue
        depth += 0 if quoted else (char == "(") - (char == ")")
        if char == " " and not quoted and depth == 0:
            words.append(word)
            word = ""
        else:
            word += char
    return [*words, word]


def _compared(sign: str) -> Callable[[list[str], str], str]:
    def made(words: list[str], quote: str) -> str:
        left, right = words
        return f"$(eval {quote}'{left}' {sign} '{right}'{quote})"

    return made


def _chosen(words: list[str], quote: str) -> str:
    other = words[2] if len(words) > 2 else ""
    return f"$(eval {quote}'{words[1]}' if '{words[0]}' == 'true' else '{other}'{quote})"


def _joined(sign: str) -> Callable[[list[str], str], str]:
    def made(words: list[str], quote: str) -> str:
        whole = words[-1]
        for word in reversed(words[:-1]):
            whole = f"$({sign} {word} {whole})"
        return whole

    return made


_INSTEAD: dict[str, Callable[[list[str], str], str]] = {
    "if": _chosen,
    "equals": _compared("=="),
    "not-equals": _compared("!="),
    "launch_log_dir": lambda words, quote: "$(log_dir)",
    "path-join": lambda words, quote: "/".join(words),
    "string-join": lambda words, quote: words[0].join(words[1:]),
    "file-content": lambda words, quote: f"$(command 'cat {words[0]}')",
    "param": lambda words, quote: f"$(param {words[0]})",
    "any": _joined("or"),
    "all": _joined("and"),
}
