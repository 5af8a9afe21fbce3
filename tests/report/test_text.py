"""The text format in detail: carets, colours, cut lines, the last line, statistics."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as some

from launchlint.finding import Finding, Location, Severity
from launchlint.report import text
from launchlint.report.run import Run
from launchlint.report.snippet import Snippet, snippet
from launchlint.source import Place, Source, Span


def test_colours(plain: list[Finding], run: Run, snapshot: Callable[[str, str], None]) -> None:
    snapshot("plain.color.txt", text.render(plain, run._replace(color=True)).replace("\x1b", "<ESC>"))


def shown(line: str, start: int, end: int, width: int = 80) -> list[str]:
    """The two lines under test, for a span of a one-line file."""
    found = snippet(Location.of(Place(Source("a", line), Span(start, end))), width)
    assert found is not None
    return [found.line, " " * found.indent + "^" * found.carets]


@pytest.mark.parametrize(
    ("line", "start", "end", "expected"),
    [
        ("abcdef", 2, 4, ["abcdef", "  ^^"]),
        ("abcdef", 6, 6, ["abcdef", "      ^"]),
        ("abcdef", 0, 0, ["abcdef", "^"]),
        ("\ta\tb", 3, 4, ["    a   b", "        ^"]),
        ("a\tbc", 1, 2, ["a   bc", " ^^^"]),
        ("表示=b", 0, 2, ["表示=b", "^^^^"]),
        ("表示=b", 3, 4, ["表示=b", "     ^"]),
        ("e\u0301x", 2, 3, ["e\u0301x", " ^"]),
        ("a\x1b[31mb", 6, 7, ["a\\x1b[31mb", "         ^"]),
        ("a\u202eb", 1, 2, ["a\\u202eb", " ^^^^^^"]),
        ("##[x", 3, 4, ["##\\x5bx", "      ^"]),
        ("a  ", 0, 1, ["a", "^"]),
    ],
)
def test_carets_stand_below_what_they_mean(line: str, start: int, end: int, expected: list[str]) -> None:
    assert shown(line, start, end) == expected


def test_a_long_line_is_cut_around_the_carets() -> None:
    line = "0123456789" * 20
    assert shown(line, 0, 2, 40) == ["012345678901234567890123456789012345678…", "^^"]
    assert shown(line, 100, 105, 40) == ["…7890123456789" + "0123456789012345678901234…", " " * 14 + "^^^^^"]
    assert shown(line, 198, 200, 40) == ["…" + line[162:], " " * 37 + "^^"]
    assert shown(line, 50, 150, 40) == ["…7890123456789" + "0123456789012345678901234…", " " * 14 + "^" * 25]


def test_nothing_to_show() -> None:
    assert snippet(Location("a", 1, 1, 1, 1, 0, 0, ""), 80) is None
    assert snippet(Location("a", 9, 1, 9, 1, 0, 0, " \t "), 80) is None


def test_a_line_of_megabytes_costs_nothing() -> None:
    location = Location("a", 1, 25_000_001, 1, 49_000_000, 25_000_000, 49_000_000, "x" * 50_000_000)
    assert snippet(location, 40) == Snippet("…" + "x" * 38 + "…", 14, 25)


@given(some.text(max_size=60), some.integers(0, 60), some.integers(0, 60), some.integers(0, 90))
def test_a_snippet_fits_and_shows_no_control_characters(line: str, start: int, length: int, width: int) -> None:
    at = Location("a", 1, start + 1, 1, start + length + 1, start, start + length, line)
    found = snippet(at, width)
    if found is None:
        assert not line.strip()
    else:
        assert all(character.isprintable() or character == "\u3000" for character in found.line)
        assert found.carets >= 1
        assert found.indent >= 0
        assert found.indent + found.carets <= max(width, 40) + 1


E_, W_, I_ = Severity.ERROR, Severity.WARNING, Severity.INFO


@pytest.mark.parametrize(
    ("severities", "verbose", "files", "expected"),
    [
        ([], False, 12, "no problems in 12 launch files"),
        ([], False, 0, "no launch files to check"),
        ([E_, E_, E_, W_, I_, I_], False, 12, "3 errors, 1 warning in 12 launch files (2 infos hidden, -v shows them)"),
        ([E_, W_, W_, I_], True, 1, "1 error, 2 warnings, 1 info in 1 launch file"),
        ([I_], False, 2, "no problems in 2 launch files (1 info hidden, -v shows it)"),
    ],
)
def test_last_line(severities: list[Severity], verbose: bool, files: int, expected: str, plain: list[Finding], run: Run) -> None:
    findings = [plain[0]._replace(severity=severity) for severity in severities]
    assert text.summary(findings, run._replace(files_checked=files, verbose=verbose)) == expected


def test_statistics(plain: list[Finding]) -> None:
    assert text.statistics([*plain, *plain[:1] * 9]) == (
        "10  LL301  duplicate-node-name     error\n"
        " 2  LL605  remap-identity          info\n"
        " 1  LL101  malformed-xml           error\n"
        " 1  LL110  conflicting-attributes  error\n"
        " 1  LL206  unused-arg              warning\n"
        " 1  LL302  invalid-node-name       warning\n"
        " 1  LL404  include-missing-arg     error\n"
        " 1  LL501  param-value-type        error\n"
    )
    assert text.statistics([]) == ""


def test_a_long_include_chain_is_cut(plain: list[Finding], run: Run) -> None:
    steps = tuple(plain[0].location._replace(path=f"{number}.launch") for number in range(10))
    lines = text.render([plain[5]._replace(chain=steps)], run).splitlines()
    assert [line.strip(" =") for line in lines if "included" in line] == [
        *(f"included from {number}.launch:9:36" for number in range(9, 1, -1)),
        "included through 2 more files",
    ]


def test_the_command_is_quoted_for_a_shell(plain: list[Finding]) -> None:
    def command(entry: str, *arguments: tuple[str, str]) -> str:
        return text.command(plain[0]._replace(entry=entry, arguments=arguments))

    assert command("") == ""
    assert command("my robot.launch", ("a", ""), ("b", "it's")) == """roslaunch 'my robot.launch' a:= 'b:=it'"'"'s'"""
    assert command("-x.launch", ("a", "$(rm -rf /)")) == "roslaunch ./-x.launch 'a:=$(rm -rf /)'"
    assert command("a\n'b\udcff.launch") == r"roslaunch $'a\n\'b\xff.launch'"
