"""YAML nodes to Python values, as PyYAML's SafeConstructor with rosparam's additions makes them."""

from __future__ import annotations

import re
from typing import Any

from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.ros1.values import shown
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import MAP, MAPPING, SCALAR, SEQ, SEQUENCE, STR, Node, Scalars, yaml_1_1

MOST_PAIRS = 200_000
_LONGEST_NUMBER = 4_300

_INT, _FLOAT = "tag:yaml.org,2002:int", "tag:yaml.org,2002:float"
_BOOL, _NULL = "tag:yaml.org,2002:bool", "tag:yaml.org,2002:null"
_MERGE, _VALUE = "tag:yaml.org,2002:merge", "tag:yaml.org,2002:value"
DEGREES, RADIANS = "!degrees", "!radians"
_ANGLES = ((DEGREES, re.compile(r"^deg\([^\)]*\)$")), (RADIANS, re.compile(r"^rad\([^\)]*\)$")))
_BOOLEANS = {"yes": True, "no": False, "true": True, "false": False, "on": True, "off": False}


class YamlUnknown(UnknownValue):
    """The text is beyond our bounds: nothing can be said about it, and it is no error."""


def with_angles() -> Scalars:
    """The rules for plain scalars once rosparam has added ``deg(…)`` and ``rad(…)`` to YAML 1.1."""
    plain = yaml_1_1()

    def tag_of(text: str) -> str:
        tag = plain(text)
        if tag is STR and text[:1] in ("d", "r", "e", "g", "(", "a"):
            return next((tag for tag, pattern in _ANGLES if pattern.match(text)), STR)
        return tag

    return tag_of


class Duplicate:
    """A key that stands twice in one mapping: where the mapping is, the two keys, and whether both have the same value."""

    __slots__ = ("first", "path", "same_value", "second")

    def __init__(self, path: tuple[Any, ...], first: tuple[int, int], second: tuple[int, int], same_value: bool) -> None:
        self.path = path
        self.first = first
        self.second = second
        self.same_value = same_value

    def __repr__(self) -> str:
        return f"Duplicate({self.path!r}, {self.first!r}, {self.second!r}, same_value={self.same_value!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Duplicate) and repr(self) == repr(other)

    __hash__ = None  # type: ignore[assignment]  # the path may hold lists


class Constructor:
    """Makes the values of one tree; ``duplicates`` fills on the way."""

    __slots__ = ("compared", "duplicates", "pairs")

    def __init__(self) -> None:
        self.duplicates: list[Duplicate] = []
        self.pairs = 0
        self.compared = 0

    def value(self, node: Node, path: tuple[Any, ...] = ()) -> Any:
        """The Python value of ``node``, made once. Raises YamlError and YamlUnknown."""
        if node.made:
            return node.data
        if node.kind == SCALAR:
            data = _scalar(node)
        elif node.kind == SEQUENCE and node.tag == SEQ:
            data = [child.data if child.made else self.value(child, (*path, at)) for at, child in enumerate(node.value)]
        elif node.kind == MAPPING and node.tag == MAP:
            data = self._mapping(node, path)
        else:
            data = _by_yaml(node)
        node.data = data
        node.made = True
        return data

    def _mapping(self, node: Node, path: tuple[Any, ...]) -> dict[Any, Any]:
        own = {id(key) for key, _ in node.value}
        self._flatten(node)
        data: dict[Any, Any] = {}
        final: dict[Any, tuple[Node, Node]] = {}
        for key_node, value_node in node.value:
            key = key_node.data if key_node.made else self.value(key_node, path)
            try:
                before = final.get(key)
            except TypeError:
                raise YamlError("a list or mapping cannot be used as a key", key_node.start, "key") from None
            value = value_node.data if value_node.made else self.value(value_node, (*path, key))
            if before is not None and id(before[0]) in own and id(key_node) in own:
                first, second = before[0], key_node
                same = self._same(before[1], value_node)
                self.duplicates.append(Duplicate((*path, key), (first.start, first.end), (second.start, second.end), same))
            data[key] = value
            final[key] = (key_node, value_node)
        node.final = final
        return data

    def _same(self, first: Node, second: Node) -> bool:
        """Whether two nodes have the same value (1, true and 1.0 are three); beyond a bound on the work, they have not."""
        if first is second:
            return True
        if first.size != second.size:
            return False
        self.compared += first.size
        return self.compared <= MOST_PAIRS and repr(first.data) == repr(second.data)

    def _flatten(self, node: Node) -> None:
        """Put the pairs of merge keys before the node's own (yaml.constructor.SafeConstructor.flatten_mapping)."""
        if node.flat:
            return
        node.flat = True
        merged: list[tuple[Node, Node]] = []
        own: list[tuple[Node, Node]] = []
        for key, value in node.value:
            if key.tag == _MERGE:
                for source in self._sources(value):
                    self._flatten(source)
                    self.pairs += len(source.value)
                    if self.pairs > MOST_PAIRS:
                        raise YamlUnknown(f"the YAML text merges more than {MOST_PAIRS} entries")
                    merged.extend(source.value)
            else:
                if key.tag == _VALUE:
                    key.tag = STR
                own.append((key, value))
        node.value = merged + own

    def _sources(self, value: Node) -> list[Node]:
        """The mappings behind ``<<``, the one that wins last."""
        if value.kind == MAPPING:
            return [value]
        if value.kind == SEQUENCE:
            for source in value.value:
                if source.kind != MAPPING:
                    raise YamlError("<< takes mappings, and this is none", source.start, "merge")
            return list(reversed(value.value))
        raise YamlError("<< takes a mapping or a list of mappings, and this is none", value.start, "merge")


