"""What LL109 says of values that launch in ROS 2 does not take."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix
from launchlint.late import late
from launchlint.rules.edits import LOADS2, fix, write_over
from launchlint.rules.rule import Rule
from launchlint.spelling import closest, surely
from launchlint.syntax.ros2.problems import NegativeValue, OpenQuote, WrongValue, YamlForm
from launchlint.syntax.ros2.words import EXPECTED

_NUMBER = late(r"[-+]?\d+(\.\d*)?")
REFUSES = ("ros2 launch refuses the file",)

_MEANT = {"string": "str", "integer": "int", "double": "float", "boolean": "bool", "number": "float", "list": "yaml", "dict": "yaml"}
"""Types of ROS 1 and of other formats."""

_SHAPES = {
    "entities": ("{attribute} of {tag} must be a list of mappings", "write - before each of them: {attribute}: and below it - name: value"),
    "entity": ("each item of {attribute} of {tag} must be a mapping", "write its attributes as name: value"),
    "children": (
        "{tag} needs its actions as a list, or under the key children",
        "write the actions below children:, each with a - before it",
    ),
    "mapping": ("{tag} has no attributes here", "write its attributes below it as name: value, or {{}} where it has none"),
    "one-action": ("each item of the list must be one action", "write - and one key, the tag; every action has a - of its own"),
}
"""Shape of YAML that was wanted → message and help."""


def tell(problem: WrongValue | NegativeValue | OpenQuote | YamlForm, rule: Rule) -> Iterator[Finding]:
    """Name what is taken."""
    if isinstance(problem, YamlForm):
        message, advice = (words.format(tag=problem.tag, attribute=problem.attribute) for words in _SHAPES[problem.shape])
        yield rule.at(problem.origin, message, notes=REFUSES, help=advice)
        return
    name, tag = problem.attribute, problem.tag
    if isinstance(problem, OpenQuote):
        message, advice = f"the quotes in {name} do not match ({problem.reason})", "close the quote; write \\' or \\\" for a quote as such"
        yield rule.at(problem.origin, message, notes=REFUSES, help=advice)
        return
    if isinstance(problem, NegativeValue):
        message = f"{name}={problem.value[:60]!r} is negative"
        yield rule.at(problem.origin, message, label="must be a number from 0", notes=REFUSES, help="write a number of seconds")
        return
    value, expected = problem.value, problem.expected
    meant = _MEANT.get(value.strip().lower()) if name == "type" else None
    meant = meant or surely(value.strip(), problem.choices)
    near = meant or closest(value.strip(), problem.choices)
    shown = f"{name} of {tag} is empty" if not value else f"{name}={value[:60]!r} of {tag} is not {expected}"
    advice = f"did you mean {near}?" if near is not None else _advice(name, value, expected)
    if _fits_without_quotes(value, expected):
        shown, advice = f"{name}={value[:60]!r} of {tag} is a text, since quotes stand around it", "take the quotes away"
    yield rule.at(
        problem.origin,
        shown,
        label=f"must be {expected}" if len(expected) < 50 else "",
        notes=REFUSES,
        help=advice,
        fix=_fix(problem, near, sure=near == meant),
    )


def _fits_without_quotes(value: str, expected: str) -> bool:
    """Whether only the quotes that YAML has around ``value`` keep it from being what is wanted."""
    if expected == EXPECTED["bool"]:
        return value.strip().lower() in ("true", "false")
    return expected == EXPECTED["float"] and _NUMBER.fullmatch(value) is not None


def _fix(problem: WrongValue, near: str | None, *, sure: bool) -> Fix | None:
    if near is None:
        return None
    return fix(f"write {near}", write_over(problem.place, problem.value, near), safe=sure, changes=LOADS2)


def _advice(name: str, value: str, expected: str) -> str:
    if name == "value" and expected.startswith("a text, a number"):
        if value.startswith("["):
            return "write values of one type, 1.0 for 1 beside 2.5"
        return "write params inside it, one for each key" if value.startswith("{") else 'add type="str" to have it as a text'
    return f"write {expected}"
