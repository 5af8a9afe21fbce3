"""GitHub's line fingerprint. The expected values were made with the code of GitHub's upload action itself."""

from __future__ import annotations

import pytest

from launchlint.report.line_hash import line_hashes


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"", {1: "c129715d7a2bc9a3:1"}),
        (
            b'<launch>\n  <node pkg="a" type="b" name="c"/>\r\n\t<node pkg="a" type="b" name="c"/>\r\r \n</launch>\n',
            {
                1: "14188b3ba2878a46:1",
                2: "796a784a2cdb8167:1",
                3: "5612aa130dee9058:1",
                4: "3c3679a66ec4f9b5:1",
                5: "bbbf6f08035784bf:1",
                6: "2a8ae6227c859d31:1",
                7: "c129715d7a2bc9a3:1",
            },
        ),
        ("😀 表\n\ufeffx".encode(), {1: "4cc78005f459cf51:1", 2: "5ebfb2fd68a495b6:1"}),
        (b"\xe2\x82a\n\xff\xfe\n", {1: "bb8054665c79b3af:1", 2: "b94e3e336a503d4f:1", 3: "c129715d7a2bc9a3:1"}),
    ],
)
def test_all_lines(content: bytes, expected: dict[int, str]) -> None:
    assert line_hashes(content, set(range(1, 20))) == expected


def test_equal_windows_are_numbered() -> None:
    """Of thirty equal lines the last ones differ, since the end of the file is in their window."""
    assert line_hashes(b"<a/>\n" * 30, {1, 2, 11, 12, 30, 99}) == {
        1: "e56197fe9f9360c0:1",
        2: "e56197fe9f9360c0:2",
        11: "e56197fe9f9360c0:11",
        12: "e561981b3167f23f:1",
        30: "3835bcde91a4e8e7:1",
    }


def test_no_lines() -> None:
    assert line_hashes(b"<launch/>", set()) == {}
