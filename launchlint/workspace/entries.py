"""Entries: launch files with the arguments they are started with.

They stand in the configuration (key ``entries``) and in the file that ``--entries`` names, as a list of
``{file: PATH, as: PATH, args: {NAME: VALUE}}``.
"""

from __future__ import annotations

from launchlint.errors import ConfigurationError
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.reading import read_bytes
from launchlint.workspace.yaml_nodes import SCALAR, Document, Node, parse_document, shown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

LARGEST_ENTRIES = 64 << 20
_KEYS = frozenset(("file", "as", "args"))


class Entry(NamedTuple):
    """One launch file as it is started: the text of ``file``, judged as if it stood at ``as_`` (``None``: at ``file`` itself)."""

    file: str
    as_: str | None
    arguments: dict[str, str]


def load_entries(path: str) -> list[Entry]:
    """Entries of a YAML or JSON file, in order; paths as they are written there.

    Values of arguments become texts as the user wrote them: ``true`` is ``"true"``, ``1.0`` is ``"1.0"``.

    Raises:
        ConfigurationError: the file cannot be read, or is not a list of entries.
    """
    try:
        data = read_bytes(path, LARGEST_ENTRIES)
    except OSError as error:
        raise ConfigurationError(f"{path}: it cannot be read: {error.strerror or error}") from error
    if data.lstrip()[:1] == b"[":
        # JSON is YAML, and read a hundred times faster. Where anything is wrong with it, the YAML reader says what and where.
        entries = _from_json(data)
        if entries is not None:
            return entries
    document = parse_document(data, path)
    return [] if document.root is None else entries_of(document, document.root)


def entries_of(document: Document, node: Node) -> list[Entry]:
    """The entries that ``node`` lists; a plain text stands for a file without arguments."""
    if node.kind != "sequence":
        document.fail(node, f"entries must be a list of {{file: PATH, args: {{NAME: VALUE}}}}, not {node.describe()}")
    return [_entry(document, each) for each in node.items]


def _entry(document: Document, node: Node) -> Entry:
    if node.kind == SCALAR:
        return Entry(document.text(node, "an entry"), None, {})
    file: str | None = None
    judged_as: str | None = None
    arguments: dict[str, str] = {}
    for key, key_node, value in document.pairs(node, "an entry"):
        if key == "file":
            file = document.text(value, "file")
        elif key == "as":
            judged_as = document.text(value, "as")
        elif key == "args":
            arguments = arguments_of(document, value)
        else:
            document.unknown(key_node, _KEYS, "an entry")
    if not file:
        document.fail(node, "this entry names no launch file; write file: PATH")
    return Entry(file, judged_as, arguments)


def arguments_of(document: Document, node: Node) -> dict[str, str]:
    """``{NAME: VALUE}`` with the values as texts; nothing at all stands for no arguments."""
    if node.kind == SCALAR and node.type == "null":
        return {}
    return {name: document.text(value, f"the arg {shown(name)}") for name, _, value in document.pairs(node, "args")}


def _from_json(data: bytes) -> list[Entry] | None:
    import json

    try:
        listed = json.loads(data, parse_int=str, parse_float=str, object_pairs_hook=_without_duplicates)
    except (ValueError, RecursionError):
        return None
    entries: list[Entry] = []
    for each in listed if isinstance(listed, list) else ():
        if isinstance(each, str):
            each = {"file": each}
        if not isinstance(each, dict) or not each.keys() <= _KEYS:
            return None
        file, judged_as, arguments = each.get("file"), each.get("as"), each.get("args")
        if not isinstance(file, str) or not file or not isinstance(judged_as, str | None) or not isinstance(arguments, dict | None):
            return None
        texts: dict[str, str] = {}
        for name, value in (arguments or {}).items():
            text = {True: "true", False: "false"}.get(value) if isinstance(value, bool) else value
            if not isinstance(text, str):
                return None
            texts[name] = text
        entries.append(Entry(file, judged_as, texts))
    return entries


def _without_duplicates(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) != len(pairs):
        raise ValueError("a key is given twice")
    return found
