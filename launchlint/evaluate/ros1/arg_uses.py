"""What a launch file does with its args: which must be booleans, which are text, and where their values go on to.

Read from what is written, whatever the conditions around it say: an arg that is part of a path in one branch is no boolean in the others.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.parts import Parts
from launchlint.syntax.ros1.substitutions import is_computed, opens, parse, parts_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.tree import Document, Element

BOOLEANS = ("true", "false", "1", "0")
"""What ``if`` and ``unless`` take (roslaunch.loader.convert_value of type bool)."""

_PLACE = late(r"[^\s=]+")
"""A word of a command line, without ``name=`` or ``name:=`` before it; what is substituted has no blanks in it."""
_NAME = late(r"\w+")
_CONDITIONS = ("if", "unless")
_FLAGS = frozenset({"required", "respawn", "clear_params", "pass_all_args", "subst_value"})
_WORDS = frozenset({"args", "command", "launch-prefix"})
_FILES = frozenset({"file", "textfile", "binfile"})
_BEFORE, _AFTER = frozenset(" \t\n=:,[{('\""), frozenset(" \t\n,]})'\"")


class ArgUses(NamedTuple):
    """What one file does with its args, each by the name it has there.

    ``booleans`` are what a condition or flag consists of. ``parts`` are computed with, or are a name or part of a name or longer text;
    ``paths`` are part of a path; ``texts`` are compared with other words, or have such a default. ``truths`` are asked in an ``$(eval …)``
    whether they are true. ``literals`` are what an arg is compared with, ``exact`` those of them that it may be equal to as a whole.
    ``handed_on`` says which args of the file take the value of an arg as it is; ``passed`` says the same of the args of included files, by
    the offset of the ``<include>``.
    """

    booleans: frozenset[str]
    parts: frozenset[str]
    paths: frozenset[str]
    texts: frozenset[str]
    truths: frozenset[str]
    literals: Mapping[str, tuple[str, ...]]
    exact: Mapping[str, tuple[str, ...]]
    handed_on: Mapping[str, tuple[str, ...]]
    passed: Mapping[int, tuple[tuple[str, str], ...]]


def is_boolean(text: str) -> bool:
    """Whether ``if`` takes ``text``."""
    return text.strip().lower() in BOOLEANS


def arg_uses(document: Document) -> ArgUses:
    """Read ``document``; takes time in proportion to its length."""
    reading = _Reading()
    for element in document.elements:
        reading.read(element)
    return ArgUses(
        frozenset(reading.booleans),
        frozenset(reading.parts),
        frozenset(reading.paths),
        frozenset(reading.texts),
        frozenset(reading.truths),
        {name: tuple(values) for name, values in reading.literals.items()},
        {name: tuple(values) for name, values in reading.exact.items()},
        {name: tuple(names) for name, names in reading.handed_on.items()},
        {start: tuple(pairs) for start, pairs in reading.passed.items()},
    )


class _Reading:
    """What has been read so far."""

    def __init__(self) -> None:
        self.booleans: set[str] = set()
        self.parts: set[str] = set()
        self.paths: set[str] = set()
        self.texts: set[str] = set()
        self.truths: set[str] = set()
        self.literals: dict[str, dict[str, None]] = {}
        self.exact: dict[str, dict[str, None]] = {}
        self.handed_on: dict[str, dict[str, None]] = {}
        self.passed: dict[int, list[tuple[str, str]]] = {}

    def read(self, element: Element) -> None:
        """Take in one element."""
        for name, attribute in element.attributes.items():
            if is_computed(attribute):
                self._value(element, name, parts_of(attribute))
        if element.tag == "arg":
            self._declaration(element)
        elif element.tag == "rosparam" and opens(element.text):
            self.parts.update(_parts(parse(element.text)))

    def _value(self, element: Element, name: str, parts: Parts) -> None:
        if parts.expression is not None:
            self._expression(element, name, parts.expression.code)
            return
        whole = _whole(parts)
        if name in _CONDITIONS or name in _FLAGS:
            if whole:
                self.booleans.add(whole)
        elif element.tag.lower() == "arg" and name in ("value", "default"):
            if whole:
                self._goes_on(element, whole)
            else:
                self.parts.update(parts.names("arg"))
        elif name == "value" and whole:
            kind = (element.get("type") or "").strip().lower()
            if kind in ("bool", "boolean"):
                self.booleans.add(whole)
            elif kind in ("int", "double"):
                self.texts.add(whole)
        elif name == "value" or name in _WORDS:
            for start, end in _places(parts):
                (self.paths if "/" in parts.text[start:end] else self.parts).update(_parts(parts, start, end))
        elif name in _FILES:
            self.paths.update(parts.names("arg"))
        elif name != "doc":
            self.parts.update(parts.names("arg"))

    def _expression(self, element: Element, attribute: str, expression: str) -> None:
        from launchlint.evaluate.ros1.expression import compared_literals, made_into_text, truth_tested, whole_arg

        alone = whole_arg(expression)
        if alone is None:
            for name, values in compared_literals(expression).items():
                self.literals.setdefault(name, {}).update(dict.fromkeys(value for value in values if value.strip()))
                if not all(map(is_boolean, values)):
                    self.texts.add(name)
            for name, values in compared_literals(expression, exact=True).items():
                self.exact.setdefault(name, {}).update(dict.fromkeys(value for value in values if value.strip()))
            self.parts |= made_into_text(expression)
            self.truths |= truth_tested(expression)
        elif attribute in _CONDITIONS or attribute in _FLAGS:
            self.booleans.add(alone)
        elif element.tag.lower() == "arg" and attribute in ("value", "default"):
            self._goes_on(element, alone)
        elif attribute in _FILES:
            self.paths.add(alone)
        elif attribute not in ("value", "doc"):
            self.parts.add(alone)

    def _goes_on(self, element: Element, name: str) -> None:
        """The value of the arg ``name`` becomes that of the arg that ``element`` declares or passes."""
        target, parent = element.get("name"), element.parent
        if not target or parent is None:
            return
        if parent.tag == "include":
            self.passed.setdefault(parent.start_span.start, []).append((name, target))
        elif target != name:
            self.handed_on.setdefault(name, {})[target] = None

    def _declaration(self, element: Element) -> None:
        name = element.get("name")
        if not name or element.parent is None or element.parent.tag == "include":
            return
        for written in (element.attributes.get("value"), element.attributes.get("default")):
            if written is not None and not is_computed(written) and not is_boolean(written.value):
                self.texts.add(name)


def _whole(parts: Parts) -> str:
    """The arg that a value consists of, but for blanks around it; empty where it is none."""
    found = list(parts.substitutions())
    return found[0].only if len(found) == 1 and found[0].command == "arg" and not parts.beside().strip() else ""


def _places(parts: Parts) -> Iterator[tuple[int, int]]:
    """Where the words of a command line begin and end."""
    return (match.span() for match in _PLACE.finditer(parts.filled()))


def _parts(parts: Parts, start: int = 0, end: int | None = None) -> Iterator[str]:
    """The args between ``start`` and ``end`` that are only part of a word."""
    text = parts.text
    end = len(text) if end is None else end
    for part in parts.substitutions("arg"):
        if start <= part.start < end and part.only:
            joined = part.start > start and text[part.start - 1] not in _BEFORE
            if joined or (part.end < end and text[part.end] not in _AFTER):
                yield part.only


def settled_defaults(document: Document) -> dict[str, str]:
    """The args of an entry file to which giving the value of their default makes no difference, each with the default as written.

    They are declared once, whatever the args, and nothing above the declaration may ask for them: there they have a value only where
    they are given.
    """
    declarations = [each for each in document.elements if each.tag == "arg" and each.parent is not None and each.parent.tag != "include"]
    times = Counter(element.get("name") or "" for element in declarations)
    settled: dict[str, str] = {}
    asked: set[str] = set()
    for element in document.elements:
        attributes = element.attributes
        if "pass_all_args" in attributes or "subst_value" in attributes:
            break  # from here on any arg may have been asked for
        if element.tag == "arg" and element.parent is document.launch and attributes.keys().isdisjoint(("if", "unless", "value")):
            name, default = element.get("name") or "", element.get("default")
            if default is not None and times[name] == 1 and name not in asked and _NAME.fullmatch(name) is not None:
                settled[name] = default
        for attribute in attributes.values():
            if "$" in attribute.value:
                asked.update(_NAME.findall(attribute.value))
    return {} if any("$" in name for name in times) else settled


def args_needed(element: Element) -> list[str]:
    """Names of the args that the value of an ``<arg>`` reads."""
    text = element.get("value") or element.get("default") or ""
    parts = parse(text)
    if parts.expression is not None:
        from launchlint.evaluate.ros1.expression import arguments_read

        return sorted(arguments_read(parts.expression.code))
    return [] if parts.refused is not None else list(parts.names("arg"))
