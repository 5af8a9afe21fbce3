"""Sources that a repository names and does not hold."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.packages import Packages
from launchlint.workspace.source_lists import folded, is_source_list, read_source_lists


def found(directory: Path, name: str, text: str) -> list[str]:
    (directory / name).write_text(text)
    return sorted(read_source_lists([str(directory)]))


@pytest.mark.parametrize(
    ("name", "text", "names"),
    [
        (".gitmodules", '[submodule "x"]\n\tpath = lib/Fast-Lio\n\turl = git@host:me/other.git\n', ["fast_lio", "other"]),
        (".gitmodules", "[submodule \"x\"]\n#\tpath = lib/lio\n;\turl = git@host:me/other.git\n", []),
        (".gitmodules", "url = host:other.git/\n", ["other"]),
        ("a.rosinstall", "- git:\n    local-name: a/lio\n    uri: 'https://host/x.git'\n    version: lio2\n", ["lio", "x"]),
        ("a.rosinstall", "- git: {local-name: lio, uri: \"https://host/x\"}\n", ["lio", "x"]),
        ("a.rosinstall.noetic", "- tar:\n    local-name: lio\n", ["lio"]),
        (".rosinstall", "-   other: {local-name: /opt/lio/}\n", ["lio"]),
        ("a.repos", "repositories:\n  a/lio:  # fine\n    type: git\n    url: https://host/x\n    version: v\n", ["lio", "x"]),
        ("a.repos", "\0\ufffd{{{:::\n", []),
        ("a.yaml", "- git:\n    local-name: a/lio\n", []),
    ],
)  # fmt: skip
def test_names_of_sources(tmp_path: Path, name: str, text: str, names: list[str]) -> None:
    assert found(tmp_path, name, text) == names
    assert is_source_list(name) == (name != "a.yaml")


def test_lists_in_hidden_directories_do_not_count(tmp_path: Path) -> None:
    for directory in (".hidden", "shown"):
        (tmp_path / directory).mkdir()
        found(tmp_path / directory, "a.rosinstall", f"- git: {{local-name: {directory}}}\n")
    assert read_source_lists([str(tmp_path)]) == {"shown": str(tmp_path / "shown/a.rosinstall")}


def test_a_list_that_cannot_be_read_is_passed_over(tmp_path: Path) -> None:
    (tmp_path / "a.rosinstall").mkdir()
    (tmp_path / "b.rosinstall").symlink_to("nowhere")
    assert read_source_lists([str(tmp_path)]) == {}


def test_what_is_checked_out_is_not_only_listed(tmp_path: Path) -> None:
    (tmp_path / "a.rosinstall").write_text("- git: {local-name: arm}\n- git: {local-name: leg-x}\n")
    (tmp_path / "arm/arm_core").mkdir(parents=True)
    (tmp_path / "arm/arm_core/package.xml").write_text("<package><name>arm_core</name></package>")
    packages = Packages([str(tmp_path)], {}, explicit=True)
    assert packages.listed_in("leg_x") == str(tmp_path / "a.rosinstall")
    assert packages.listed_in("arm") is None
    assert packages.listed_in("tail") is None
    assert folded("Leg-X") == "leg_x"
