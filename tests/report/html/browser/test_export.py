"""What is shown, as a file in other formats."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest

pytestmark = pytest.mark.chromium

VIEW = "#open=/base&hide=n%3A/mystery"


def saved(page, choice: str, directory: Path) -> Path:
    """The file that an item of the menu saves."""
    page.locator(".menu summary").click()
    with page.expect_download() as download:
        page.get_by_role("button", name=choice).click()
    file = directory / download.value.suggested_filename
    download.value.save_as(file)
    return file


def test_mermaid_and_dot_are_what_is_drawn(open_report, snapshot, tmp_path):
    page = open_report(fragment=VIEW)
    snapshot("robot.mmd", saved(page, "Mermaid", tmp_path).read_text(encoding="utf-8"))
    snapshot("robot.dot", saved(page, "Graphviz DOT", tmp_path).read_text(encoding="utf-8"))


def test_json_names_boxes_and_arrows(open_report, tmp_path):
    page = open_report(fragment=VIEW)
    picture = json.loads(saved(page, "JSON", tmp_path).read_text(encoding="utf-8"))
    assert picture["title"] == "robot.launch"
    assert [(box["kind"], box["label"], box["parent"]) for box in picture["boxes"]] == [
        ("container", "/base", ""),
        ("node", "/base/driver", "g:namespace:/base"),
        ("node", "/base/odometry", "g:namespace:/base"),
        ("node", "/base/simulator", "g:namespace:/base"),
        ("folded", "/perception", ""),
        ("node", "/docking", ""),
    ]
    assert [(arrow["from"], arrow["to"], arrow["names"]) for arrow in picture["arrows"]] == [
        ("n:3", "n:1", ["/dock"]),
        ("g:namespace:/perception", "n:0", ["/base/driver/stop"]),
        ("n:1", "g:namespace:/perception", ["/base/odom"]),
        ("n:0", "n:1", ["/base/ticks"]),
        ("n:2", "n:1", ["/base/ticks"]),
    ]


def test_what_is_drawn_of_a_refused_launch_says_so(open_report, tmp_path):
    said = "refused by roslaunch: two nodes are named /camera"
    page = open_report(fragment="#entry=tools.launch")
    assert saved(page, "Mermaid", tmp_path).read_text(encoding="utf-8").splitlines()[1] == f'  verdict["{said.replace(":", "#58;")}"]'
    page = open_report(fragment="#entry=tools.launch")
    assert f'label="tools.launch\\n{said}";' in saved(page, "Graphviz DOT", tmp_path).read_text(encoding="utf-8")
    page = open_report(fragment="#entry=tools.launch")
    assert json.loads(saved(page, "JSON", tmp_path).read_text(encoding="utf-8"))["verdict"] == said


def test_svg_is_a_document_of_its_own(open_report, tmp_path):
    page = open_report(fragment=VIEW)
    root = ElementTree.parse(saved(page, "SVG picture", tmp_path)).getroot()
    texts = {"".join(each.itertext()) for each in root.iter("{http://www.w3.org/2000/svg}text")}
    assert {"driver", "odometry", "docking", "/perception"} <= texts


@pytest.mark.graphviz
def test_graphviz_reads_hostile_names(open_report, tmp_path, dot_command):
    page = open_report("hostile")
    file = saved(page, "Graphviz DOT", tmp_path)
    subprocess.run([dot_command, "-Tcanon", str(file)], check=True, capture_output=True)


def test_a_comparison_marks_what_has_gone_and_what_is_new(open_report, tmp_path):
    page = open_report("changed")
    written = saved(page, "Mermaid", tmp_path).read_text(encoding="utf-8").splitlines()
    arrows = [line for line in written if any(sign in line for sign in ("-->", "-.->", "==>"))]
    styles = dict(line.split(maxsplit=2)[1:] for line in written if line.startswith("  linkStyle"))
    assert sorted(styles.values()) == ["stroke:#1a7f37,stroke-width:3px", "stroke:#cf222e,stroke-width:3px,stroke-dasharray: 6 3"]
    assert all("image_raw" in arrows[int(number)] for number in styles)
