"""A file name that is made from an arg: which value of the arg would lead to a file that is there."""

from __future__ import annotations

import re
from typing import NamedTuple

from launchlint.evaluate.problems import IncludeNotFound
from launchlint.rules.edits import Spot
from launchlint.rules.view import LaunchView
from launchlint.syntax.ros1.substitutions import parse


class Correction(NamedTuple):
    """The arg, the value with which the file is found, and where its default stands that leads elsewhere; None where it has another."""

    arg: str
    value: str
    default: Spot | None


def has_arg(written: str) -> bool:
    """Whether the name ``written`` is made from args: other callers may fill it in otherwise."""
    parts = parse(written)
    return parts.expression is not None or any(parts.substitutions("arg"))


def correction(problem: IncludeNotFound, written: str, meant: str, view: LaunchView) -> Correction | None:
    """What to give the only arg of ``written`` so that it becomes ``meant``; ``problem`` names the file that is not there."""
    args = list(parse(written).substitutions("arg"))
    if len(args) != 1 or not args[0].only:
        return None
    name, start, end = args[0].only, args[0].start, args[0].end
    found = re.fullmatch(f"{re.escape(written[:start])}([^/$()]+){re.escape(written[end:])}", meant)
    if found is None:
        return None
    document = view.documents.get(problem.place.source.path)
    elements = () if document is None else document.elements
    declared = [each for each in elements if each.tag == "arg" and each.get("name") == name and each.depth == 1]
    default = declared[0].attributes.get("default") if len(declared) == 1 else None
    if document is None or default is None or "$" in default.value:
        return Correction(name, found[1], None)
    filled = f"{written[:start].rpartition(')')[2]}{default.value}{written[end:]}"
    is_it = problem.file.endswith(filled)
    return Correction(name, found[1], Spot(document, declared[0], default) if is_it else None)
