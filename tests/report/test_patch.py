"""Unified diffs for people."""

from __future__ import annotations

from launchlint.report.patch import unified


def test_nothing_differs() -> None:
    assert unified("a.launch", "a\nb\n", "a\nb\n", color=True) == ""


def test_lines_and_the_end_of_the_file() -> None:
    assert unified("a.launch", "a\nb\nc", "a\nB\nc\n", color=False) == (
        "--- a/a.launch\n+++ b/a.launch\n@@ -1,3 +1,3 @@\n a\n-b\n-c\n\\ No newline at end of file\n+B\n+c\n"
    )


def test_an_empty_side() -> None:
    assert unified("a.launch", "", "a\n", color=False) == "--- a/a.launch\n+++ b/a.launch\n@@ -0,0 +1 @@\n+a\n"


def test_line_ends_are_those_of_the_file_only_and_hostile_characters_are_shown() -> None:
    assert unified("\x1b[2J", "a\u2028b\r\n\x1b]0;x\x07\n", "a\tb\n", color=False) == (
        "--- a/\\x1b[2J\n+++ b/\\x1b[2J\n@@ -1,2 +1 @@\n-a\\u2028b\\r\n-\\x1b]0;x\\x07\n+a\tb\n"
    )


def test_colors() -> None:
    assert unified("a", "x\ny\n", "x\nz\n", color=True).splitlines() == [
        "\x1b[1m--- a/a\x1b[0m",
        "\x1b[1m+++ b/a\x1b[0m",
        "\x1b[36m@@ -1,2 +1,2 @@\x1b[0m",
        " x",
        "\x1b[31m-y\x1b[0m",
        "\x1b[32m+z\x1b[0m",
    ]


def test_a_removed_line_of_dashes_is_no_header() -> None:
    assert unified("a", "-- x\n", "y\n", color=True).splitlines()[3:] == ["\x1b[31m--- x\x1b[0m", "\x1b[32m+y\x1b[0m"]
