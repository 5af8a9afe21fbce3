"""Edits of launch files in Python, and words that several rules for them need."""

from __future__ import annotations

from launchlint.finding import Edit, Severity
from launchlint.problem import Problem
from launchlint.rules.edits import Edits
from launchlint.source import Place

_LONGEST = 60
_DESCRIBES = "def generate_launch_description("


def level(problem: Problem) -> Severity:
    """Error, or a warning where it may be that launch never gets there."""
    return Severity.WARNING if problem.assumed else Severity.ERROR


def reads_environment(place: Place) -> bool:
    """Whether a launch file in Python reads variables of the environment: a path or value may be another one where they are set."""
    source = place.source
    return (source.path.endswith(".py") or _DESCRIBES in source.text) and any(
        each in source.text for each in ("getenv(", "environ[", "environ.get(")
    )


def shown(text: str) -> str:
    """What is written somewhere, on one line and not too long."""
    line = " ".join(text.split())
    return line if len(line) <= _LONGEST else f"{line[: _LONGEST - 1]}…"


def stops(error: str) -> tuple[str, ...]:
    """The note that names the error of Python."""
    return (f"ros2 launch stops with {error}",)


def write(place: Place, text: str) -> Edits:
    """Write ``text`` where ``place`` is."""
    return (Edit(place.source.path, *place.span, text),)


def before(place: Place, text: str) -> Edits:
    """Write ``text`` in front of ``place``."""
    return (Edit(place.source.path, place.span.start, place.span.start, text),)


def behind(place: Place, text: str) -> Edits:
    """Write ``text`` behind ``place``."""
    return (Edit(place.source.path, place.span.end, place.span.end, text),)


def around(place: Place, left: str, right: str) -> Edits:
    """Write ``left`` in front of ``place`` and ``right`` behind it."""
    return (*before(place, left), *behind(place, right))


def literal(place: Place) -> object:
    """The value of what is written at ``place``, if it is a literal of Python; ``...`` where it is none."""
    import ast

    try:
        return ast.literal_eval(place.text)
    except (ValueError, SyntaxError, RecursionError, MemoryError, TypeError):
        return ...


def is_one_operand(place: Place) -> bool:
    """Whether an attribute can be written behind what stands at ``place``: a name, a call, a dict, and no operator."""
    import ast

    try:
        tree = ast.parse(place.text.strip(), mode="eval").body
    except (ValueError, SyntaxError, RecursionError, MemoryError):
        return False
    return isinstance(tree, (ast.Name, ast.Attribute, ast.Call, ast.Dict, ast.DictComp, ast.Subscript))
