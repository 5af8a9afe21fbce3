"""Addresses of lines."""

from __future__ import annotations

import pytest

from launchlint.errors import UsageError
from launchlint.report.html.links import checked_prefix, source_link

PREFIX = "https://github.com/o/r/blob/main/"


@pytest.mark.parametrize(
    ("path", "address"),
    [
        ("launch/a.launch", f"{PREFIX}launch/a.launch#L7"),
        ('a b/"<ü>?#.launch', f"{PREFIX}a%20b/%22%3C%C3%BC%3E%3F%23.launch#L7"),
        ("it's(1)!*.launch", f"{PREFIX}it's(1)!*.launch#L7"),
        ("../other/a.launch", ""),
        ("/opt/ros/noetic/a.launch", ""),
    ],
)
def test_link(path: str, address: str) -> None:
    assert source_link(PREFIX, path, 7) == address


def test_no_prefix_no_link() -> None:
    assert source_link("", "a.launch", 1) == ""


def test_prefix_ends_with_one_slash() -> None:
    assert checked_prefix("https://example.org/tree//") == "https://example.org/tree/"


NO_ADDRESSES = (
    "javascript:alert(1)",
    "data:text/html,x",
    "//example.org/",
    "https://",
    "https://e.org/?a=",
    "https://e.org/#",
    'https://e.org/"',
    "https://[x/",
)


@pytest.mark.parametrize("text", NO_ADDRESSES)
def test_what_is_no_address(text: str) -> None:
    with pytest.raises(UsageError) as told:
        checked_prefix(text)
    assert str(told.value) == (
        f"--source-url {text}: give the http or https address below which the files are, such as https://github.com/OWNER/REPOSITORY/blob/main"
    )
