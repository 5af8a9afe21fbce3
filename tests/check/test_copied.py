"""Whose a package is: asked of the workspace that it lies in."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.rules.judging.kept_projects import kept_whole
from launchlint.rules.judging.projects import is_from_elsewhere
from launchlint.workspace.packages import Packages
from tests.cli.running import write

MANIFEST = """\
<package format="2"><name>{name}</name><version>1.0.0</version><description>x</description>
<maintainer email="{who}">x</maintainer><license>BSD</license>{more}</package>
"""
ADDRESS = '<url type="repository">https://github.com/ros-planning/navigation</url>'


@pytest.mark.parametrize("overlaid", [True, False])
def test_the_packages_of_a_workspace_that_is_overlaid_make_nothing_a_copy(tmp_path: Path, overlaid: bool) -> None:
    others = "under" if overlaid else "over/other"
    files = {
        "over/navigation/README.md": "", "over/navigation/LICENSE": "",
        "over/navigation/amcl/package.xml": MANIFEST.format(name="amcl", who="a@example.org", more=ADDRESS),
    }  # fmt: skip
    for number in range(6):
        files[f"{others}/own_{number}/package.xml"] = MANIFEST.format(name=f"own_{number}", who="b@example.org", more="")
    write(tmp_path, files)
    packages = Packages([str(tmp_path / "over"), str(tmp_path / "under")] if overlaid else [str(tmp_path / "over")], {}, explicit=True)
    home = packages.package_of(str(tmp_path / "over/navigation/amcl"))
    assert home is not None
    assert is_from_elsewhere(home, packages) is not overlaid
    assert bool(kept_whole(home, packages)) is not overlaid


@pytest.mark.parametrize("where", ["arms", "arms/.git", "list inside", "other people", "submodule"])
def test_what_a_list_of_sources_names_and_was_checked_in_is_another_project(tmp_path: Path, where: str) -> None:
    listed = "repositories:\n  arms:\n    type: git\n    url: https://example.org/arms.git\n"
    files = {
        "src/arms/arm/package.xml": MANIFEST.format(
            name="arm", who="b@example.org" if where == "other people" else "a@example.org", more=""
        ),
        "src/own/package.xml": MANIFEST.format(name="own", who="b@example.org", more=""),
    }
    if where == "submodule":
        files[".gitmodules"] = '[submodule "arms"]\n\tpath = src/arms\n'
    else:
        files["src/arms/robot.repos" if where == "list inside" else "robot.repos"] = listed
    if where == "arms/.git":
        files["src/arms/.git/HEAD"] = ""
    write(tmp_path, files)
    packages = Packages([str(tmp_path)], {}, explicit=True)
    home = packages.package_of(str(tmp_path / "src/arms/arm"))
    assert home is not None
    assert kept_whole(home, packages) == (str(tmp_path / "src/arms") if where == "arms" else "")
