"""``launchlint report`` as a user runs it."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from tests.cli.running import DOUBLE, run
from tests.report.html.pages import data_of

GIT = ("git", "-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false")

NO_ADDRESS = "give the http or https address below which the files are, such as https://github.com/OWNER/REPOSITORY/blob/main"


def git(directory: Path, *words: str) -> str:
    return subprocess.run([*GIT, *words], cwd=directory, check=True, capture_output=True, text=True).stdout.strip()


@pytest.fixture
def tracked(repository: Path) -> Path:
    """The repository, in git, with one commit."""
    (repository / ".git" / "HEAD").unlink()
    (repository / ".git").rmdir()
    git(repository, "init", "-q")
    git(repository, "add", "-A")
    git(repository, "commit", "-q", "-m", "first")
    return repository


def test_it_writes_a_page_and_says_so(repository: Path) -> None:
    ran = run(repository, "report")
    found = "1 error, 1 warning in 3 launch files; of 3 entry files 2 load, 1 is refused by roslaunch; 4 of 4 nodes known"
    assert ran == (0, "", f"launchlint: wrote report.html: {found}\n")
    assert data_of((repository / "report.html").read_text(encoding="utf-8"))["title"] == "repository"


def test_standard_output(repository: Path) -> None:
    ran = run(repository, "report", "-o", "-", "demo/launch/clean.launch")
    assert (ran.status, ran.errors) == (0, "")
    assert ran.output.startswith('<!DOCTYPE html>\n<html lang="en">\n')
    assert data_of(ran.output)["title"] == "clean.launch"


def test_standard_input(repository: Path) -> None:
    ran = run(repository, "report", "-q", "-o", "-", "-", "--stdin-filename", "demo/launch/new.launch", stdin=DOUBLE)
    assert [(each["rule"], each["place"]) for each in data_of(ran.output)["findings"]] == [("LL301", [0, 3, 15])]


@pytest.mark.parametrize(("level", "status"), [("error", 1), ("warning", 1), ("info", 1)])
def test_fail_on_makes_findings_fail_and_the_page_is_written_all_the_same(repository: Path, level: str, status: int) -> None:
    assert run(repository, "report", "-q", "--fail-on", level).status == status
    assert (repository / "report.html").is_file()


def test_fail_on_without_findings_that_bad(repository: Path) -> None:
    assert run(repository, "report", "-q", "--fail-on", "error", "demo/launch/unused.launch").status == 0


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (
            ("-o", "no/such/page.html"),
            "cannot write the page to 'no/such/page.html': the directory 'no/such' does not exist; create it first",
        ),
        (("-o", "demo"), "cannot write the page to 'demo': it is a directory; give the name of a file"),
        (("--separate-assets", "-o", "-"), "--separate-assets writes files beside the page; name the page with -o"),
        (("--fail-on", "bad"), "--fail-on: bad is no severity; write error, warning or info"),
        (
            ("--source-url", "javascript:alert(1)"),
            f"--source-url javascript:alert(1): {NO_ADDRESS}",
        ),
    ],
)
def test_wrong_usage(repository: Path, words: tuple[str, ...], told: str) -> None:
    assert run(repository, "report", *words) == (2, "", f"launchlint: {told}\n")
    assert not (repository / "report.html").exists()


def test_the_same_bytes_for_any_jobs_and_hash_seed(repository: Path) -> None:
    for number in range(50):
        (repository / "demo" / "launch" / f"copy{number}.launch").write_text(DOUBLE, encoding="utf-8")
    for seed, jobs in (("1", "1"), ("2", "3")):
        ran = run(repository, "report", "-o", f"{seed}.html", "--jobs", jobs, environment={"PYTHONHASHSEED": seed})
        assert ran.status == 0, ran.errors
    assert (repository / "1.html").read_bytes() == (repository / "2.html").read_bytes()


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        ({}, "https://github.example/o/r/blob/{head}/"),
        ({"GITHUB_SHA": "0" * 40}, None),
        ({"GITHUB_REPOSITORY": ""}, None),
    ],
)
def test_links_on_githubs_runners_if_their_commit_is_checked_out(tracked: Path, variables: dict[str, str], expected: str | None) -> None:
    head = git(tracked, "rev-parse", "HEAD")
    environment = {"GITHUB_SERVER_URL": "https://github.example", "GITHUB_REPOSITORY": "o/r", "GITHUB_SHA": head, **variables}
    page = run(tracked, "report", "-o", "-", environment=environment).output
    assert data_of(page)["sourceUrl"] == (None if expected is None else expected.format(head=head))


def test_links_from_within_a_directory_of_the_repository(tracked: Path) -> None:
    page = run(tracked / "demo", "report", "-o", "-", "--source-url", "https://example.org/r").output
    assert data_of(page)["sourceUrl"] == "https://example.org/r/demo/"


def test_base_shows_both_states(tracked: Path) -> None:
    launch = tracked / "demo" / "launch"
    (launch / "clean.launch").write_text(
        '<launch>\n\n  <node name="speaker" pkg="demo" type="talk.py"/>\n  <param name="new" value="1"/>\n</launch>\n', encoding="utf-8"
    )
    (launch / "double.launch").unlink()
    (launch / "fresh.launch").write_text('<launch><node name="fresh" pkg="demo" type="talk.py"/></launch>', encoding="utf-8")
    data = data_of(run(tracked, "report", "-o", "-", "--base", "HEAD").output)

    def place(at: list[int]) -> str:
        return f"{data['files'][at[0]]}:{at[1]}{' at HEAD' if at[0] in data['baseFiles'] else ''}"

    shown = [
        (
            data["files"][entry["file"]],
            entry.get("mark", ""),
            [(each["name"], each.get("mark", ""), place(each["place"])) for each in entry["nodes"]],
        )
        for entry in data["entries"]
    ]
    assert data["base"] == "HEAD"
    assert shown == [
        (
            "demo/launch/clean.launch",
            "",
            [("/speaker", "added", "demo/launch/clean.launch:3"), ("/talker", "removed", "demo/launch/clean.launch:2 at HEAD")],
        ),
        ("demo/launch/fresh.launch", "added", [("/fresh", "added", "demo/launch/fresh.launch:1")]),
        (
            "demo/launch/double.launch",
            "removed",
            [("/talker", "removed", "demo/launch/double.launch:2 at HEAD"), ("/talker", "removed", "demo/launch/double.launch:3 at HEAD")],
        ),
        ("demo/launch/unused.launch", "", [("/talker", "", "demo/launch/unused.launch:3")]),
    ]
    assert [(each["name"], each.get("mark", "")) for each in data["entries"][0]["params"]] == [("/new", "added")]
    old = next(each for each in data["lines"] if each["file"] == data["baseFiles"][0])
    assert old["lines"] == [[2, '  <node name="talker" pkg="demo" type="talk.py"/>']]


def test_that_the_revision_lies_elsewhere_is_no_change(tracked: Path) -> None:
    launch = tracked / "demo" / "launch"
    text = '<launch>{}<param name="map" value="$(find demo)/map.yaml"/><include file="$(find demo)/launch/clean.launch"/></launch>'
    (launch / "map.launch").write_text(text.format(""), encoding="utf-8")
    git(tracked, "add", "-A")
    git(tracked, "commit", "-q", "-m", "map")
    (launch / "map.launch").write_text(text.format('<param name="new" value="1"/>'), encoding="utf-8")
    (tracked / "elsewhere").mkdir()
    words = ("report", "-o", "-", "--base", "HEAD", "--workspace", "..", "../demo/launch/map.launch")
    data = data_of(run(tracked / "elsewhere", *words).output)
    (entry,) = data["entries"]
    assert [(each["name"], each["value"], each.get("mark", "")) for each in entry["params"]] == [
        ("/map", "../demo/map.yaml", ""),
        ("/new", "1", "added"),
    ]
    assert [(each["label"], each.get("mark", "")) for each in entry["containers"]] == [("../demo/launch/clean.launch", "")]
    assert data["files"] == ["../demo/launch/map.launch", "../demo/launch/clean.launch"]


def test_no_such_revision(tracked: Path) -> None:
    ran = run(tracked, "report", "--base", "nowhere")
    assert ran.status == 2
    assert ran.errors.startswith("launchlint: nowhere is no revision of the git repository ")


def test_a_missing_file_that_was_missing_before_is_not_new(tracked: Path) -> None:
    launch = tracked / "demo" / "launch" / "clean.launch"
    line = '<node name="view" pkg="demo" type="talk.py" args="-d $(find demo)/config/{}.yaml"/>'
    (tracked / "demo" / "config").mkdir(exist_ok=True)
    (tracked / "demo" / "config" / "other.yaml").write_text("{}\n", encoding="utf-8")
    launch.write_text(f"<launch>\n{line.format('missing')}\n</launch>\n", encoding="utf-8")
    git(tracked, "add", "-A")
    git(tracked, "commit", "-q", "-m", "second")
    launch.write_text(f"<launch>\n\n{line.format('missing')}\n</launch>\n", encoding="utf-8")
    data = data_of(run(tracked, "report", "-o", "-", "--base", "HEAD", "--select", "LL411", "demo/launch/clean.launch").output)
    assert [(each["message"], each.get("since", "")) for each in data["findings"]] == [
        ("the file demo/config/missing.yaml does not exist", "")
    ]
    assert data["fixed"] == []


COPIED = """\
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="cam"/>
  <node pkg="image_view" type="image_view" name="view"><remap from="image" to="/cam/image_{}"/></node>
