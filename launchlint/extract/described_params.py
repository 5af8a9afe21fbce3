"""YAML files that generate_parameter_library makes classes of: the params that they describe."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.errors import ConfigurationError
from launchlint.extract.fact import Descriptor
from launchlint.named_tuple import NamedTuple
from launchlint.workspace import looking
from launchlint.workspace.yaml_nodes import MAPPING, SCALAR, SEQUENCE, Node, parse_document

MOST_PARAMS = 2_000
_DEEPEST = 20
_LARGEST = 1 << 20
_MAP = "__map_"
_TYPES = {
    "bool": "bool", "int": "integer", "double": "double", "string": "string", "bool_array": "bool_array", "int_array": "integer_array",
    "double_array": "double_array", "string_array": "string_array",
}  # fmt: skip
_LEAST = ("bounds<>", "lower_bounds<>", "gt_eq<>")
_GREATEST = ("bounds<>", "upper_bounds<>", "lt_eq<>")


class Described(NamedTuple):
    """One param of a YAML file: its name with dots, ``{any}`` for the parts that another param gives."""

    name: str
    type: str
    default: bool | int | float | str | list[bool | int | float | str] | None
    descriptor: Descriptor
    line: int


class Description(NamedTuple):
    """A YAML file: the namespace of the classes that are made of it, and the params; ``whole`` says that all of them are understood."""

    space: str
    params: tuple[Described, ...]
    whole: bool


def read(path: str) -> Description | None:
    """What a YAML file describes; None where it cannot be read."""
    try:
        root = parse_document(looking.read_bytes(path, _LARGEST), path).root
    except (OSError, ConfigurationError):
        return None
    if root is None or root.kind != MAPPING or len(root.pairs) != 1:
        return None
    key, value = root.pairs[0]
    found = list(_params(value, "", 0))
    return Description(key.text, tuple(found[:MOST_PARAMS]), len(found) <= MOST_PARAMS)


def _params(node: Node, start: str, depth: int) -> Iterator[Described]:
    if node.kind != MAPPING or depth > _DEEPEST:
        return
    said = {key.text: value for key, value in node.pairs if key.kind == SCALAR}
    if start and "type" in said and said["type"].kind == SCALAR:
        yield _described(start, said, node.line)
        return
    for key, value in node.pairs:
        part = "{any}" if key.text.startswith(_MAP) else key.text
        if key.kind == SCALAR and part and (part == "{any}" or not set(part) & set("{}~/ ")):
            yield from _params(value, f"{start}.{part}" if start else part, depth + 1)


def _described(name: str, said: dict[str, Node], line: int) -> Described:
    kind = said["type"].text
    base, _, size = kind.rpartition("_fixed_")
    type_ = _TYPES.get(base if size.isdigit() else kind, "")
    checks = said.get("validation")
    given = {key.text: value for key, value in checks.pairs} if checks is not None and checks.kind == MAPPING else {}
    one_of = _first(given.get("one_of<>"))
    described = Descriptor(
        said["description"].text if "description" in said and said["description"].kind == SCALAR else "",
        "read_only" in said and said["read_only"].text == "true",
        False,
        _limit(given, _LEAST, 0),
        _limit(given, _GREATEST, -1),
        None,
        tuple(each for each in (_value(item) for item in one_of.items) if each is not None) if one_of is not None else (),
    )
    default = said.get("default_value")
    return Described(name, type_, _default(default, type_), described, line)


def _first(node: Node | None) -> Node | None:
    """The list that a check is given as its first argument."""
    found = node.items[0] if node is not None and node.kind == SEQUENCE and node.items else None
    return found if found is not None and found.kind == SEQUENCE else None


def _limit(given: dict[str, Node], names: Sequence[str], position: int) -> float | None:
    for name in names:
        node = given.get(name)
        value = _value(node.items[position]) if node is not None and node.kind == SEQUENCE and node.items else None
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            return value
    return None


def _default(node: Node | None, kind: str) -> bool | int | float | str | list[bool | int | float | str] | None:
    if node is None:
        return None
    if node.kind == SEQUENCE:
        items = [_value(each, kind.removesuffix("_array")) for each in node.items]
        known = [each for each in items if each is not None]
        return known if len(known) == len(items) else None
    return _value(node, kind)


def _value(node: Node, kind: str = "") -> bool | int | float | str | None:
    if node.kind != SCALAR:
        return None
    try:
        if kind == "string":
            return node.text
        if node.type == "bool":
            return node.text.lower() in ("true", "yes", "on")
        if node.type == "int":
            number = int(node.text.replace("_", ""), 0)
            return (float(number) if kind == "double" else number) if abs(number) < 10**18 else None
        if node.type == "float":
            return float(node.text) if abs(float(node.text)) < 1e300 else None
    except (ValueError, OverflowError):
        return None
    return node.text if node.type == "str" else None
