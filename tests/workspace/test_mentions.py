"""Names of packages in the documents and launch files of a workspace."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.looking import noted
from launchlint.workspace.mentions import read_documents


@pytest.mark.parametrize(
    ("text", "known"),
    [
        ("get my_bridge first", ["my_bridge"]),
        ("`bridge` and bridge", ["bridge"]),
        ("https://example.com/robots/bridge.git", ["bridge"]),
        ("see https://example.com/robots/bridge", ["bridge"]),
        ("# my_bridge\nmy_arm\n------\n- my_camera\n", ["my_camera"]),
        ("my_bridge_2, not-my_bridge, a_b and bridge", ["my_bridge_2"]),
    ],
)
def test_a_name_in_a_readme(tmp_path: Path, text: str, known: list[str]) -> None:
    (tmp_path / "README.md").write_text(text)
    assert sorted(read_documents([str(tmp_path)]).known) == known


def test_which_files_are_documents(tmp_path: Path) -> None:
    for file in ("README", "docs/a.rst", "notes.md", "docs/a.py", "docs/below/b.md", ".hidden/README.md"):
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).write_text(f"see in_{(tmp_path / file).stem.lower()}_{file.replace('/', '_').replace('.', '_')}")
    noted()
    found = read_documents([str(tmp_path)])
    expected = [str(tmp_path / each) for each in ("README", "docs/a.rst", "docs/below/b.md")]
    assert sorted(found.known.values()) == expected
    assert set(expected) <= found.looked <= set(noted().all())
