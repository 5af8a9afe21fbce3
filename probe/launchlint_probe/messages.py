"""MD5 sums and empty values of messages and services, from their installed definitions.

The sum of a type is the MD5 of a text made of its definition (ROS wiki, "ROS/Technical Overview", "Message serialization and msg MD5
sums"):
comments and blanks are taken away, constants come first, and a field of another message type is written with the sum of that type in the
place of its name.
"""

import ast
import hashlib
import os
import re
import struct
import threading
from typing import Any, Dict, List, Optional, Set, Tuple

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
LARGEST_VALUE = 1024 * 1024
"""Bytes of an empty message: one with larger fixed arrays is not made."""
MOST_SERVICES = 20000
DEEPEST = 30
SIZES = {"bool": 1, "byte": 1, "char": 1, "string": 4, "time": 8, "duration": 8}
"""Bytes of an empty value; those of numbers follow from their names. A string is its length, which is 0."""

_TYPE = re.compile(r"[A-Za-z]\w*/[A-Za-z]\w*")
SENSIBLE = {
    "geometry_msgs/Quaternion": ("a779879fadf0160734f906b8c19c7004", bytes(24) + struct.pack("<d", 1.0)),
    "sensor_msgs/Image": (
        "060021388200f6f0f447d0fcd9c64743",
        bytes(16) + struct.pack("<III4sBII", 2, 2, 4, b"bgr8", 0, 6, 12) + bytes(12),
    ),
}
"""Types of which empty values make no sense, so that nodes end upon them, with their MD5 sum and one that does: no turn, a black image."""

