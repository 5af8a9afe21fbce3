"""Names that are the same but for what lies between their letters."""

from __future__ import annotations

import pytest

from launchlint.spelling import same_letters


@pytest.mark.parametrize(
    ("name", "names", "same"),
    [
        ("semis_dr.py", ["semis.py", "semis dr.py"], "semis dr.py"),
        ("to_vector.py", ["to_vector_test.py"], "to_vector_test.py"),
        ("drive_node", ["drive"], "drive"),
        ("grab_it.py", ["grab-it.py"], "grab-it.py"),
        ("drive_test", ["drive_node"], None),
        ("drive1", ["drive2"], None),
        ("drive.py", ["drive.cpp"], None),
        ("grab_it", ["grab-it", "grabit"], None),
        ("_", ["-"], None),
        ("drive", ["drive"], None),
    ],
)
def test_same_letters(name: str, names: list[str], same: str | None) -> None:
    assert same_letters(name, names) == same
