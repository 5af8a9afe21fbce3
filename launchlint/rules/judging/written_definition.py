"""Whether two types are written alike in their packages: then they have one MD5 sum, and may talk to each other.

The sum is that of the constants and fields without comments, in which the sum of a nested type stands for its name
(genmsg.gentools.compute_md5_text).
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from launchlint.late import late
from launchlint.rules.judging.same_definition import STANDARD, stands_for
from launchlint.workspace.looking import content, is_file
from launchlint.workspace.packages import Packages

_END = {"topic": "msg", "service": "srv", "action": "action"}
_CONSTANT = late(r"\s*([\w/]+)\s+(\w+)\s*=\s*(.*)")
_FIELD = late(r"\s*([\w/]+)(\[\d*\])?\s+(\w+)\s*(?:#.*)?$")
_BUILTIN = frozenset("bool byte char int8 uint8 int16 uint16 int32 uint32 int64 uint64 float32 float64 string time duration".split())
_MOST_NESTED = 20
_MOST_LINES = 2_000

_Line = tuple[str, str, str]
"""Type, array brackets or the value of a constant, and name."""
_NEITHER: _Line = ("", "", "")


def are_written_alike(left: str, right: str, kind: str, packages: Packages, near: str) -> bool | None:
    """Whether two types (``package/Name``) have the same definition; None where that of one is not here.

    Args:
        left: one type.
        right: the other one.
        kind: ``topic``, ``service`` or ``action``.
        packages: where their packages are looked for.
        near: the launch file that asks.
    """
    return _Definitions(packages, near).are_alike(left, right, _END[kind], _MOST_NESTED)


class _Definitions:
    def __init__(self, packages: Packages, near: str) -> None:
        self._packages = packages
        self._near = near

    def are_alike(self, left: str, right: str, end: str, depth: int) -> bool | None:
        if stands_for(left) == stands_for(right):
            return True
        if {left.partition("/")[0], right.partition("/")[0]} <= STANDARD:
            return False
        mine, theirs = self._read(left, end), self._read(right, end)
        if mine is None or theirs is None or not depth:
            return None
        if len(mine) != len(theirs):
            return False
        sure = True
        for one, other in zip(mine, theirs, strict=True):
            if one[1:] != other[1:]:
                return False
            if one[0] == other[0]:
                continue
            nested = self.are_alike(one[0], other[0], "msg", depth - 1) if "/" in one[0] and "/" in other[0] else False
            if nested is False:
                return False
            sure = sure and nested is not None
        return True if sure else None

    def _read(self, name: str, end: str) -> list[_Line] | None:
        package_name, _, base = name.partition("/")
        package = self._packages.get(package_name, self._near)
        if package is None:
            return None
        path = posixpath.join(package.directory, end, f"{base.removesuffix('Action') if end == 'action' else base}.{end}")
        data = content(path) if is_file(path) else None
        lines = [] if data is None else data.decode("utf-8", "replace").splitlines()
        found = [*_lines(lines, package_name)] if len(lines) <= _MOST_LINES else [_NEITHER]
        return None if data is None or _NEITHER in found else found


def _lines(lines: list[str], package: str) -> Iterator[_Line]:
    """The constants, then the fields, of each part of a definition; an empty one for what is neither."""
    parts: list[list[str]] = [[]]
    for line in lines:
        if line.strip().startswith("---"):
            parts.append([])
        else:
            parts[-1].append(line)
    for number, part in enumerate(parts):
        constants, fields = [], []
        for line in part:
            constant, field = _CONSTANT.match(line), _FIELD.match(line)
            if constant is not None and "#" not in line[: line.index("=")]:
                value = constant[3] if constant[1] == "string" else constant[3].partition("#")[0]
                constants.append((constant[1], f"={value.strip()}", constant[2]))
            elif field is not None:
                fields.append((_full(field[1], package), field[2] or "", field[3]))
            elif line.strip() and not line.strip().startswith("#"):
                yield _NEITHER
        if number:
            yield "---", "", ""
        yield from constants
        yield from fields


def _full(name: str, package: str) -> str:
    """A type with its package."""
    if name in _BUILTIN:
        return name
    return "std_msgs/Header" if name == "Header" else name if "/" in name else f"{package}/{name}"
