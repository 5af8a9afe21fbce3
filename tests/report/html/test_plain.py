"""Text of others made plain."""

from __future__ import annotations

import pytest

from launchlint.report.html.plain import Plain


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("/home/me/ws/maps/a.yaml", "./maps/a.yaml"),
        ("map_server /home/me/ws/maps/a.yaml 0.1", "map_server ./maps/a.yaml 0.1"),
        ("/home/me/ws", "."),
        ("file:///home/me/ws/x", "file:///home/me/ws/x"),
        ("/home/me/ws2/x", "/home/me/ws2/x"),
        ("/mnt/home/me/ws/x", "/mnt/home/me/ws/x"),
        ("/srv/other/pkg/x", "../other/pkg/x"),
        ("a\u202eb\x1b[1m\ud800", "a\\u202eb\\x1b[1m\\ud800"),
        ("x" * 3_000, "x" * 1_999 + "…"),
    ],
)
def test_text(text: str, shown: str) -> None:
    assert Plain([("/home/me/ws", "."), ("/srv/other", "../other"), ("/", "nothing")]).text(text) == shown


def test_names_are_not_paths() -> None:
    assert Plain([("/robot", ".")]).name("/robot/scan") == "/robot/scan"


def test_endless_names_are_cut() -> None:
    assert Plain().name("/" + "n" * 1_000_000) == "/" + "n" * 398 + "…"


def test_a_source_line_keeps_its_columns() -> None:
    assert Plain.line('\t<node name="a\u202eb\x07c"/>') == '\t<node name="a\ufffdb\ufffdc"/>'
