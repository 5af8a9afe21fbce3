"""What does in all distributions of ROS 2 what a substitution does in some: for those who cannot wait for the next one."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from launchlint.source import Place
from launchlint.syntax.ros2.description import Text

_MOST_LETTERS = 2_000


def instead_of(name: str, words: Sequence[Text], place: Place) -> str:
    """What to write for the substitution ``name`` at ``place``, with its ``words``; empty where there is nothing like it."""
    made = _INSTEAD.get(name)
    if made is None or place.span.end - place.span.start > _MOST_LETTERS or not place.text.startswith("$("):
        return ""
    written = [each.place.text.replace("&quot;", '"').replace("&apos;", "'") for each in words]
    quote = "&quot;" if place.source.text.lstrip().startswith("<") else '"'
    try:
        return made(written, quote)
    except (IndexError, ValueError):
        return ""


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