def _scalar(node: Node) -> Any:
    """The value of a scalar; an UnknownValue stands for one that cannot be known, so that the rest of the document still can."""
    tag, text = node.tag, node.value
    if tag == STR:
        return text
    if tag == _INT:
        if text.isdecimal() and text.isascii() and (text[0] != "0" or text == "0") and len(text) < _LONGEST_NUMBER:
            return int(text)
    elif tag == _FLOAT:
        if "_" not in text and ":" not in text and len(text) < _LONGEST_NUMBER:
            try:
                return float(text)
            except ValueError:
                pass  # .inf and .nan
    elif tag == _BOOL:
        if text.lower() in _BOOLEANS:
            return _BOOLEANS[text.lower()]
    elif tag == _NULL:
        return None
    elif tag in (DEGREES, RADIANS):
        from launchlint.evaluate.ros1.angles import degrees, radians

        try:
            return (degrees if tag == DEGREES else radians)(text)
        except ValueError as error:
            raise YamlError(str(error), node.start, "value") from None
        except UnknownValue as unknown:
            return unknown
    if tag in (_INT, _FLOAT) and len(text) >= _LONGEST_NUMBER:
        return UnknownValue(f"a number of more than {_LONGEST_NUMBER} digits is not looked into")
    return _by_yaml(node)


def _by_yaml(node: Node) -> Any:
    """The rarer tags are PyYAML's own business: numbers in other bases, dates, binary data, sets, ordered maps, and unknown ones."""
    import yaml

    from launchlint.yaml.values import as_pyyaml  # rare: no file of ROS 1 with plain values loads it

    constructor = yaml.constructor.SafeConstructor()
    try:
        return constructor.construct_document(as_pyyaml(yaml, node))
    except yaml.constructor.ConstructorError as error:
        problem = error.problem or ""
        place = error.problem_mark.index if error.problem_mark is not None else node.start
        if "could not determine a constructor" in problem:
            raise YamlError(f"the YAML tag {shown(node.tag)} is not one that rosparam knows", place, "tag") from None
        raise YamlError(f"this does not fit its YAML tag (YAML says: {problem[:200]})", place, "value") from None
    except (RecursionError, MemoryError):
        raise YamlUnknown("this YAML value is nested too deeply") from None
    except Exception as error:  # whatever PyYAML meets here, roslaunch meets too
        what = shown(node.value) if isinstance(node.value, str) else "this"
        said = f"Python says: {type(error).__name__}: {str(error)[:200]}"
        raise YamlError(f"{what} cannot be read as {node.tag.rsplit(':', 1)[-1][:60]} ({said})", node.start, "value") from None
