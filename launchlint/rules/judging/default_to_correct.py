"""A file name that is made from an arg: which value of the arg would lead to a file that is there."""

from __future__ import annotations

import posixpath
import re

from launchlint.evaluate.problems import IncludeNotFound, ParamFileMissing
from launchlint.named_tuple import NamedTuple
from launchlint.rules.edits import Spot
from launchlint.rules.view import LaunchView
from launchlint.syntax.ros1.substitutions import parse
from launchlint.workspace.looking import exists, names

NO_CHOICE = frozenset(("none", "null", "nil", "unset", "undefined", "unspecified"))
"""What people write as the default of an arg that has to be given, in small letters."""
SENTINELS = frozenset(("true", "false", "none"))
"""What people write as the default of an arg for a path to say that there is none; the condition in front of it hangs on another arg."""
_MOST_NAMED = 5


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
    default = _default(name, problem, view)
    if default is None or default.attribute is None:
        return Correction(name, found[1], None)
    filled = f"{written[:start].rpartition(')')[2]}{default.attribute.value}{written[end:]}"
    is_it = problem.file.endswith(filled)
    return Correction(name, found[1], default if is_it else None)


def unchosen(problem: IncludeNotFound | ParamFileMissing, written: str, view: LaunchView) -> tuple[str, str] | None:
    """Why, and what to do, where the file that is not there is named by an arg whose default says *none*, and is there for other values."""
    args = list(parse(written).substitutions("arg"))
    if not args or not args[-1].only:
        return None
    name, before, behind = args[-1].only, written[: args[-1].start].rpartition(")")[2], written[args[-1].end :]
    default = _default(name, problem, view)
    value = "" if default is None or default.attribute is None else default.attribute.value
    if value.lower() not in NO_CHOICE or ")" in behind or not problem.file.endswith(f"{before}{value}{behind}"):
        return None
    directory, start = posixpath.split(problem.file[: -len(value + behind)])
    end, _, rest = behind.partition("/")
    fitting = [each for each in names(directory) if each.startswith(start) and each.endswith(end) and len(each) > len(start + end)]
    values = [each[len(start) : len(each) - len(end)] for each in fitting if exists(posixpath.join(directory, each, rest).rstrip("/"))]
    if not values:
        return None
    listed = ", ".join(values[:_MOST_NAMED]) + (" …" if len(values) > _MOST_NAMED else "")
    return f"{value} is only the default of {name}", f"drop the default, so that roslaunch asks for {name}; there are: {listed}"


def _default(name: str, problem: IncludeNotFound | ParamFileMissing, view: LaunchView) -> Spot | None:
    """The default of an arg of the file of ``problem``; None where it has none, several, or one that is computed."""
    document = view.documents.get(problem.place.source.path)
    elements = () if document is None else document.elements
    declared = [each for each in elements if each.tag == "arg" and each.get("name") == name and each.depth == 1]
    default = declared[0].attributes.get("default") if len(declared) == 1 else None
    return None if document is None or default is None or "$" in default.value else Spot(document, declared[0], default)
