"""The proof that an edit of a ``package.xml`` adds dependencies and does nothing else."""

from __future__ import annotations

from collections import Counter

from launchlint.workspace.manifest import parse_manifest


def refusal(file: str, before: bytes, after: bytes) -> str:
    """Why the edit must not be made, in one sentence without a full stop; empty where all that it does is to add dependencies."""
    try:
        old, new = parse_manifest(before, file), parse_manifest(after, file)
    except ValueError as error:
        return str(error)
    declared, added = (Counter((each.name, each.tag) for each in manifest.dependencies) for manifest in (old, new))
    if declared - added:
        return "a dependency would be lost"
    if not added - declared:
        return "no dependency would be added"
    for field in ("name", "format", "metapackage", "plugins", "build_types"):
        if getattr(old, field) != getattr(new, field):
            return f"its {field.replace('_', ' ')} would change"
    return ""
