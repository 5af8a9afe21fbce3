"""What lies in a submodule that is not checked out."""

from pathlib import Path

import pytest

from launchlint.workspace.submodules import missing_submodule


@pytest.fixture
def top(tmp_path: Path) -> Path:
    (tmp_path / ".gitmodules").write_text(
        '[submodule "x"]\n\tpath = src/x\n[submodule "y"]\n\tpath = src/y\n[submodule "z"]\n\tpath = ../z\n'
    )
    (tmp_path / "src/x").mkdir(parents=True)
    return tmp_path


def test_an_empty_and_an_absent_directory_are_not_checked_out(top: Path) -> None:
    assert missing_submodule(f"{top}/src/x/launch/a.launch") == f"{top}/src/x"
    assert missing_submodule(f"{top}/src/y/a.launch") == f"{top}/src/y"


def test_one_that_holds_files_is_checked_out(top: Path) -> None:
    (top / "src/x/package.xml").write_text("")
    assert missing_submodule(f"{top}/src/x/launch/a.launch") is None


def test_other_paths_and_paths_out_of_the_repository_are_no_submodules(top: Path) -> None:
    assert missing_submodule(f"{top}/src/xx/a.launch") is None
    assert missing_submodule(f"{top}/src/a.launch") is None
    assert missing_submodule(f"{top.parent}/z/a.launch") is None


def test_the_search_ends_at_the_top_of_a_repository(top: Path) -> None:
    (top / "src/other/.git").mkdir(parents=True)
    (top / ".gitmodules").write_text('[submodule "o"]\n\tpath = src/other/deep\n')
    assert missing_submodule(f"{top}/src/other/deep/a.launch") is None
