"""``$(eval …)``: a table of expressions, the bounds, what is read without evaluating, and the same table through the real roslaunch."""

from __future__ import annotations

import ast
import json
import subprocess
import time

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.evaluate.ros1.expression import (
    EnvironmentUnset,
    ExpressionError,
    UndefinedArg,
    UnknownValue,
    arguments_read,
    compared_literals,
    evaluate,
    made_into_text,
    truth_tested,
    whole_arg,
)
from tests.evaluate.ros1.expressions import ARGUMENTS, ENVIRONMENT, NOT_COMPUTED, TABLE, UNKNOWN


class World:
    """The args and the environment of the table."""

    def __init__(self, arguments: dict[str, str] = ARGUMENTS) -> None:
        self.arguments = arguments

    def arg(self, name: str) -> str:
        if name not in self.arguments:
            raise UndefinedArg(name)
        return self.arguments[name]

    def has_arg(self, name: str) -> bool:
        return name in self.arguments

    def env(self, name: str) -> str:
        if name not in ENVIRONMENT:
            raise EnvironmentUnset(name)
        return ENVIRONMENT[name]

    def optenv(self, name: str, default: str) -> str:
        return ENVIRONMENT.get(name, default)

    def find(self, package: str) -> str:
        return f"/find/{package}"

    def anon(self, id: str) -> str:
        return f"{id}_anon"

    def dirname(self) -> str:
        return "/dir"


def outcome(text: str) -> str:
    """The value, the name of the error, or UNKNOWN."""
    try:
        return evaluate(text, World())
    except ExpressionError as error:
        return error.kind if 0 <= error.start <= error.end <= len(text) and error.message else "(an error without a place or words)"
    except UnknownValue as unknown:
        return UNKNOWN if unknown.reason else "(unknown without a reason)"


@pytest.mark.parametrize(("text", "expected"), TABLE)
def test_value(text: str, expected: str) -> None:
    assert outcome(text) == expected


@pytest.mark.parametrize("text", NOT_COMPUTED, ids=lambda text: text[:30])
def test_what_is_too_large_or_not_covered_is_unknown_and_known_to_be_so_at_once(text: str) -> None:
    started = time.monotonic()
    assert outcome(text) == UNKNOWN
    assert time.monotonic() - started < 2


@pytest.mark.parametrize(
    ("text", "marked", "words"),
    [
        ("a + nothing", "nothing", "there is no arg 'nothing' with a value here"),
        ("'ä' + arg('nothing')", "arg('nothing')", "there is no arg 'nothing' with a value here"),
        ("1 + env('UNSET')", "env('UNSET')", "the environment variable 'UNSET' is not set"),
        ("a + (b / 0)", "b / 0", "this divides by zero (Python says: ZeroDivisionError: "),
        ("  a + c", "a + c", "this cannot be done with values of these types"),
        ("(a +\nlen(c[9]))", "c[9]", "there is no element at this place (Python says: IndexError: "),
        ("a + eval('1 / 0')", "eval('1 / 0')", "this divides by zero"),
        ("'a__b'", "__", "roslaunch refuses every $(eval) that contains two underscores in a row"),
        ("[x + a for x in [1]]", "a", "inside a comprehension or lambda neither args nor roslaunch's own names can be used"),
        ("a && b", "&", "this is not an expression that Python can read"),
    ],
)
def test_error_has_its_place_and_says_what_is_wrong(text: str, marked: str, words: str) -> None:
    with pytest.raises(ExpressionError) as raised:
        evaluate(text, World())
    assert text[raised.value.start : raised.value.end] == marked
    assert raised.value.message.startswith(words)


def test_error_names_the_missing_arg_or_variable() -> None:
    found = {}
    for text in ("nothing", "arg('nothing')", "eval('nothing')", "env('UNSET')", "1 / 0"):
        with pytest.raises(ExpressionError) as raised:
            evaluate(text, World())
        found[text] = (raised.value.undefined_arg, raised.value.unset_env)
    assert found == {
        "nothing": ("nothing", None),
        "arg('nothing')": ("nothing", None),
        "eval('nothing')": ("nothing", None),
        "env('UNSET')": (None, "UNSET"),
        "1 / 0": (None, None),
    }


class Unknowing(World):
    """Does not know any arg but ``a``."""

    def arg(self, name: str) -> str:
        if name != "a":
            raise UnknownValue(f"{name} is not known")
        return super().arg(name)


def test_what_does_not_depend_on_the_unknown_is_known() -> None:
    assert evaluate("a == 5 or c", Unknowing()) == "True"
    with pytest.raises(UnknownValue, match="c is not known"):
        evaluate("a == 6 or c", Unknowing())


class Failing(World):
    def find(self, package: str) -> str:
        raise LookupError(package)


