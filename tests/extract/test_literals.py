"""The texts in sources that may be names: what bounds a program of which not every name is known."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from launchlint.extract.literals import MOST, Literals
from tests.extract.test_package import MANIFEST, grow, program

PYTHON = "#!/usr/bin/env python\nimport rospy\nfrom std_msgs.msg import String\n"


def variant(root: Path) -> Any:
    return program(root, "demo", "n")["variants"]["default"]


def test_only_texts_that_could_be_names(tmp_path: Path) -> None:
    file = tmp_path / "n.cpp"
    file.write_text('#include "a.h"\nf("scan", "/a/b", "~cd", "x y", "9z", "q", "%s/z", \'word\'); // "said"\n', encoding="utf-8")
    assert Literals().among([str(file), str(tmp_path / "gone.cpp"), str(tmp_path)]) == ["/a/b", "said", "scan", "word", "~cd"]


def test_too_many_texts_say_nothing(tmp_path: Path) -> None:
    file = tmp_path / "n.py"
    file.write_text(" ".join(f"'n{number}'" for number in range(MOST + 1)), encoding="utf-8")
    assert Literals().among([str(file)]) == []


def test_a_program_that_is_open_says_its_literals_those_of_its_modules_included(tmp_path: Path) -> None:
    module = "import rospy\nNAMES = ['/front/scan']\ndef go(kind):\n    rospy.Publisher(input(), kind)\n"
    files = {
        "demo/package.xml": MANIFEST.format(name="demo", more=""),
        "demo/n": f"{PYTHON}import part\nrospy.Publisher('chatter', String)\npart.go(String)\n",
        "demo/part.py": module,
    }
    found = variant(grow(tmp_path / "ws", files))
    assert found["literals"] == ["/front/scan", "chatter"]


def test_a_program_whose_names_are_all_known_says_none(tmp_path: Path) -> None:
    files = {"demo/package.xml": MANIFEST.format(name="demo", more=""), "demo/n": f"{PYTHON}rospy.Publisher('chatter', String)\n"}
    assert "literals" not in variant(grow(tmp_path / "ws", files))
