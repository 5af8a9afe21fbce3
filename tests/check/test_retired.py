"""Which directories are for what somebody put aside, and what becomes of findings in them."""

from pathlib import Path

import pytest

from launchlint.check.gathered import Shown
from launchlint.check.known import Known
from launchlint.check.retired import judged_by_place
from launchlint.finding import Finding, Location, Severity
from launchlint.rules.view import EntrySummary
from launchlint.workspace.packages import Packages
from launchlint.workspace.put_aside import renamed_manifest


def severity(path: str, *, included: tuple[str, ...] = (), entry: str = "launch/robot.launch", seen_by: str = "") -> Severity:
    """The level of an error in ``path`` after it has been judged; ``entry`` includes ``included``, and ``seen_by`` shows the error."""
    finding = Finding("LL101", "malformed-xml", Severity.ERROR, Location(path, 1, 1, 1, 2, 0, 1, "x"), "broken")
    shown = {finding.key: Shown((seen_by,), by_default=False)} if seen_by else {}
    known = Known(Packages((), {}, explicit=True), "", shown, (EntrySummary(entry, False, included, (), ()),))
    (judged,) = judged_by_place([finding], known)
    assert bool(judged.notes) == (judged.severity is not finding.severity)
    return judged.severity


@pytest.mark.parametrize(
    "directory",
    [
        "old",
        "Deprecated",
        "doc/discontinued",
        "launch/obsolete",
        "src/archive",
        "backup",
        "worlds_backup",
        "launch.bak",
        "launch_bkp",
        "unused",
        "old_launch_files",
        "x-deprecated",
    ],
)
def test_directories_for_what_was_put_aside(directory: str) -> None:
    assert severity(f"{directory}/robot.launch") is Severity.INFO


@pytest.mark.parametrize(
    "directory", ["launch", "backup_camera", "discontinuous_control", "archive_tools", "household", "oldenburg", "threshold", "robot.old.d"]
)
def test_directories_for_what_is_used(directory: str) -> None:
    assert severity(f"{directory}/robot.launch") is Severity.ERROR


def test_a_file_called_old_lies_in_no_such_directory() -> None:
    assert severity("launch/old") is Severity.ERROR


def test_what_others_include_is_used() -> None:
    assert severity("old/part.launch", included=("old/part.launch",)) is Severity.ERROR
    assert severity("old/part.launch", included=("old/part.launch",), entry="old/all.launch") is Severity.INFO


def test_what_an_entry_elsewhere_shows_matters() -> None:
    assert severity("old/params.yaml", seen_by="launch/robot.launch") is Severity.ERROR
    assert severity("old/params.yaml", seen_by="old/robot.launch") is Severity.INFO


def test_a_package_is_used_where_a_file_of_it_is() -> None:
    assert severity("old/robot/package.xml", included=("old/robot/launch/a.launch",)) is Severity.ERROR
    assert severity("old/robot/package.xml", included=("old/robots/launch/a.launch",)) is Severity.INFO


@pytest.mark.parametrize("name", ["unusedmanifest.xml", "manifest.xml~", "package.xml.bak", "old_package.xml", "_package.xml"])
def test_a_renamed_manifest_puts_a_directory_aside(name: str, tmp_path: Path) -> None:
    (tmp_path / "maps/launch").mkdir(parents=True)
    (tmp_path / "maps" / name).touch()
    assert renamed_manifest(str(tmp_path / "maps")) == name
    assert renamed_manifest(str(tmp_path / "maps/launch")) == ""
    (tmp_path / "maps/package.xml").touch()
    assert renamed_manifest(str(tmp_path / "maps")) == ""


@pytest.mark.parametrize("name", ["package.xml.in", "package_ros2.xml", "package.xml.em", "plugin.xml", "model_manifest.xml"])
def test_templates_and_other_files_are_no_renamed_manifests(name: str, tmp_path: Path) -> None:
    (tmp_path / name).touch()
    assert renamed_manifest(str(tmp_path)) == ""