def test_exceptions_of_the_resolver_pass_through() -> None:
    with pytest.raises(LookupError, match=r"^demo$"):
        evaluate("sorted([1], key=lambda x: 0) and find('demo')", Failing())


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("a == 5 and arg('b') or c", {"a", "b", "c"}),
        ("true and pi > e", set()),
        ("arg('e') + e", {"e"}),
        ("str(map) + list[0]", {"str", "map", "list"}),
        ("[x + a for x in b]", {"a", "b"}),
        ("eval('a + arg(\"b\")')", {"eval", "a", "b"}),
        ("find(robot + '_x') + optenv('Y')", {"robot"}),
        ("arg(c)", {"c"}),
        ("'a' + \"b\"", set()),
        ("a +", {"a"}),
        ("[" * 500 + "a", {"a"}),
    ],
)
def test_arguments_read(text: str, names: set[str]) -> None:
    assert arguments_read(text) == names


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a == 'x' or a == 'y' or b != 2", {"a": ("x", "y"), "b": ("2",)}),
        ("arg('mode') in ['x', \"y\"]", {"mode": ("x", "y")}),
        ("'x' == a.lower()", {"a": ("x",)}),
        ("a in ('x', 1, 2.5, True)", {"a": ("x", "1", "2.5", "true")}),
        ("1 < a <= 10", {"a": ("1", "0", "2", "10", "9", "11")}),
        ("a > 0.5", {"a": ("0.5", "-0.5", "1.5")}),
        ("a == -1", {"a": ("-1",)}),
        ("not a and b == true", {"a": ("true", "false"), "b": ("true",)}),
        ("a", {"a": ("true", "false")}),
        ("'x' if a else 'y'", {"a": ("true", "false")}),
        ("{'iron': 1, 'steel': 2}.get(arg('robot'), 3)", {"robot": ("iron", "steel")}),
        ("{'iron': 1}[robot]", {"robot": ("iron",)}),
        ("a.startswith('pre') or str(b).endswith(('x', 'y'))", {"a": ("pre",), "b": ("x", "y")}),
        ("'sim' in a", {"a": ("sim",)}),
        ("eval('a == 3')", {"a": ("3",)}),
        ("a == b", {}),
        ("pi == 3 and a == None", {}),
        ("a ==", {}),
    ],
)
def test_compared_literals(text: str, expected: dict[str, tuple[str, ...]]) -> None:
    assert compared_literals(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("mode == 'fast' or mode in ['slow', 'off']", {"mode": ("fast", "slow", "off")}),
        ("'e' in model", {}),
        ("model.startswith('ur')", {}),
        ("count > 2", {"count": ("2",)}),
        ("{'a': 1}[kind]", {"kind": ("a",)}),
    ],
)
def test_what_an_arg_may_be_equal_to(text: str, expected: dict[str, tuple[str, ...]]) -> None:
    assert compared_literals(text, exact=True) == expected


@pytest.mark.parametrize(
    ("text", "as_text", "as_truth", "alone"),
    [
        ("sim", set(), set(), "sim"),
        ("arg('sim')", set(), set(), "sim"),
        ("not sim", set(), {"sim"}, None),
        ("sim and arg('gui')", set(), {"sim", "gui"}, None),
        ("'a_' + robot", {"robot"}, set(), None),
        ("find('p') + '/' + arg('robot')", {"robot"}, set(), None),
        ("robot.upper()", {"robot"}, set(), None),
        ("'a' if sim else robot + 'b'", {"robot"}, {"sim"}, None),
        ("1 + (2 if sim else 3)", set(), {"sim"}, None),
        ("'%s' % (not sim)", set(), {"sim"}, None),
        ("robot ==", set(), set(), None),
    ],
)
def test_what_an_expression_does_with_args(text: str, as_text: set[str], as_truth: set[str], alone: str | None) -> None:
    assert (made_into_text(text), truth_tested(text), whole_arg(text)) == (as_text, as_truth, alone)


# The same through the real roslaunch. The expressions are ours, and a list of names keeps out whatever could touch the machine.

REAL = """
import ast, json, os, sys
import roslaunch.substitution_args as real
import rosgraph.names
given = json.load(sys.stdin)
os.environ.clear()
os.environ.update(given["environment"])
rosgraph.names.anonymous_name = lambda id: id + "_anon"
class Packages:
    def get_path(self, name):
        return "/find/" + name
real._rospack = Packages()
answers = []
for text in given["expressions"]:
    try:
        answers.append(real._eval(text, {"arg": dict(given["arguments"]), "filename": "/dir/file.launch"}))
    except Exception as error:
        names = [kind.__name__ for kind in type(error).__mro__]
        answers.append([names])
json.dump(answers, sys.stdout)
"""
REFUSED = frozenset("open exec compile input breakpoint help exit quit getattr setattr delattr globals locals vars print type".split())


def harmless(text: str) -> bool:
    """Whether the real ``eval`` may see ``text``: neither dangerous names nor anything large."""
    try:
        tree = ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError):
        return True
    return not any(isinstance(node, ast.Name) and node.id in REFUSED for node in ast.walk(tree))