</launch>
"""


def test_one_place_of_several_that_is_mended_or_made_is_what_is_told(tracked: Path) -> None:
    first, *others = (tracked / "demo" / "launch" / f"{name}.launch" for name in "abc")
    for each in (first, *others):
        each.write_text(COPIED.format("rw"), encoding="utf-8")
    git(tracked, "add", "-A")
    git(tracked, "commit", "-q", "-m", "three mistakes")
    first.write_text(COPIED.format("raw"), encoding="utf-8")

    def compared() -> tuple[list[tuple[object, ...]], list[object], dict[str, int]]:
        data = data_of(run(tracked, "report", "-o", "-", "--base", "HEAD", "--select", "LL612", "demo/launch").output)
        findings = [
            (data["files"][each["place"][0]], each["message"].partition("(")[2], each.get("since", "")) for each in data["findings"]
        ]
        entries = {data["files"][each["file"]]: len(each["findings"]) for each in data["entries"]}
        return findings, [data["files"][each["place"][0]] for each in data["fixed"]], entries

    b = "demo/launch/b.launch"
    assert compared()[:2] == ([(b, "and at 1 more place)", "")], ["demo/launch/a.launch"])

    git(tracked, "add", "-A")
    git(tracked, "commit", "-q", "-m", "two mistakes")
    first.write_text(COPIED.format("rw"), encoding="utf-8")
    findings, fixed, entries = compared()
    assert (findings, fixed) == ([("demo/launch/a.launch", "and at 2 more places)", "new")], [])
    assert [entries[f"demo/launch/{name}.launch"] for name in "abc"] == [1, 1, 1]


ROS2 = {
    "robot.launch.xml": '<launch><node pkg="demo_nodes_cpp" exec="{}" name="{}"/></launch>\n',
    "robot.launch.py": """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package="demo_nodes_cpp", executable="{}", name="{}")])
""",
}


@pytest.mark.parametrize("name", ROS2)
@pytest.mark.parametrize("words", [(), ("--no-extract",)])
def test_base_compares_launch_files_of_ros_2(tracked: Path, name: str, words: tuple[str, ...]) -> None:
    launch = tracked / "demo" / "launch" / name
    launch.write_text(ROS2[name].format("talker", "one"), encoding="utf-8")
    git(tracked, "add", "-A")
    git(tracked, "commit", "-q", "-m", "second")
    launch.write_text(ROS2[name].format("listener", "other"), encoding="utf-8")
    data = data_of(run(tracked, "report", "-o", "-", "--base", "HEAD", *words, f"demo/launch/{name}").output)
    (entry,) = data["entries"]
    assert sorted((each["name"], each["mark"]) for each in entry["nodes"]) == [("/one", "removed"), ("/other", "added")]
