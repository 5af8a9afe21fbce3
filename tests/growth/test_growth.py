"""No construct of a launch file makes the work grow faster than its text, up to the bounds that launchlint sets itself, and beyond them."""

from __future__ import annotations

from math import log2
from pathlib import Path

import pytest
from lxml import etree

from tests.growth import ros1, ros2, ros2_python
from tests.growth.work import calls
from tests.growth.workspace import Construct, build

CONSTRUCTS = (*ros1.CONSTRUCTS, *ros2.CONSTRUCTS, *ros2_python.CONSTRUCTS)
SIZES = (60, 120, 240)
STEEPEST = 1.2
"""The greatest exponent: what a text twice as long costs more is at most 2 ** 1.2 times what it cost more for the doubling before."""
STEEPEST_OF_DEPTH = 2.1
"""The same for what can only be nested, and not 1,000 deep: each level may look at those around it."""
FEW = 3_000
"""So few calls more for 120 of a construct say nothing about growth."""
LISTS = {
    "launchlint.check.listing.MOST_LISTED": 20,
    "launchlint.spelling.MOST_LOOKED_AT": 50,
    "launchlint.spelling.MOST_COMPARED": 20,
    "launchlint.rules.judging.loose_ends._MOST_COMPARISONS": 200,
    "launchlint.evaluate.ros2.passing._MOST_WORK": 200,
    "launchlint.evaluate.ros2.leaving._MOST_WORK": 200,
}
"""Findings of a rule that are listed; names that one is compared with, loose ends of connections, and files that an arg is passed to."""
WORK = {
    "launchlint.evaluate.assemble.LARGEST_LAUNCH": 50,
    "launchlint.evaluate.ros1.file.LARGEST_EVALUATION": 50,
    "launchlint.evaluate.ros2.walk.LARGEST_EVALUATION": 50,
}
"""What one configuration may amount to."""

FIXING = {"launchlint.check.fixing.FEWEST_ATTEMPTS": 3, "launchlint.check.fixing.MOST_TEXT": 0}
"""Sets of fixes that are tried, of any file: one that no fix can be left out of needs as many as it has."""
OTHERS = {
    ("check", "--no-cache", "--jobs", "1", "--unsafe-fixes", "--diff"): (
        "nodes of one name",
        "args",
        "chain of args",
        "empty groups",
        "unknown tags",
    ),
    ("export",): ("remaps and nodes", "params for all groups", "includes with an arg", "ROS 2: includes with an arg", "ROS 2: conditions"),
    ("graph", "--format", "json"): ("a hub", "pairs that just miss", "nodelets of a manager", "ROS 2: components", "ROS 2: pairs"),
    ("report", "-o", "page.html"): ("a hub", "pairs that just miss", "groups", "includes with an arg", "ROS 2: loaded components"),
    ("format", "--diff"): ("comments", "remaps of a node", "YAML of a node", "ROS 2: nodes of YAML"),
    ("model",): ("remaps and nodes", "includes with an arg", "ROS 2: remaps and nodes"),
}
"""What commands other than a check do most with. ``python -m tests.bench.growth --command`` tries any of them with all constructs."""


def exponent(counts: list[int]) -> float:
    """The power of the size with which the counts at ``SIZES`` grow, whatever the constant part; 0 where they hardly do."""
    first, second = abs(counts[1] - counts[0]), counts[2] - counts[1]
    return log2(second / max(first, 1)) if second > FEW else 0.0


@pytest.mark.parametrize("construct", CONSTRUCTS, ids=lambda construct: construct.name)
def test_check(construct: Construct, tmp_path: Path) -> None:
    counts = []
    for size in SIZES:
        directory = tmp_path / str(size)
        build(construct, size, directory)
        bounds = {**LISTS, **WORK} if construct.product else LISTS
        counts.append(calls(("check", "--no-cache", "--jobs", "1", construct.entry), directory, bounds))
    assert exponent(counts) <= (STEEPEST_OF_DEPTH if construct.most < 1_000 else STEEPEST), counts


@pytest.mark.parametrize("construct", CONSTRUCTS, ids=lambda construct: construct.name)
def test_each_is_what_it_is_called(construct: Construct, tmp_path: Path) -> None:
    """Not a file that is refused at its first mistake, however much of it follows."""
    build(construct, SIZES[0], tmp_path)
    for file in (*tmp_path.rglob("*.launch"), *tmp_path.rglob("*.xml")):
        etree.parse(file, etree.XMLParser(huge_tree=True, resolve_entities=False))


@pytest.mark.parametrize(("words", "name"), [(words, name) for words, names in OTHERS.items() for name in names])
def test_other_commands(words: tuple[str, ...], name: str, tmp_path: Path) -> None:
    construct = next(each for each in CONSTRUCTS if each.name == name)
    counts = []
    for size in SIZES:
        directory = tmp_path / str(size)
        build(construct, size, directory)
        counts.append(calls((*words, construct.entry), directory, {**LISTS, **FIXING, **(WORK if construct.product else {})}))
    assert exponent(counts) <= STEEPEST, counts


def test_fixes_of_many_files_that_others_include(tmp_path: Path) -> None:
    """Each launch file that shows the fixes is asked once for all of them, though one of them cannot stay."""
    counts = []
    for size in (10, 20, 40):
        directory = tmp_path / str(size)
        launch = directory / "launch"
        launch.mkdir(parents=True)
        (directory / "package.xml").write_text("<package><name>p</name></package>\n")
        for number in range(size):
            part = '<node if="false" name="m" pkg="p" type="t"><rosparam ns="a">{b: 1}</rosparam></node>' if number == 3 else ""
            part += f'<node name="n{number}" pkg="p" type="t"><rosparam ns="a">{{b: $(arg x)}}</rosparam></node>'
            (launch / f"part_{number}.launch").write_text(f'<launch><arg name="x" default="1"/>{part}</launch>\n')
        includes = "".join(f'<include file="$(dirname)/part_{number}.launch"/>' for number in range(size))
        for number in range(5):
            (launch / f"all_{number}.launch").write_text(f"<launch>{includes}</launch>\n")
        counts.append(calls(("check", "--no-cache", "--jobs", "1", "--diff", "launch"), directory, {}))
    assert log2((counts[2] - counts[1]) / (counts[1] - counts[0])) <= STEEPEST, counts
