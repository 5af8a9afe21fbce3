"""Values of a followed launch file as texts: strings, substitutions, and lists of them.

Source: ``launch.utilities.normalize_to_list_of_substitutions``.
"""

from __future__ import annotations

import re

from launchlint.problem import Problem
from launchlint.python.values import SIGNS, Handle, Map, Seq, Value
from launchlint.python.values import Text as Open
from launchlint.source import Place
from launchlint.syntax.ros2.description import Substitution, Text

_SLOT = re.compile(r"\{\{|\}\}|\ue000\{(share|prefix):([^{}]+)\}|[{}\ue000\ue001]")
_PACKAGE = {"share": "find-pkg-share", "prefix": "find-pkg-prefix"}
_PLAIN = {
    "LaunchConfiguration": ("var", "variable_name", "default"),
    "EnvironmentVariable": ("env", "name", "default_value"),
    "Command": ("command", "command", "on_stderr"),
    "FindExecutable": ("find-exec", "name"),
    "ThisLaunchFile": ("filename",),
    "ThisLaunchFileDir": ("dirname",),
    "AnonName": ("anon", "name"),
    "NotSubstitution": ("not", "value"),
    "AndSubstitution": ("and", "left", "right"),
    "OrSubstitution": ("or", "left", "right"),
    "EqualsSubstitution": ("equals", "left", "right"),
    "NotEqualsSubstitution": ("not-equals", "left", "right"),
    "IfElseSubstitution": ("if", "condition", "if_value", "else_value"),
    "FileContent": ("file-content", "path"),
    "LaunchLogDir": ("launch_log_dir",),
    "FindPackageShare": ("find-pkg-share", "package"),
    "FindPackagePrefix": ("find-pkg-prefix", "package"),
    "ExecutableInPackage": ("exec-in-pkg", "executable", "package"),
    "Parameter": ("param", "name", "default"),
}
"""Class → the name of its substitution, and which of its arguments are the words."""
SUBSTITUTIONS = frozenset((*_PLAIN, "TextSubstitution", "PathJoinSubstitution", "PythonExpression"))
PATH_JOIN = "path-join"
"""What stands for PathJoinSubstitution: its parts are joined as by os.path.join when all of them are performed."""


class NotUnderstood(Exception):
    """What a launch file in Python does cannot be told with certainty; says why, and where.

    ``problems`` are those that were noticed before, where it is that of a whole file.
    """

    problems: tuple[Problem, ...] = ()

    def __init__(self, reason: str, place: Place | None = None) -> None:
        super().__init__(reason)
        self.reason = reason
        self.place = place


def is_substitution(value: Value) -> bool:
    """Whether a value is an object of a substitution's class."""
    return isinstance(value, Handle) and value.kind in SUBSTITUTIONS


def text(value: Value, place: Place) -> Text:
    """The text that a value stands for. Raises NotUnderstood."""
    pieces: list[str | Substitution] = []
    for each in _items(value, place):
        _add(pieces, each, place)
    return Text(tuple(pieces), place)


def _items(value: Value, place: Place) -> list[Value]:
    if isinstance(value, Seq):
        if not value.complete:
            raise NotUnderstood("a list of which not all items are known", place)
        return value.items
    return [value]


def _add(pieces: list[str | Substitution], value: Value, place: Place) -> None:
    new: list[str | Substitution] = []
    if isinstance(value, str):
        new = [value]
    elif isinstance(value, Open):
        new = _slots(value.template, place)
    elif isinstance(value, Handle) and value.kind == "TextSubstitution":
        new = [known(value.state["text"], place)]
    elif isinstance(value, Handle) and value.kind in SUBSTITUTIONS:
        new = [substitution(value)]
    else:
        raise NotUnderstood("a value that is not known, or is no text", place)
    for piece in new:
        if isinstance(piece, str) and pieces and isinstance(pieces[-1], str):
            pieces[-1] += piece
        elif piece != "":
            pieces.append(piece)


def _slots(template: str, place: Place) -> list[str | Substitution]:
    """A string in which directories of packages stand."""
    found: list[str | Substitution] = [""]
    at = 0
    for match in _SLOT.finditer(template):
        found.append(template[at : match.start()])
        at = match.end()
        if match[1]:
            found.append(Substitution(_PACKAGE[match[1]], (Text((match[2],), place),), place))
        elif match[0] in ("{{", "}}"):
            found.append(match[0][0])
        else:
            raise NotUnderstood("a string of which not all is known", place)
    return [*found, template[at:]]


def known(value: Value, place: Place) -> str:
    """A string that is known. Raises NotUnderstood."""
    if isinstance(value, str):
        return value
    raise NotUnderstood("a text that is not known", place)


def substitution(value: Handle) -> Substitution:
    """What an object of a substitution's class stands for. Raises NotUnderstood."""
    place: Place = value.state["place"]
    given = value.state
    if value.kind == "PathJoinSubstitution":
        parts = given["substitutions"]
        if not isinstance(parts, Seq) or not parts.complete:
            raise NotUnderstood("a path of which not all parts are known", place)
        return Substitution(PATH_JOIN, tuple(text(each, place) for each in parts.items), place)
    if value.kind == "PythonExpression":
        modules = given.get("python_modules")
        words = (text(given["expression"], place),)
        if modules is None:
            return Substitution("eval", words, place)
        names = [known(each, place) for each in _items(modules, place)]
        return Substitution("eval", (*words, Text((",".join(names),), place)), place)
    name, *roles = _PLAIN[value.kind]
    arguments = [text(given[role], place) for role in roles if given.get(role) is not None]
    return Substitution(name, tuple(arguments), place)


def share(package: str, kind: str = "share") -> Open:
    """The string that get_package_share_directory gives: kept open, since which copy of a package counts is seen from the entry file."""
    return Open(f"{SIGNS[0]}{{{kind}:{package}}}")


def pairs(value: Value, place: Place) -> list[tuple[Value, Value]]:
    """A list of pairs, or a mapping's items. Raises NotUnderstood."""
    if isinstance(value, Map):
        if not value.complete:
            raise NotUnderstood("a dict of which not all entries are known", place)
        return list(value.entries.items())
    found: list[tuple[Value, Value]] = []
    for each in _items(value, place):
        two = each.items if isinstance(each, Seq) and each.complete else ()
        if len(two) != 2:
            raise NotUnderstood("pairs are wanted here", place)
        found.append((two[0], two[1]))
    return found
