"""MD5 sums of message types, from their installed definitions.

The sum of a type is the MD5 of a text made of its definition (ROS wiki, "ROS/Technical Overview", "Message serialization and msg MD5
sums"):
comments and blanks are taken away, constants come first, and a field of another message type is written with the sum of that type in the
place of its name.
"""

import ast
import hashlib
import os
import re
from typing import Any, Dict, List, Optional, Tuple

BUILTIN = {
    "bool",
    "int8",
    "uint8",
    "int16",
    "uint16",
    "int32",
    "uint32",
    "int64",
    "uint64",
    "float32",
    "float64",
    "string",
    "time",
    "duration",
    "char",
    "byte",
}
LARGEST_DEFINITION = 256 * 1024
DEEPEST = 30

_TYPE = re.compile(r"[A-Za-z]\w*/[A-Za-z]\w*")


class Definitions:
    """The definitions that are installed.

    Args:
        directories: package → the directories that hold its ``msg`` folders.
        modules: directories of Python packages: where no definition is installed, the module made of it quotes it.
    """

    def __init__(self, directories: Dict[str, List[str]], modules: List[str]) -> None:
        self._directories = directories
        self._modules = modules
        self._sums: Dict[str, Optional[str]] = {}

    def text(self, kind: str) -> Optional[str]:
        """The definition of ``package/Type`` without comments and blank lines; None where there is none."""
        if not _TYPE.fullmatch(kind):
            return None
        package, _, name = kind.partition("/")
        for directory in self._directories.get(package, ()):
            text = _read(os.path.join(directory, "msg", name + ".msg"))
            if text is not None:
                return _plain(text)
        for directory in self._modules:
            text = _read(os.path.join(directory, package, "msg", "_{}.py".format(name)))
            if text is not None:
                quoted = _quoted(text)
                return None if quoted is None else _plain(quoted)
        return None

    def md5(self, kind: str, depth: int = 0) -> Optional[str]:
        """The sum of ``package/Type``; None where it, or a type in it, is not installed."""
        if not _TYPE.fullmatch(kind) or depth > DEEPEST:
            return None
        if kind not in self._sums:
            self._sums[kind] = None  # a type that holds itself has no sum
            text = self.text(kind)
            if text is not None:
                self._sums[kind] = self._sum(text, kind.partition("/")[0], depth)
        return self._sums[kind]

    def _sum(self, text: str, package: str, depth: int) -> Optional[str]:
        constants: List[str] = []
        fields: List[str] = []
        for line, constant in _lines(text):
            if constant:
                kind, name, value = _constant(line)
                constants.append("{} {}={}".format(kind, name, value))
                continue
            words = line.split()
            if len(words) != 2:
                return None
            kind, name = words
            plain = kind.partition("[")[0]
            if plain in BUILTIN:
                fields.append("{} {}".format(kind, name))
                continue
            full = plain if "/" in plain else "std_msgs/Header" if plain == "Header" else "{}/{}".format(package, plain)
            inner = self.md5(full, depth + 1)
            if inner is None:
                return None
            fields.append("{} {}".format(inner, name))
        return hashlib.md5("\n".join(constants + fields).encode("utf-8")).hexdigest()


def _read(path: str) -> Optional[str]:
    try:
        if os.path.getsize(path) > LARGEST_DEFINITION:
            return None
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read()
    except OSError:
        return None


def _plain(text: str) -> str:
    return "\n".join(line if line.startswith("string ") and constant else " ".join(line.split()) for line, constant in _lines(text))


def _quoted(module: str) -> Optional[str]:
    """The definition that a generated Python module quotes (``_full_text``): read, not imported. The types in it follow behind a line
    of ``=``.
    """
    try:
        tree = ast.parse(module)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and any(isinstance(target, ast.Name) and target.id == "_full_text" for target in node.targets):
            try:
                value = ast.literal_eval(node.value)
            except (ValueError, TypeError, RecursionError, MemoryError):
                return None
            return re.split(r"^={20,}$", value, maxsplit=1, flags=re.MULTILINE)[0] if isinstance(value, str) else None
    return None


def _lines(text: str) -> List[Tuple[str, bool]]:
    """The lines that say something, without comments, and whether each is a constant. A string constant keeps its ``#``."""
    found = []
    for line in text.split("\n"):
        said = line.partition("#")[0].strip()
        if not said:
            continue
        constant = "=" in said
        if constant and said.split(None, 1)[0] == "string":
            said = line.strip("\r").lstrip()
        found.append((said, constant))
    return found


def _constant(line: str) -> Tuple[str, str, str]:
    kind, _, rest = line.partition(" ") if " " in line else line.partition("\t")
    name, _, value = rest.partition("=")
    return kind, name.strip(), value.lstrip() if kind == "string" else value.strip()


def used(records: List[Dict[str, Any]], definitions: Definitions) -> Dict[str, Dict[str, str]]:
    """The messages that the topics of some records carry: type → its sum and its definition, as far as they are installed."""
    kinds = {
        entry.get("type", "")
        for record in records
        for category in ("publishers", "subscribers")
        for entry in record.get("interface", {}).get(category, ())
    }
    found = {}
    for kind in sorted(kinds):
        md5 = definitions.md5(kind)
        if md5 is not None:
            found[kind] = {"md5": md5, "text": definitions.text(kind) or ""}
    return found
