"""YAML as ``<rosparam>`` loads it: values, every leaf with its place, and what a reader of the file should be told.

Sources: roslaunch.loader.load_rosparam and add_param, and the constructors that rosparam registers with PyYAML's SafeLoader.
"""

from __future__ import annotations

from typing import Any

from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.ros1.values import shown
from launchlint.evaluate.ros1.yaml_values import Constructor, Duplicate, YamlUnknown, with_angles
from launchlint.named_tuple import NamedTuple
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import Node, Reader, YamlBeyond, parse

__all__ = ("Duplicate", "Entry", "Loaded", "UnknownValue", "YamlError", "YamlUnknown", "load")

MOST_LEAVES = 200_000
ROSPARAM = Reader("rosparam")
"""rosparam.load_str: PyYAML's SafeLoader."""


class Entry(NamedTuple):
    """One parameter that a dictionary unrolls to: its keys from the outside in, its value, and where both are written.

    Offsets are code points in the text. For a document that is no dictionary, the path is empty and the key's place is the value's.
    """

    path: tuple[str, ...]
    value: Any
    key_start: int
    key_end: int
    value_start: int
    value_end: int


class Loaded(NamedTuple):
    """A loaded document.

    ``data`` is its Python value (None where it is empty, which roslaunch takes as an empty dictionary; binary data is ``bytes``);
    ``entries`` the parameters it sets, in the order in which roslaunch sets them; ``duplicates`` the keys that stand twice in one
    mapping, where the last one wins; ``scalar_colon`` the places of plain texts that look like ``key:value`` without the blank.
    A value that cannot be known without running code (``rad(os.getpid())``) is an :class:`UnknownValue` object in its place.
    """

    data: Any
    entries: tuple[Entry, ...]
    duplicates: tuple[Duplicate, ...]
    scalar_colon: tuple[tuple[int, int], ...]


def load(text: str, unroll: bool = True, angles: bool = True) -> Loaded:
    """Load a YAML text of one document.

    ``unroll`` is for ``<rosparam>``: dictionaries become parameters, and a key that is not a text is an error (rosgraph.names.ns_join
    fails on it). Without it (``<param type="yaml">``), keys are free and there are no entries. ``angles`` says whether ``deg(…)`` and
    ``rad(…)`` are numbers: roslaunch knows them as soon as it has loaded one ``<rosparam>``.

    Raises :class:`YamlError` for what roslaunch refuses, :class:`YamlUnknown` for what is beyond our bounds.
    """
    try:
        tree = parse(text, ROSPARAM._replace(scalars=with_angles) if angles else ROSPARAM)
    except YamlBeyond as beyond:
        raise YamlUnknown(beyond.message) from None
    if tree.root is None:
        return Loaded(None, (), (), ())
    constructor = Constructor()
    try:
        data = constructor.value(tree.root)
    except RecursionError:
        raise YamlUnknown("the YAML text is nested too deeply") from None
    entries: list[Entry] = []
    if unroll and data is not None:
        root = tree.root
        if root.final is None:
            entries.append(Entry((), data, root.start, root.end, root.start, root.end))
        else:
            _unroll(root, (), entries, [0], 0)
    return Loaded(data, tuple(entries), tuple(constructor.duplicates), tuple(tree.scalar_colon))


def _unroll(node: Node, path: tuple[str, ...], entries: list[Entry], visited: list[int], depth: int) -> None:
    """Append the parameters of the mapping ``node`` (roslaunch.loader.Loader.add_param)."""
    assert node.final is not None
    if depth > ROSPARAM.deepest:
        raise YamlUnknown(f"the YAML text is nested more than {ROSPARAM.deepest} deep")
    visited[0] += len(node.final) + 1
    if visited[0] > MOST_LEAVES:
        raise YamlUnknown(f"the YAML text sets more than {MOST_LEAVES} parameters")
    for key, (key_node, value_node) in node.final.items():
        if not isinstance(key, str):
            raise YamlError(_key_words(key, key_node), key_node.start, "key")
        if value_node.final is None:
            entries.append(Entry((*path, key), value_node.data, key_node.start, key_node.end, value_node.start, value_node.end))
        else:
            _unroll(value_node, (*path, key), entries, visited, depth + 1)


def _key_words(key: object, node: Node) -> str:
    written = shown(node.value) if isinstance(node.value, str) and node.value else "null"
    kind = {bool: "true or false", int: "a number", float: "a number", type(None): "null"}.get(type(key), f"of type {type(key).__name__}")
    return f"YAML reads the key {written} as {kind}, and roslaunch stops at keys that are not text; put it in quotes"