_NAME = re.compile(r"\w[\w.]*")
_ARRAY = re.compile(r"(.+?)\[(\d*)\]")
_BITS = re.compile(r"(?:u?int|float)(8|16|32|64)")


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
        self._services: Optional[Dict[str, str]] = None
        self._lock = threading.RLock()

    def text(self, kind: str) -> Optional[str]:
        """The definition of ``package/Type`` without comments and blank lines; None where there is none."""
        parts = self._parts(kind, "msg")
        return _plain(parts[0]) if parts else None

    def _parts(self, kind: str, folder: str) -> List[str]:
        """The definition of a message, or those of the request and of the answer of a service; nothing where there is none."""
        if not _TYPE.fullmatch(kind):
            return []
        package, _, name = kind.partition("/")
        for directory in self._directories.get(package, ()):
            text = _read(os.path.join(directory, folder, "{}.{}".format(name, folder)))
            if text is not None:
                return [text] if folder == "msg" else re.split(r"^---[ \t\r]*$", text, maxsplit=1, flags=re.MULTILINE)
        for directory in self._modules:
            text = _read(os.path.join(directory, package, folder, "_{}.py".format(name)))
            if text is not None:
                return _quoted(text)
        return []

    def empty(self, kind: str) -> Optional[bytes]:
        """A message of ``package/Type`` as it goes over the wire, with zeros, empty texts and empty arrays; None where a type in it is not
        installed.
        """
        with self._lock:
            return self._value(kind, "", 0)

    def empty_answer(self, kind: str) -> Optional[bytes]:
        """The answer of a service of the type ``package/Type``, likewise."""
        with self._lock:
            parts = self._parts(kind, "srv")
            return self._values(_plain(parts[1]), kind.partition("/")[0], 0) if len(parts) == 2 else None

    def service_of(self, md5: str) -> Optional[str]:
        """The type of the services whose MD5 sum this is: the first by name; None where none is installed."""
        with self._lock:
            if self._services is None:
                self._services = {}
                for kind in sorted(self._service_types())[:MOST_SERVICES]:
                    found = self.service_md5(kind)
                    if found is not None:
                        self._services.setdefault(found, kind)
            return self._services.get(md5)

    def _service_types(self) -> Set[str]:
        found: Set[str] = set()
        for package, directories in self._directories.items():
            for directory in directories:
                found.update("{}/{}".format(package, name[:-4]) for name in _listed(os.path.join(directory, "srv"), ".srv"))
        for directory in self._modules:
            for package in _listed(directory, ""):
                names = _listed(os.path.join(directory, package, "srv"), ".py")
                found.update("{}/{}".format(package, name[1:-3]) for name in names if name != "__init__.py")
        return found

    def service_md5(self, kind: str) -> Optional[str]:
        """The sum of a service: that of the texts of its request and its answer, one behind the other (genmsg.gentools)."""
        with self._lock:
            texts = [self._summed(_plain(part), kind.partition("/")[0], 0) for part in self._parts(kind, "srv")]
        if len(texts) != 2 or None in texts:
            return None
        return hashlib.md5("".join(text or "" for text in texts).encode("utf-8")).hexdigest()

    def _values(self, text: str, package: str, depth: int) -> Optional[bytes]:
        found: List[bytes] = []
        size = 0
        for line, constant in _lines(text):
            if constant:
                continue
            array = _ARRAY.fullmatch(line.split()[0])
            kind, count = (array.group(1), array.group(2)) if array else (line.split()[0], "1")
            times = int(count or 1) if len(count) < 10 else LARGEST_VALUE
            each = self._value(kind, package, depth) if count else bytes(4)  # of an array that may have any length: that
            if each is None or size + len(each) * times > LARGEST_VALUE:
                return None
            size += len(each) * times
            found.append(each * times)
        return b"".join(found)

    def _value(self, kind: str, package: str, depth: int) -> Optional[bytes]:
        if kind in BUILTIN:
            bits = _BITS.fullmatch(kind)
            return bytes(int(bits.group(1)) // 8 if bits else SIZES[kind])
        full = _full(kind, package) if package else kind
        if full in SENSIBLE and self.md5(full) == SENSIBLE[full][0]:
            return SENSIBLE[full][1]
        text = self.text(full) if depth < DEEPEST else None
        return None if text is None else self._values(text, full.partition("/")[0], depth + 1)

    def md5(self, kind: str) -> Optional[str]:
        """The sum of ``package/Type``; None where it, or a type in it, is not installed. Any thread may ask."""
        with self._lock:
            return self._md5(kind, 0)

    def _md5(self, kind: str, depth: int) -> Optional[str]:
        if not _TYPE.fullmatch(kind) or depth > DEEPEST:
            return None
        if kind not in self._sums:
            self._sums[kind] = None  # a type that holds itself has no sum
            text = self.text(kind)
            if text is not None:
                self._sums[kind] = self._sum(text, kind.partition("/")[0], depth)
        return self._sums[kind]

    def _sum(self, text: str, package: str, depth: int) -> Optional[str]:
        summed = self._summed(text, package, depth)
        return None if summed is None else hashlib.md5(summed.encode("utf-8")).hexdigest()

    def _summed(self, text: str, package: str, depth: int) -> Optional[str]:
        """The text that a sum is made of."""
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
            inner = self._md5(_full(plain, package), depth + 1)
            if inner is None:
                return None
            fields.append("{} {}".format(inner, name))
        return "\n".join(constants + fields)


def _full(kind: str, package: str) -> str:
    """The type of a field with its package."""
    return kind if "/" in kind else "std_msgs/Header" if kind == "Header" else "{}/{}".format(package, kind)


def _listed(directory: str, ending: str) -> List[str]:
    """The names in a directory that end so, sorted; none where it cannot be read."""
    try:
        return sorted(name for name in os.listdir(directory) if name.endswith(ending) and _NAME.fullmatch(name))
    except OSError:
        return []


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


def _quoted(module: str) -> List[str]:
    """The definitions that a generated Python module quotes (``_full_text``): read, not imported. The types in one follow behind a line
    of ``=``. A message has one, a service two.
    """
    try:
        tree = ast.parse(module)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and any(isinstance(target, ast.Name) and target.id == "_full_text" for target in node.targets):
            try:
                value = ast.literal_eval(node.value)
            except (ValueError, TypeError, RecursionError, MemoryError):
                return []
            if not isinstance(value, str):
                return []
            found.append(re.split(r"^={20,}$", value, maxsplit=1, flags=re.MULTILINE)[0])
    return found


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
