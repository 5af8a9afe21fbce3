"""Args go to the start of their block where that is proved to change nothing, and stay where it is not."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import pytest

from launchlint.fix.format.ordering import args_first
from launchlint.fix.guard import Guard
from tests.evaluate.comparison import session_in


class Case(NamedTuple):
    """A file, and what becomes of it; blank lines that are left over are taken away by the formatter."""

    before: str
    after: str


CASES = {
    "an arg with its comments": Case(
        """\
<launch>
  <arg name="a" default="1"/>
  <param name="p" value="1"/>

  <!-- how fast -->
  <arg name="b" default="$(arg a)"/> <!-- in m/s -->

  <param name="q" value="$(arg b)"/>
</launch>
""",
        """\
<launch>
  <arg name="a" default="1"/>
  <!-- how fast -->
  <arg name="b" default="$(arg a)"/> <!-- in m/s -->
  <param name="p" value="1"/>


  <param name="q" value="$(arg b)"/>
</launch>
""",
    ),
    "a comment that may be about more than the arg": Case(
        """\
<launch>
  <param name="p" value="1"/>

  <!-- the camera -->
  <arg name="b"
       default="1"/>
  <param name="q" value="$(arg b)"/>
</launch>
""",
        """\
<launch>
  <arg name="b"
       default="1"/>
  <param name="p" value="1"/>

  <!-- the camera -->
  <param name="q" value="$(arg b)"/>
</launch>
""",
    ),
    "each block by itself, args in their order": Case(
        """\
<launch>
  <group>
    <param name="p" value="1"/>
    <arg name="x" default="1"/>
    <arg name="y" default="$(arg x)"/>
  </group>
  <arg name="z" default="2"/>
</launch>
""",
        """\
<launch>
  <arg name="z" default="2"/>
  <group>
    <arg name="x" default="1"/>
    <arg name="y" default="$(arg x)"/>
    <param name="p" value="1"/>
  </group>
</launch>
""",
    ),
}

STAYS = {
    "the arg would be known where it is not": """\
<launch>
  <param name="p" value="$(arg a)"/>
  <arg name="a" default="1"/>
</launch>
""",
    "a group cannot declare an arg that is declared around it": """\
<launch>
  <group if="$(optenv SWITCH 0)">
    <arg name="a" default="inner"/>
    <param name="p" value="$(arg a)"/>
  </group>
  <arg name="a" default="1"/>
</launch>
""",
    "comments for launchlint may be about a place": """\
<launch>
  <!-- launchlint: ignore-file[LL206] meant -->
  <param name="p" value="1"/>
  <arg name="a" default="1"/>
</launch>
""",
    "stray text": """\
<launch>
  <param name="p" value="1"/>
  and
  <arg name="a" default="1"/>
</launch>
""",
    "args at the start already": """\
<launch>
  <!-- one -->
  <arg name="a" default="1"/>

  <!-- two -->
  <arg name="b" default="1"/>
  <include file="x.launch">
    <arg name="c" value="1"/>
  </include>
</launch>
""",
}


def sorted_in(directory: Path, text: str, line_end: str = "\n") -> str:
    file = directory / "a.launch"
    file.write_bytes(text.replace("\n", line_end).encode())
    guard = Guard(session_in(directory))
    return args_first(file.read_bytes(), lambda before, after: guard.refusal(str(file), before, after)).decode()


@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_args_go_up(case: Case, tmp_path: Path) -> None:
    assert sorted_in(tmp_path, case.before) == case.after


@pytest.mark.parametrize("text", STAYS.values(), ids=STAYS.keys())
def test_what_is_not_proved_stays(text: str, tmp_path: Path) -> None:
    assert sorted_in(tmp_path, text) == text


def test_one_that_must_stay_does_not_keep_the_others(tmp_path: Path) -> None:
    text = """\
<launch>
  <param name="p" value="$(arg used)"/>
  <arg name="a" default="1"/>
  <arg name="used" default="1"/>
  <arg name="b" default="1"/>
</launch>
"""
    expected = """\
<launch>
  <arg name="a" default="1"/>
  <arg name="b" default="1"/>
  <param name="p" value="$(arg used)"/>
  <arg name="used" default="1"/>
</launch>
"""
    assert sorted_in(tmp_path, text) == expected


def test_line_ends_stay(tmp_path: Path) -> None:
    case = CASES["an arg with its comments"]
    assert sorted_in(tmp_path, case.before, "\r\n") == case.after.replace("\n", "\r\n")
