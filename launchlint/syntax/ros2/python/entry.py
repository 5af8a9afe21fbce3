"""What launch wants of a launch file in Python as a whole: that Python can read it, and one function that gives a description."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from launchlint.problem import Problem
from launchlint.python.values import Class, Function, Handle, Instance, Map, Seq, Value
from launchlint.python.walking import walk
from launchlint.source import Origin, Place, Source, Span
from launchlint.syntax.ros2.python.arguments import spelled
from launchlint.syntax.ros2.python.problems import NoDescription
from launchlint.syntax.ros2.python.tables import is_of_launch
from launchlint.syntax.ros2.python.texts import is_substitution

ENTRY = "generate_launch_description"
_FOR_TESTS = "generate_test_description"
_MAKING_NAMES = frozenset(("globals", "locals", "vars", "exec", "setattr"))
_NEWER = re.compile(r"\s*(?:type\s+\w.*=|(?:async\s+def|def|class)\s+\w+\s*\[)")
"""Lines that a newer Python can read, and the one that launchlint runs with perhaps not."""


def unreadable(source: Source, error: SyntaxError) -> Problem | None:
    """Python cannot read the file; None where a newer one may."""
    line, column = error.lineno or 1, max((error.offset or 1) - 1, 0)
    text = source.line(line)
    if "f-string" in (error.msg or "") or _NEWER.match(text) or re.search(r"\b[fF][rR]?['\"]|\b[rR][fF]['\"]", text):
        return None
    start = min(source.line_starts[min(line, len(source.line_starts)) - 1] + min(column, len(text)), len(source.text))
    place = Place(source, Span(start, min(start + 1, len(source.text))))
    return NoDescription(origin=Origin(place), refused=True, form="syntax", what=(error.msg or "").rstrip("."))


def without_entry(tree: ast.Module, source: Source) -> Problem | None:
    """The file has no function that launch could call; None where something else may set its name, or it is a test for launch_testing.

    A decorator may: those of other launchers put such a function beside the one they are given.
    """
    if any(isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)) and each.decorator_list for each in tree.body):
        return None
    for node in walk(tree):
        if isinstance(node, ast.ImportFrom) and any(alias.name == "*" for alias in node.names):
            if not is_of_launch(node.module or ""):
                return None
        elif {ENTRY, _FOR_TESTS} & set(_names(node)) or (isinstance(node, ast.Name) and node.id in _MAKING_NAMES):
            return None
    return NoDescription(origin=Origin(_whole(source)), refused=True, form="missing", what="")


def _names(node: ast.AST) -> Iterator[str]:
    if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
        yield node.name
    elif isinstance(node, ast.alias):
        yield node.asname or node.name
    elif isinstance(node, ast.Name):
        yield node.id


def needs_arguments(function: Function) -> list[str]:
    """The parameters of the entry function that launch gives no value."""
    if isinstance(function.node, ast.Lambda):
        return []
    arguments = function.node.args
    plain = [*arguments.posonlyargs, *arguments.args]
    needed = [each.arg for each in plain[: len(plain) - len(arguments.defaults)]]
    return needed + [each.arg for each, default in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True) if default is None]


def takes_arguments(needed: list[str], place: Place) -> Problem:
    """The function wants what launch does not give."""
    return NoDescription(origin=Origin(place), refused=True, form="arguments", what=", ".join(needed))


def gives(value: Value, place: Place) -> Problem | None:
    """The function returns what is no description; None where it may be one."""
    if value is None:
        return NoDescription(origin=Origin(place), refused=True, form="nothing", what="None")
    if isinstance(value, Seq):
        return NoDescription(origin=Origin(place), refused=True, form="list", what="a tuple" if value.is_tuple else "a list")
    found = spelled(value)
    if not found and isinstance(value, (str, Map)):
        found = "a text" if isinstance(value, str) else "a dict"
    if not found and is_substitution(value) and isinstance(value, Handle):
        found = f"an object of {value.kind}"
    if isinstance(value, Handle) and value.kind == "LaunchDescription":
        return None
    if not found or isinstance(value, (Instance, Class)):
        return None
    return NoDescription(origin=Origin(place), refused=True, form="other", what=found)


def _whole(source: Source) -> Place:
    return Place(source, Span(0, min(len(source.line(1)), len(source.text))))
