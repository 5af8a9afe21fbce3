"""What can be told of a launch file in Python without reading it as a program: whether it is one that describes nothing."""

from __future__ import annotations

LONGEST = 2_000
"""Bytes: a file that describes nothing is short."""


def describes_nothing(data: bytes) -> bool:
    """Whether a launch file in Python imports things and returns an empty ``LaunchDescription``, as those do that are kept for the
    sake of who includes them. Never raises; nothing of it is run.
    """
    if len(data) > LONGEST:
        return False
    import ast

    try:
        program = ast.parse(data)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    *before, last = program.body or [ast.Pass()]
    if not (isinstance(last, ast.FunctionDef) and last.name == "generate_launch_description" and not last.decorator_list):
        return False
    if not all(isinstance(each, ast.ImportFrom) and each.module == "launch" for each in before if not _is_text(each)):
        return False
    *documented, returned = last.body
    return all(map(_is_text, documented)) and isinstance(returned, ast.Return) and _is_empty(returned.value)


def _is_text(statement: object) -> bool:
    import ast

    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)


def _is_empty(value: object) -> bool:
    """Whether it is ``LaunchDescription()`` or ``LaunchDescription([])``."""
    import ast

    if not (isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and value.func.id == "LaunchDescription"):
        return False
    return not value.keywords and all(isinstance(each, ast.List) and not each.elts for each in value.args)
