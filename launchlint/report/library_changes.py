"""What changed from one library to another, for people and programs."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any

from launchlint.library.difference import Change
from launchlint.library.format import KINDS
from launchlint.report.escape import visible
from launchlint.report.library import condition_words, title, value_words

_SIGNS = {"added": "+", "removed": "-", "changed": "~"}


def changes_text(changes: Sequence[Change]) -> str:
    """One block for each program: ``+`` what came, ``-`` what went, ``~`` what is different. Empty where nothing changed."""
    blocks = []
    for (package, table, program), group in groupby(changes, key=lambda change: (change.package, change.table, change.program)):
        members = list(group)
        whole = [change for change in members if change.what == KINDS[table] and change.kind != "changed"]
        sign = f"{_SIGNS[whole[0].kind]} " if whole else ""
        lines = [f"{sign}{title(package, table, program)}", *(f"  {_line(change)}" for change in members if change not in whole)]
        blocks.append("".join(f"{line}\n" for line in lines))
    return "\n".join(blocks)


def changes_json(changes: Sequence[Change]) -> str:
    """The same as a JSON list: the fields of :class:`Change`, its kind as ``change`` and its table in words as ``kind``."""
    return json.dumps([_object(change) for change in changes], indent=2) + "\n"


def _object(change: Change) -> dict[str, Any]:
    row = change._asdict()
    del row["table"]
    return {"change": row.pop("kind"), "package": row.pop("package"), "kind": KINDS[change.table], **row}


def _line(change: Change) -> str:
    name = "" if change.what == KINDS[change.table] else f" {change.name}"
    variant = f" [variant {change.variant}]" if change.variant not in ("", "default") and change.what != "variant" else ""
    details = ", ".join(_details(change))
    if change.kind == "changed":
        details = f": {details}"
    elif details:
        details = f" ({details})"
    return visible(f"{_SIGNS[change.kind]} {change.what}{name}{variant}{details}")


def _details(change: Change) -> Iterator[str]:
    before, after = change.before or {}, change.after or {}
    if change.kind == "changed":
        for key in sorted({*before, *after}):
            yield f"{key} {_said(key, before)} → {_said(key, after)}"
        return
    entry = before or after
    if "type" in entry:
        yield entry["type"]
    for key in sorted(entry.keys() - {"name", "role", "type", "md5"}):
        yield f"{key} {_said(key, entry)}"


def _said(key: str, values: Any) -> str:
    if key not in values:
        return "none"
    value = values[key]
    text = condition_words(value) if key in ("condition", "match") else value_words(value)
    return text if len(text) <= 200 else f"{text[:199]}…"