def real_outcomes(ros_python: str, expressions: list[str]) -> list[list[str] | str]:
    """For each expression roslaunch's value, or the names of the exception's classes."""
    assert all(harmless(text) for text in expressions)
    given = json.dumps({"expressions": expressions, "arguments": ARGUMENTS, "environment": ENVIRONMENT})
    run = subprocess.run([ros_python, "-W", "ignore", "-c", REAL], input=given, capture_output=True, text=True, timeout=120, check=True)
    return [answer if isinstance(answer, str) else answer[0] for answer in json.loads(run.stdout)]


def disagreements(expressions: list[str], real: list[list[str] | str]) -> list[tuple[str, str, list[str] | str]]:
    found = []
    for text, answer in zip(expressions, real, strict=True):
        ours = outcome(text)
        agreed = ours == answer if isinstance(answer, str) else ours in answer
        if not agreed and ours != UNKNOWN:
            found.append((text, ours, answer))
    return found


@pytest.mark.ros
def test_table_is_what_roslaunch_says(ros_python: str) -> None:
    expressions = [text for text, _ in TABLE]
    assert disagreements(expressions, real_outcomes(ros_python, expressions)) == []


NAMES = ["a", "b", "c", "t", "f", "n", "u", "empty", "path", "robot", "e", "map", "nothing", "pi", "padded", "true"]
LITERALS = ["1", "0", "2", "-1", "2.5", "'x'", "'hello'", "''", "'5'", "True", "None", "[1, 2]", "('a',)", "{'a': 1}", "'a,b'", "{1, 2}"]
UNARY = ["-{0}", "not {0}", "+{0}", "~{0}", "({0})", "str({0})", "int({0})", "float({0})", "len({0})", "bool({0})", "abs({0})", "repr({0})"]
UNARY += [
    "{0}.lower()",
    "{0}.split(',')",
    "{0}.strip()",
    "{0}[0]",
    "{0}[1:]",
    "{0}[-1]",
    "sorted({0})",
    "sum({0})",
    "max({0})",
    "tuple({0})",
]
UNARY += [
    "round({0})",
    "sqrt({0})",
    "floor({0})",
    "[x for x in {0}]",
    "[x * 2 for x in {0} if x]",
    "arg({0})",
    "optenv({0}, {0})",
    "eval({0})",
]
UNARY += [
    "f'{{{0}}}'",
    "'%s' % {0}",
    "'{{}}'.format({0})",
    "'{{:>6}}'.format({0})",
    "{0}.upper()",
    "[{0}]",
    "{{'a': {0}}}",
    "any({0})",
    "{0}.copy()",
]
UNARY += [
    "isinstance({0}, str)",
    "isinstance({0}, int)",
    "''.join({0})",
    "dict({0})",
    "(lambda x: x)({0})",
    "ord({0})",
    "{0}.real",
    "{0}.isdigit()",
]
BINARY = [
    "{0} + {1}",
    "{0} - {1}",
    "{0} * {1}",
    "{0} / {1}",
    "{0} // {1}",
    "{0} % {1}",
    "{0} == {1}",
    "{0} != {1}",
    "{0} < {1}",
    "{0} >= {1}",
]
BINARY += [
    "{0} in {1}",
    "{0} not in {1}",
    "{0} and {1}",
    "{0} or {1}",
    "{0} if {1} else 7",
    "[{0}, {1}]",
    "{0} & {1}",
    "{0} | {1}",
    "{0} ^ {1}",
]
BINARY += [
    "{0} << {1}",
    "{0} >> {1}",
    "{0}.get({1})",
    "{0}.startswith({1})",
    "{0}.replace({1}, 'z')",
    "{0}.count({1})",
    "{0}[{1}]",
    "min({0}, {1})",
]
BINARY += [
    "divmod({0}, {1})",
    "round({0}, {1})",
    "{{{0}: {1}}}",
    "'%s-%s' % ({0}, {1})",
    "{0}.join({1})",
    "{0} is {1}",
    "pow({0}, {1})",
    "{0} <= {1} < 3",
]
BINARY += [
    "[x + {1} for x in {0}]",
    "tuple(zip({0}, {1}))",
    "{0}.index({1})",
    "'{{:{{}}}}'.format({0}, {1})",
    "{0} ** ({1})",
    "sum({0}, {1})",
    "{0}.zfill({1})",
]

EXPRESSIONS = st.recursive(
    st.sampled_from(NAMES + LITERALS),
    lambda inner: st.one_of(
        st.builds(str.format, st.sampled_from(UNARY), inner), st.builds(str.format, st.sampled_from(BINARY), inner, inner)
    ),
    max_leaves=6,
)


@pytest.mark.ros
@settings(max_examples=8, deadline=None, suppress_health_check=list(HealthCheck))
@given(expressions=st.lists(EXPRESSIONS, min_size=60, max_size=120, unique=True))
def test_random_expressions_are_what_roslaunch_says(ros_python: str, expressions: list[str]) -> None:
    # What we do not compute could be large: only the rest is handed to the real eval.
    computed = [text for text in expressions if outcome(text) != UNKNOWN and "**" not in text]
    assert disagreements(computed, real_outcomes(ros_python, computed)) == []
