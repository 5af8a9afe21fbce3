"""Manifests as an earlier run has read them: the same in all that anybody asks."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace import contents
from launchlint.workspace.contents import Contents
from launchlint.workspace.crawl import crawl_all
from launchlint.workspace.known_manifest import known_identity, known_manifest
from launchlint.workspace.manifest import Manifest, identify, read_manifest
from launchlint.workspace.package import Package

WHOLE = """<?xml version="1.0"?>
<!-- for the arm -->
<package format="3">
  <name>arm</name>
  <version>1.0.0</version>
  <maintainer email="A@example.com">Ada</maintainer>
  <author>Bob</author>
  <license>MIT</license>
  <url type="repository">https://example.com/arm/arm</url>
  <depend>roscpp</depend>
  <exec_depend condition="$ROS_VERSION == 2">rclcpp</exec_depend>
  <test_depend>rostest</test_depend>
  <export>
    <build_type condition="$ROS_VERSION == 1">catkin</build_type>
    <build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>
    <nodelet plugin="${prefix}/nodelets.xml"/>
    <metapackage/>
  </export>
</package>
"""
TEXTS = {
    "whole": WHOLE,
    "no name": "<package><depend>a</depend></package>",
    "empty": "<package/>",
    "one line": "<package><name>a</name></package>",
    "umlauts": '<package format="2"><name>a</name><maintainer email="ä@x">Ä</maintainer><depend>b</depend></package>',
}


@pytest.fixture(autouse=True)
def always_written(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contents, "WORTH_WRITING", 1)


def asked(manifest: Manifest) -> tuple[object, ...]:
    """All that a manifest says, with the text that it is made from."""
    source, *fields = manifest
    return (source.path, source.file, source.text, source.position(len(source.text)), *fields, manifest.ros_versions)


@pytest.mark.parametrize("text", TEXTS.values(), ids=list(TEXTS))
def test_it_says_the_same(text: str, tmp_path: Path) -> None:
    path = tmp_path / "arm" / "package.xml"
    path.parent.mkdir()
    path.write_text(text, encoding="utf-8")
    for _ in range(2):
        held = Contents(str(tmp_path / "kept"))
        assert known_identity(str(path), held) == identify(path.read_bytes())
        for _ in range(2):
            assert asked(known_manifest(str(path), held)) == asked(read_manifest(str(path)))
        held.keep()


def test_manifests_of_rosbuild_are_called_as_their_directories(tmp_path: Path) -> None:
    path = tmp_path / "arm" / "manifest.xml"
    path.parent.mkdir()
    path.write_text('<package><depend package="roscpp"/><export><nodelet plugin="${prefix}/n.xml"/></export></package>')
    held = Contents(str(tmp_path / "kept"))
    for _ in range(2):
        manifest = known_manifest(str(path), held)
        assert (manifest.name, manifest.plugins) == ("arm", (f"{path.parent}/n.xml",))


def test_a_text_that_is_gone_is_empty(tmp_path: Path) -> None:
    path = tmp_path / "package.xml"
    path.write_text(WHOLE)
    held = Contents(str(tmp_path / "kept"))
    known_manifest(str(path), held)
    manifest = known_manifest(str(path), held)
    path.unlink()
    assert (manifest.source.text, manifest.name) == ("", "arm")
    with pytest.raises(AttributeError):
        _ = manifest.source.nothing  # type: ignore[attr-defined]


def test_a_broken_one_is_broken_each_time(tmp_path: Path) -> None:
    path = tmp_path / "arm" / "package.xml"
    path.parent.mkdir()
    path.write_text("<package><name>arm</package>")
    for _ in range(2):
        held = Contents(str(tmp_path / "kept"))
        (crawled,), _ = crawl_all(str(tmp_path), held=held)
        package = Package(crawled, held)
        assert package.manifest is None
        assert package.broken.startswith("not well-formed XML: mismatched tag")
        held.keep()


@pytest.mark.parametrize("value", [None, [], ["a", 1, ""], [1, False, ""], ["a", False, None]])
def test_an_identity_of_another_form_is_read_anew(value: object, tmp_path: Path) -> None:
    path = tmp_path / "package.xml"
    path.write_text(WHOLE)
    held = Contents(str(tmp_path / "kept"))
    held.fact(str(path), "identity", lambda data: value, lambda each: each, lambda each: each)
    assert known_identity(str(path), held) == ("arm", True, "")
