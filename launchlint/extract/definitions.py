"""Which sources of a library a class is made of: those that define it, and those that define what these and their headers name.

Told by words, nothing being understood: a source defines the classes and functions whose bodies stand in it, and is needed where a needed
file names one of them. A source of which that cannot be told is always needed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence

_SKIPPED = re.compile(
    r'//[^\n]*|/\*.*?(?:\*/|\Z)|\bR"(\w{0,16})\(.*?(?:\)\1"|\Z)|"(?:\\.|[^"\\\n])*"?|\'(?:\\.|[^\'\\\n]){1,4}\'|^[ \t]*#(?:\\.|[^\\\n])*',
    re.DOTALL | re.MULTILINE,
)
_EXPORT = re.compile(r"\b(?:PLUGINLIB_\w{1,40}|RCLCPP_COMPONENTS_REGISTER_NODE)\s*\(([^;{}()]{0,300})\)\s*(?:;|$)", re.MULTILINE)
_BRACE = re.compile(r"[{};]")
_SPACE = re.compile(r"\b(?:inline\s+)?namespace\b(?:\s*([\w:]+))?\s*\Z")
_LINKAGE = re.compile(r"(?<!\w)extern\s*\Z")
_CLASS = re.compile(r"\b(?:class|struct|union|enum)\b([^(={;]*)\Z")
_BASES = re.compile(r"(?<!:):(?!:)")
_ANGLES = re.compile(r"<[^<>]*>")
_WORD = re.compile(r"[A-Za-z_]\w*")
_OWNER = re.compile(r"\b(\w+)\s*::\s*~?\w+\W*\Z")
_PARAMETERS = re.compile(r"\b(?:void|bool|char|short|int|long|float|double|unsigned|signed|const|auto)\b|\w\s*[&*]|\w\s+\w|>\s*\w|\.\.\.")
"""What stands in the brackets of a declared function, and not in those of a variable that is made from values."""
_NEW = re.compile(r"\bnew\s")
_NOTHING = frozenset("using typedef friend extern static const constexpr class struct enum union template namespace".split())
_LONGEST = 1_000
_MOST_NESTED = 8


def words_of(text: str) -> frozenset[str]:
    """The words of a text."""
    return frozenset(_WORD.findall(text))


def exported_words(text: str) -> frozenset[str]:
    """The words of all that a source exports as plugins."""
    if not _may_export(text):
        return frozenset()
    return frozenset(word for arguments in _EXPORT.findall(text) for word in _WORD.findall(arguments))


def _may_export(text: str) -> bool:
    return "PLUGINLIB_" in text or "RCLCPP_COMPONENTS_REGISTER_NODE" in text


def defined_names(text: str) -> frozenset[str] | None:
    """Names of classes, functions and variables that a source defines: of members the class. None where that cannot be told."""
    text = _SKIPPED.sub(" ", text)
    if _may_export(text):
        text = _EXPORT.sub(" ", text)
    found: set[str] = set()
    spaces: list[bool] = []
    depth = start = 0
    for token in _BRACE.finditer(text):
        kind = token[0]
        if depth:
            depth += {"{": 1, "}": -1}.get(kind, 0)
        else:
            end = token.start()
            chunk = text[start : min(end, start + _LONGEST)] if kind == ";" else text[max(start, end - _LONGEST) : end]
            space = _SPACE.search(chunk) if kind == "{" else None
            if space is not None or (kind == "{" and _LINKAGE.search(chunk)):
                spaces.append(space is not None and not space[1])
            elif kind == "}":
                if not spaces:
                    return None
                spaces.pop()
            else:
                names = _names(chunk.strip(), kind == "{")
                if names is None:
                    return None
                if not any(spaces):
                    found.update(names)
                depth = 1 if kind == "{" else 0
        if not depth:
            start = token.end()
    rest_is_known = depth == 0 and not spaces and _names(text[start : start + _LONGEST].strip(), False) is not None
    return frozenset(found) if rest_is_known else None


def _names(chunk: str, has_body: bool) -> tuple[str, ...] | None:
    """What one declaration at the top of a file defines."""
    for _ in range(_MOST_NESTED if "<" in chunk else 0):
        chunk = _ANGLES.sub("", chunk)
    declared = _CLASS.search(chunk) if has_body else None
    if declared is not None:
        words = [each for each in _WORD.findall(_BASES.split(declared[1])[0]) if each not in ("final", "class", "struct")]
        return tuple(words)
    head, bracket, inside = chunk.partition("(")
    if "=" in head and "operator" not in head:
        if bracket and not has_body:
            return None  # what is called here runs as soon as the library is loaded
        head, bracket = head.partition("=")[0], ""
    words = _WORD.findall(head)
    if bracket and not has_body and _is_made_from_values(words, inside):
        bracket = ""
    if bracket and len(words) == 1 and "::" not in head:
        return None  # a macro: what it makes is not known
    if not words:
        return ()
    owner = _OWNER.search(head[-300:])
    if owner is not None and words[0] not in ("using", "typedef", "friend", "extern"):
        return (owner[1],) if has_body or not bracket else ()
    if len(words) == 1 or not _NOTHING.isdisjoint(words[:-1] if words[0] != "template" else words[1:-1]) or (bracket and not has_body):
        return ()
    return (words[-1],)


def _is_made_from_values(words: Sequence[str], inside: str) -> bool:
    """Whether a declaration with brackets is of a variable. Texts are blanked out: a function without parameters counts, too."""
    return len(words) > 1 and words[0] not in ("void", "explicit", "virtual") and not _PARAMETERS.search(_NEW.sub("", inside))


class Library:
    """The sources of a library, with what each of them defines.

    Args:
        sources: of the library, and of those of its package that are linked to it.
        text: of a file.
        included: the headers of a file that are here.
    """

    def __init__(self, sources: Sequence[str], text: Callable[[str], str], included: Callable[[str], Iterable[str]]) -> None:
        self._sources = tuple(dict.fromkeys(sources))
        self._text = text
        self._included = included
        self._by_name: dict[str, list[str]] = {}
        self._exporting: dict[str, list[str]] = {}
        self._always: list[str] = []
        for path in self._sources:
            content = text(path)
            for word in exported_words(content):
                self._exporting.setdefault(word, []).append(path)
            names = defined_names(content)
            if names is None:
                self._always.append(path)
            for name in names or ():
                self._by_name.setdefault(name, []).append(path)
        self._next: dict[str, tuple[str, ...]] = {}

    def of_class(self, name: str) -> tuple[str, ...]:
        """The sources that a class needs, by its full name; all of them where no source is known to be its own."""
        last = name.rpartition("::")[2].strip()
        own = self._by_name.get(last) or self._exporting.get(last)
        if not own:
            return self._sources
        seen = {*own, *self._always}
        pending = list(seen)
        while pending:
            new = [each for each in self._after(pending.pop()) if each not in seen]
            seen.update(new)
            pending += new
        return tuple(path for path in self._sources if path in seen)

    def defining(self, path: str) -> tuple[str, ...]:
        """The sources that define a name which a file mentions, and those of which that cannot be told."""
        words = words_of(self._text(path)) & self._by_name.keys()
        return tuple(dict.fromkeys((*self._always, *(each for word in sorted(words) for each in self._by_name[word]))))

    def _after(self, path: str) -> tuple[str, ...]:
        """The headers of a file, and the sources that define what it names."""
        if path not in self._next:
            self._next[path] = tuple(dict.fromkeys((*self._included(path), *self.defining(path))))
        return self._next[path]
