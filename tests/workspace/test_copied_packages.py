"""The packages that people copy: names, and marks of whose they are; how the list is made."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

from launchlint.workspace.copied_packages import are_copied, is_copied, mark
from launchlint.workspace.public_packages import PublicPackages

ROOT = Path(__file__).resolve().parent.parent.parent
LIST = ROOT / "launchlint" / "workspace" / "copied_packages.txt"
MANIFEST = """\
<package format="2"><name>{name}</name><version>1.0.0</version><description>x</description>
<maintainer email="{who}">x</maintainer><license>BSD</license></package>
"""


def test_a_package_is_known_by_its_name_and_whose_it_is() -> None:
    assert is_copied("sllidar_ros2", {"ros@slamtec.com"})
    assert not is_copied("sllidar_ros2", {"ros@slamtec.com", "me@my-robot.org"})
    assert not is_copied("sllidar_ros2", ())
    assert not is_copied("sllidar_ros3", {"ros@slamtec.com"})


def test_people_are_known_by_several_packages() -> None:
    assert are_copied(frozenset({"support@franka.de"}))
    assert not are_copied(frozenset({"ros@slamtec.com"}))  # of two
    assert not are_copied(frozenset({"support@franka.de", "me@my-robot.org"}))
    assert not are_copied(frozenset())


def test_a_mark_depends_on_all_people_and_on_no_order() -> None:
    assert mark("a", ["b@c.d", "e@f.g"]) == mark("a", ["e@f.g", "b@c.d"])
    assert len({mark("a", ["b@c.d"]), mark("a", ["b@c.d", "e@f.g"]), mark("b", ["b@c.d"])}) == 3


def test_the_list_holds_names_and_marks_only() -> None:
    lines = LIST.read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if not re.fullmatch(r"# [^@]*|[A-Za-z0-9][\w.-]*\t[0-9a-f]{8}(?: [0-9a-f]{8})*", line)] == []
    names = [line.partition("\t")[0] for line in lines if not line.startswith("#")]
    assert names == sorted(set(names))


def test_how_the_list_is_made(tmp_path: Path) -> None:
    held = {
        "projects/maker+driver/driver": ("driver", "maker@lidars.org"),
        "seen/ada+robot/src/copied": ("copied", "author@slam.org"),
        "seen/bob+robot/src/copied": ("copied", "author@slam.org"),
        "seen/bob+other/src/own": ("own", "bob@robots.org"),
        "seen/bob+robot/src/own": ("own", "bob@robots.org"),
        "seen/cid+robot/src/made": ("made", "root@todo.todo"),
        "seen/dan+robot/src/made": ("made", "root@todo.todo"),
    }
    for directory, (name, who) in held.items():
        (tmp_path / directory).mkdir(parents=True)
        (tmp_path / directory / "package.xml").write_text(MANIFEST.format(name=name, who=who))
    output = tmp_path / "list.txt"
    words = [str(each) for each in ("--project", tmp_path / "projects", "--seen", tmp_path / "seen", "--output", output)]
    output.write_text("copied\t00000000\nkept\t11111111 22222222\n")
    subprocess.run([sys.executable, ROOT / "scripts" / "copied_packages.py", *words], check=True, capture_output=True)
    found = PublicPackages(str(output))
    assert {name: found[name] for name in found} == {
        "copied": ("00000000", mark("copied", ["author@slam.org"])),
        "driver": (mark("driver", ["maker@lidars.org"]),),
        "kept": ("11111111", "22222222"),
    }
