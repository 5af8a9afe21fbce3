"""Questions to packages, as a cache holds them."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.looking import Looked, noted
from launchlint.workspace.packages import Packages
from launchlint.workspace.questions import answer
from launchlint.workspace.states import States
from tests.cli.running import PACKAGE, write


@pytest.fixture
def packages(tmp_path: Path) -> Packages:
    write(tmp_path, {
        "arm/package.xml": PACKAGE.format(name="arm"),
        "arm/launch/a.launch": "<launch/>",
        "hidden/CATKIN_IGNORE": "",
        "hidden/leg/package.xml": PACKAGE.format(name="leg"),
    })  # fmt: skip
    return Packages((str(tmp_path),), {}, explicit=True)


def asked(packages: Packages) -> Looked:
    noted()
    packages.get("arm", "/x")
    packages.has("wheel")
    packages.package_of(f"{packages.workspaces[0]}/arm/launch")
    packages.names()
    packages.hidden("leg")
    packages.is_hidden(f"{packages.workspaces[0]}/hidden/leg")
    packages.duplicates()
    packages.resolve_resource(f"{packages.workspaces[0]}/arm", "/launch")
    assert packages.places
    return noted()


def again(packages: Packages) -> Packages:
    return Packages(packages.workspaces, {}, explicit=True)


def test_each_has_an_answer_that_is_the_same_again(packages: Packages) -> None:
    questions = sorted(asked(packages).paths)
    assert [each.split(" ")[1] for each in questions] == [
        "all", "duplicates", "get", "get", "get", "hidden", "is-hidden", "names", "of", "resource",
    ]  # fmt: skip
    for each in questions:
        assert len(answer(packages, each)) == 40
        assert answer(packages, each) == answer(again(packages), each)


@pytest.mark.parametrize(
    ("files", "others"),
    [
        ({"wheel/package.xml": PACKAGE.format(name="wheel")}, {"all", "names", "get wheel"}),
        ({"arm/package.xml": PACKAGE.format(name="arm").replace("</package>", "<depend>a</depend></package>")}, set[str]()),
        (
            {
                "arm/package.xml": PACKAGE.format(name="arm").replace(
                    "</package>", "<export><build_type>cmake</build_type></export></package>"
                )
            },
            {"all", "get arm", "of"},
        ),
        ({"arm/launch/manifest.xml": "<package/>"}, {"of"}),
        ({"b/arm/package.xml": PACKAGE.format(name="arm")}, {"all", "get arm", "duplicates"}),
        ({"leg/package.xml": PACKAGE.format(name="leg")}, {"all", "names", "get leg", "hidden"}),
        ({"CATKIN_IGNORE": ""}, {"all", "names", "get arm", "hidden"}),
        ({"arm/launch/b.launch": "<launch/>"}, set[str]()),
    ],
)
def test_another_answer_where_somebody_could_tell(packages: Packages, files: dict[str, str], others: set[str]) -> None:
    questions = sorted(asked(packages).paths)
    before = {each: answer(packages, each) for each in questions}
    write(Path(packages.workspaces[0]), files)
    other = again(packages)
    told = {each.removeprefix("?rospack ") for each in questions if answer(other, each) != before[each]}
    assert {each if each.startswith("get") else each.split(" ")[0] for each in told} == others


def test_who_asks_hangs_on_the_answer_alone(packages: Packages) -> None:
    workspace = Path(packages.workspaces[0])
    noted()
    assert packages.launch_files("a.launch") == (f"{workspace}/arm/launch/a.launch",)
    looked = noted()
    assert not looked.paths
    assert not looked.wholes
    (answered,) = States().answered(looked.answers)
    assert answered.question == "?rospack launchlint.workspace.surveys:launch_files a.launch"
    assert str(workspace / "arm") in {path for shared in answered.shared for path, _ in shared.looks}
    assert answer(again(packages), answered.question) == answered.state
    write(workspace, {"arm/b.launch": "<launch/>"})
    assert answer(again(packages), answered.question) == answered.state
    write(workspace, {"arm/a.launch": "<launch/>"})
    assert answer(again(packages), answered.question) != answered.state


@pytest.mark.parametrize(
    "question",
    [
        "?",
        "?rospack",
        "?rospack nothing about",
        "?other get arm",
        "?rospack os:system true",
        "?rospack launchlint.workspace.surveys:folded ARM",
        "?rospack launchlint.workspace.surveys:nothing ARM",
        "?rospack launchlint.nowhere:launch_files ARM",
        "?rospack launchlint.workspace/../surveys:launch_files ARM",
    ],
)
def test_only_questions_are_asked(packages: Packages, question: str) -> None:
    assert answer(packages, question) == ""
