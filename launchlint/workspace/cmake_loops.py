"""What a ``foreach`` of CMake goes through."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice, zip_longest

from launchlint.workspace.cmake_scope import Scope, Value

_MOST_TURNS = 1_000
_ZIP = "ZIP_LISTS"


def items(scope: Scope, words: Sequence[Value]) -> list[Value]:
    """The values of the variable, by the arguments behind it; ``None`` for each that is not known."""
    if words[:1] == ["RANGE"]:
        return [None]
    if words[:1] != ["IN"]:
        return list(words)
    chosen: list[Value] = []
    mode = ""
    for word in words[1:]:
        if word in ("LISTS", "ITEMS", _ZIP):
            mode = str(word)
        elif mode == "LISTS" and word is not None:
            value = scope.variables.get(word)
            if value is None:
                chosen += [each for each in scope.unions.get(word, "").split(";") if each]
            chosen += [None] if value is None else [each for each in value.split(";") if each]
        else:
            chosen.append(None if mode == _ZIP else word)
    return chosen


def zipped(scope: Scope, arguments: Sequence[Value]) -> list[dict[str, Value]] | None:
    """The variables of each turn of ``foreach(a b IN ZIP_LISTS as bs)``, or ``a_0`` and ``a_1`` where one is named; else ``None``.

    Of a list that is not known nothing is known in any turn.
    """
    at = arguments.index("IN") if "IN" in arguments else len(arguments)
    if arguments[at + 1 : at + 2] != [_ZIP]:
        return None
    names, lists = [each or "" for each in arguments[:at]], arguments[at + 2 :]
    if len(names) == 1:
        names = [f"{names[0]}_{number}" for number in range(len(lists))]
    values = [scope.variables.get(each or "") for each in lists]
    columns = [[] if each is None else each.split(";") for each in values]
    rows = islice(zip_longest(*columns, fillvalue=""), _MOST_TURNS)
    turns = [{name: None if value is None else item for name, value, item in zip(names, values, row, strict=False)} for row in rows]
    return turns or [dict.fromkeys(names)]
