"""Public launch files, exported and given to the real roslaunch: the files of the paper's table, and a sample of all."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from launchlint.syntax.parse import parse
from tests.bench.corpus import launch_files
from tests.bench.export import compare, outcomes

EVERY = 90

# The paper names four packages and how many launch files of each were imported and exported. Of roslaunch it counts 14: 13 are called
# .launch, and of the two that are called .xml beside them one is an example. (The other is roscore's own, which roslaunch refuses to be
# given; the files that its unit tests load, below test/xml, are many more.)
PAPER = {
    "ros+ros_comm/tools/roslaunch": 14,
    "ros+ros_tutorials/roscpp_tutorials": 1,
    "ros+ros_tutorials/rospy_tutorials": 17,
    "ros+ros_tutorials/turtlesim": 1,
}


def files_of_the_paper(corpus: Path) -> list[str]:
    found = []
    for package, count in PAPER.items():
        here = [*(corpus / package).rglob("*.launch"), *(corpus / package / "resources").glob("example-*.xml")]
        assert len(here) == count
        found += sorted(map(str, here))
    return found


@pytest.mark.corpus
@pytest.mark.ros
@pytest.mark.parametrize("mode", ["plain", "flatten"])
def test_the_files_of_the_paper_are_functionally_identical(mode: str, corpus: Path, ros_python: str, tmp_path: Path) -> None:
    directory = corpus / "ros1"
    found = list(outcomes(files_of_the_paper(directory), directory, mode, tmp_path))
    assert [(each.file, each.word) for each in found if each.word != "exported"] == []
    assert [(each.file, text) for each, text in compare(found, ros_python, directory, mode) if text] == []


@pytest.mark.corpus
def test_no_comment_and_no_attribute_of_the_paper_is_lost(corpus: Path, tmp_path: Path) -> None:
    """What the paper's own export lost: comments, the order of siblings, and an ssh-port."""
    directory = corpus / "ros1"

    def written(data: bytes) -> tuple[list[str], list[tuple[str, list[tuple[str, str]]]]]:
        document = parse(data, "x.launch")
        comments = [re.sub(r"\s+", " ", comment.text).strip() for comment in document.comments]
        elements = [
            (element.tag, sorted((attribute.name, attribute.value) for attribute in element.attributes.values()))
            for element in document.elements
        ]
        return comments, elements

    found = list(outcomes(files_of_the_paper(directory), directory, "plain", tmp_path))
    lost = [each.file for each in found if written(Path(each.file).read_bytes()) != written(Path(each.exported).read_bytes())]
    assert lost == []
    assert any(b"ssh-port=" in Path(each.exported).read_bytes() for each in found)


@pytest.mark.corpus
@pytest.mark.ros
@pytest.mark.parametrize("mode", ["flatten", "args-kept"])
def test_roslaunch_starts_the_same_from_a_sample(mode: str, corpus: Path, ros_python: str, tmp_path: Path) -> None:
    directory = corpus / "ros1"
    found = list(outcomes(launch_files(directory)[::EVERY], directory, mode, tmp_path))
    assert [(each.file, each.word) for each in found if each.word.startswith("not exported")] == []
    exported = [each for each in found if each.word == "exported"]
    assert exported != []
    assert [(each.file, text) for each, text in compare(exported, ros_python, directory, mode) if text] == []
