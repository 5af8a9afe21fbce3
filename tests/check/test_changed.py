"""Which entry files have to be compared with a revision at all."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from launchlint.check.changed import Changed, changed

FILES = {"a/one.launch": "1", "a/two.launch": "2", "package.xml": "p", "config/base.yaml": "y", "src/node.cpp": "c", "README.md": "r"}


@pytest.fixture
def trees(tmp_path: Path) -> tuple[Path, Path]:
    """A working tree and a revision of it, the same so far."""
    for name in ("now", "then"):
        for file, text in FILES.items():
            path = tmp_path / name / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        os.symlink("one.launch", tmp_path / name / "a/link.launch")
    return tmp_path / "now", tmp_path / "then"


def found(trees: tuple[Path, Path]) -> tuple[list[str], bool]:
    result = changed(str(trees[0]), str(trees[1]))
    assert isinstance(result, Changed)
    return sorted(os.path.relpath(file, trees[0]) for file in result.launch_files), result.others


def test_nothing(trees: tuple[Path, Path]) -> None:
    assert found(trees) == ([], False)


def test_launch_files_that_are_new_or_not_the_same(trees: tuple[Path, Path]) -> None:
    (trees[0] / "a/one.launch").write_text("x", encoding="utf-8")
    (trees[0] / "new.launch").write_text("x", encoding="utf-8")
    assert found(trees) == (["a/one.launch", "new.launch"], False)


@pytest.mark.parametrize("file", ["src/node.cpp", "README.md", "map.pgm", "lib.json", ".git/index"])
def test_what_no_launch_file_is_made_of(trees: tuple[Path, Path], file: str) -> None:
    (trees[0] / file).parent.mkdir(exist_ok=True)
    (trees[0] / file).write_text("other", encoding="utf-8")
    assert found(trees) == ([], False)


@pytest.mark.parametrize("file", ["config/base.yaml", "package.xml", "new/package.xml", "new.yaml", "without_an_end"])
def test_what_may_matter_to_any(trees: tuple[Path, Path], file: str) -> None:
    (trees[0] / file).parent.mkdir(exist_ok=True)
    (trees[0] / file).write_text("other", encoding="utf-8")
    assert found(trees) == ([], True)


def test_what_went_may_matter_to_any(trees: tuple[Path, Path]) -> None:
    (trees[0] / "a/two.launch").unlink()
    assert found(trees) == ([], True)


def test_links_that_lead_elsewhere(trees: tuple[Path, Path]) -> None:
    (trees[0] / "a/link.launch").unlink()
    os.symlink("two.launch", trees[0] / "a/link.launch")
    assert found(trees) == ([], True)
