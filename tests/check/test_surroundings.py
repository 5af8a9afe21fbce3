"""What the name of a cache's database says of what is on disk."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.check.options import Options
from launchlint.check.surroundings import Surroundings
from launchlint.workspace.contents import Contents
from launchlint.workspace.looking import state
from launchlint.workspace.packages import Packages
from tests.cli.running import PACKAGE, write


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    write(tmp_path, {"arm/package.xml": PACKAGE.format(name="arm"), "arm/config/a.yaml": "a: 1\n", "arm/.git/HEAD": ""})
    return tmp_path


def surroundings(workspace: Path) -> Surroundings:
    places = (str(workspace),)
    held = Contents(f"{workspace}.contents")
    return Surroundings(Options(frozenset(), places, True, {}, str(workspace)), Packages(places, {}, explicit=True), held, "")


@pytest.mark.parametrize(
    ("path", "says"),
    [
        ("arm", True),
        ("arm/package.xml", True),
        ("arm/config", True),
        ("arm/config/b.yaml", True),
        ("arm/nowhere", True),
        ("arm/config/a.yaml", False),  # its content
        ("arm/nowhere/a.yaml", True),
        ("arm/config/a.yaml/b", True),  # below a file
        (f"arm/{'a/' * 3000}b", False),  # longer than any path
        ("arm/.git", False),  # what is in it
        ("arm/.git/config", False),
        ("..", False),
    ],
)
def test_what_it_says(workspace: Path, path: str, says: bool) -> None:
    file = str(workspace / path)
    assert surroundings(workspace).say(file, state(file)) is says


def test_what_was_seen_later_is_not_said(workspace: Path) -> None:
    before = surroundings(workspace)
    write(workspace, {"arm/package.xml": PACKAGE.format(name="leg"), "arm/config/b.yaml": ""})
    for path in ("arm/package.xml", "arm/config", "arm/config/b.yaml"):
        file = str(workspace / path)
        assert not before.say(file, state(file))
        assert surroundings(workspace).say(file, state(file)) is not path.endswith(".yaml")


def test_a_link_that_leads_nowhere_is_not_said_to_be_nothing(workspace: Path) -> None:
    link = workspace / "arm" / "link"
    link.symlink_to("nowhere")
    assert state(str(link)) == ""
    assert not surroundings(workspace).say(str(link), "")
