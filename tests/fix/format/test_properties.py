"""What must hold for any document: formatted once is formatted, nothing is lost, and the XML says the same."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.fix.format.tokens import tokens
from tests.evaluate.comparison import MAIN, Case, difference, inside, ours, theirs, write
from tests.evaluate.random_launch import random_case
from tests.fix.format.reading import canonical, held

PROPERTY = settings(max_examples=200, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
STYLES = st.builds(Style, st.integers(40, 140), st.integers(1, 8), st.booleans())

SPACES = ("", " ", "  ", "\n", "\n\n\n", "\t", "\n\t\t", "   \n  ", "\r\n", "\r\n \r\n")
BETWEEN = (
    "<!-- a -->",
    "<!--\n  two\n      lines  \n-->",
    "<!---->",
    "<?pi some thing?>",
    "<![CDATA[ < & ]]>",
    "text",
    "&amp;",
    "&#65;",
    "&e;",
    "<!-- launchlint: format off -->",
    "<!-- launchlint: format on -->",
    "<a/>",
    "<rosparam>\n  a: 1\n</rosparam>",
    '<b xml:space="preserve"> <c/>  </b>',
)
NAMES = ("launch", "group", "node", "param", "rosparam", "arg", "other", "Remap")
VALUES = ('"a"', "'b'", "'say \"c\"'", '"&lt;&quot;"', '"two\n   lines"', '"  "', '""', "'é'")


def random_text(random: Random) -> str:
    """A well-formed document with everything that XML has, at places where people put it and where they do not."""

    def space() -> str:
        return random.choice(SPACES)

    def tag(name: str, depth: int) -> str:
        keys = random.sample(("if", "name", "pkg", "type", "value", "x", "y"), random.randint(0, 5))
        attributes = "".join(f"{random.choice(SPACES[1:])}{key}{random.choice(('=', ' = '))}{random.choice(VALUES)}" for key in keys)
        if random.random() < 0.3:
            return f"<{name}{attributes}{space()}/>"
        return f"<{name}{attributes}{space()}>{content(depth + 1)}</{name}{space()}>"

    def table() -> str:
        lines = []
        for _ in range(random.randint(2, 6)):
            keys = ["name", "value", "x"][: random.choice((1, 2, 2, 2, 3))] if random.random() < 0.9 else ["value", "name"]
            line = "<param"
            for number, key in enumerate(keys):
                line = f'{line} {key}="{"v" * random.choice((1, 1, 3, 9, 30))}"'.ljust(25 * (number + 1) * (random.random() < 0.9))
            lines.append(f"{line}/>{random.choice(('', '', ' <!-- a -->'))}")
        return random.choice(("\n", "\n  ")).join(lines)

    def content(depth: int) -> str:
        parts = [space()]
        for _ in range(random.choice((0, 1, 2, 4) if depth < 4 else (0, 1))):
            if random.random() < 0.2:
                parts.append(table())
            else:
                parts.append(tag(random.choice(NAMES[1:]), depth) if random.random() < 0.5 and depth < 5 else random.choice(BETWEEN))
            parts.append(space())
        return "".join(parts)

    prolog = random.choice(("", "<?xml version='1.0' encoding='utf-8'?>", "\n"))
    comment = random.choice(("", "<!-- top -->", "\n<!-- launchlint: format off -->\n"))
    start = f'{prolog}{space()}{comment}<!DOCTYPE launch [<!ENTITY e "<d>]</d>">]>{space()}'
    return start + tag("launch", 0) + space() + random.choice(("", "<!-- end -->"))


TEXTS = st.builds(random_text, st.randoms(use_true_random=False))


@PROPERTY
@given(TEXTS, STYLES)
def test_nothing_is_lost_and_once_is_enough(text: str, style: Style) -> None:
    data = text.encode()
    result = formatted(data, "a.launch", style)
    assert (result.problem, result.refusal) == (None, "")
    assert formatted(result.data, "a.launch", style).data == result.data
    assert held(result.data) == held(data)
    assert canonical(result.data) == canonical(data)


@PROPERTY
@given(TEXTS)
def test_tokens_joined_are_the_text(text: str) -> None:
    text = re.sub(r"\r\n?", "\n", text)
    found = tokens(text)
    assert "".join(token.text for token in found) == text
    assert [text[token.offset : token.offset + len(token.text)] for token in found] == [token.text for token in found]


@pytest.fixture(scope="module", autouse=True)
def evaluated_once(tmp_path_factory: pytest.TempPathFactory) -> None:
    """The evaluator raises Python's recursion limit when it is first used, and Hypothesis must not see that happen."""
    directory = tmp_path_factory.mktemp("once")
    (directory / MAIN).write_text("<launch/>")
    ours(Case({}, (), {}, {}), directory)


CASES = st.builds(random_case, st.randoms(use_true_random=False), st.just(0.3))


@settings(PROPERTY, max_examples=60)
@given(CASES)
def test_launch_files_mean_the_same(case: Case) -> None:
    with tempfile.TemporaryDirectory() as directory:
        write(case, Path(directory))
        before = ours(case, Path(directory))
        format_all(Path(directory))
        assert difference(before, ours(case, Path(directory))) == ""


@pytest.mark.ros
def test_launch_files_mean_the_same_to_roslaunch(ros_python: str, tmp_path: Path) -> None:
    cases = [(random_case(Random(seed), 0.3), tmp_path / str(seed)) for seed in range(60)]
    for case, directory in cases:
        write(case, directory)
    before = theirs(ros_python, cases)
    for _, directory in cases:
        format_all(directory)
    after = theirs(ros_python, cases)
    assert [difference(old, new) for old, new in zip(before, after, strict=True)] == [""] * len(cases)
    assert {answer["verdict"] for answer in before} == {"ok", "error"}


def format_all(directory: Path) -> None:
    """Bring every launch file of a directory into normal form; each of them has to change."""
    with inside(directory):
        for file in directory.rglob("*.launch"):
            data = file.read_bytes()
            result = formatted(data, str(file), Style())
            assert result.refusal == ""
            assert result.problem is not None or result.data != data or file.name != MAIN
            file.write_bytes(result.data)
