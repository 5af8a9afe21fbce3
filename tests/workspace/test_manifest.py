"""package.xml and manifest.xml."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.manifest import Identity, identify, parse_manifest, read_manifest

FORMAT_2 = """<?xml version="1.0"?>
<package format="2">
  <name>rover</name>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>roscpp</depend>
  <build_depend>eigen</build_depend>
  <build_export_depend>std_msgs</build_export_depend>
  <exec_depend condition="$ROS_VERSION == 1"> amcl </exec_depend>
  <test_depend>rostest</test_depend>
  <export>
    <nodelet plugin="${prefix}/plugins/nodelets.xml"/>
    <rviz plugin="${prefix}/rviz.xml"/>
  </export>
</package>
"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<package><name>a</name></package>", Identity("a", False, "")),
        ("<package><name>\n  a_b-c \t</name></package>", Identity("a_b-c", False, "")),
        ("<package><description><name>no</name></description><name>a</name></package>", Identity("a", False, "")),
        ("<package><name>a</name><name>b</name></package>", Identity("a", False, "")),
        ("<package><name>a<b/>c</name></package>", Identity("a", False, "")),
        ("<package><name><!-- why -->a</name></package>", Identity("a", False, "")),
        ("<package><name>a&amp;b</name></package>", Identity("a&b", False, "")),
        ("<package><name>a</name><export><metapackage/></export></package>", Identity("a", True, "")),
        ("<package><export><metapackage/></export></package>", Identity("", True, "")),
        ("<package><name>a</name><metapackage/></package>", Identity("a", False, "")),
        ("<package><x><name>b</name></x><name>a</name><name>b</name></package>", Identity("a", False, "")),
        ("<package><name>a</name><x><metapackage/></x></package>", Identity("a", False, "")),
        ("<package/>", Identity("", False, "it has no <name>")),
        ("<package><name> </name></package>", Identity("", False, "its <name> is empty")),
        ('<package xmlns="urn:x"><name>a</name></package>', Identity("", False, "it has no <name>")),
        ("<package><name>a</package>", Identity("", False, "not well-formed XML: mismatched tag, line 1, column 18")),
        ("", Identity("", False, "not well-formed XML: no element found, line 1, column 0")),
    ],
)
def test_identity(text: str, expected: Identity) -> None:
    assert identify(text.encode()) == expected


def test_identity_by_declared_encoding() -> None:
    text = '<?xml version="1.0" encoding="{}"?><package><name>käse</name></package>'
    assert identify(text.format("ISO-8859-1").encode("latin-1")).name == "käse"
    assert identify(text.format("utf-16").encode("utf-16")).name == "käse"
    assert identify(text.format("utf-8").encode("utf-8-sig")).name == "käse"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_a_metapackage_in_any_encoding(encoding: str) -> None:
    text = f'<?xml version="1.0" encoding="{encoding}"?><package><name>a</name><export><metapackage/></export></package>'
    assert identify(text.encode(encoding)) == Identity("a", True, "")


@pytest.mark.parametrize(
    "subset",
    [
        '<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;">',
        '<!ENTITY a SYSTEM "file:///etc/passwd">',
        f'<!ENTITY a "{"x" * 1000}">',
        '<!ENTITY % p "x">',
    ],
)
def test_entities_that_could_grow_are_refused(subset: str) -> None:
    data = f"<!DOCTYPE package [{subset}]><package><name>p</name></package>".encode()
    assert identify(data) == Identity("", False, "it declares XML entities that are external, nested or long")
    with pytest.raises(ValueError, match="it declares XML entities that are external, nested or long"):
        parse_manifest(data, "/w/package.xml")


def test_dependencies_with_their_kinds_and_places() -> None:
    manifest = parse_manifest(FORMAT_2.encode(), "/w/rover/package.xml", "rover/package.xml")
    found = [(each.name, each.tag, manifest.source.text[each.span.start : each.span.end]) for each in manifest.dependencies]
    assert found == [
        ("catkin", "buildtool_depend", "<buildtool_depend>catkin</buildtool_depend>"),
        ("roscpp", "depend", "<depend>roscpp</depend>"),
        ("eigen", "build_depend", "<build_depend>eigen</build_depend>"),
        ("std_msgs", "build_export_depend", "<build_export_depend>std_msgs</build_export_depend>"),
        ("amcl", "exec_depend", '<exec_depend condition="$ROS_VERSION == 1"> amcl </exec_depend>'),
        ("rostest", "test_depend", "<test_depend>rostest</test_depend>"),
    ]
    assert manifest.run_dependencies == {"roscpp", "std_msgs", "amcl"}
    assert manifest.test_dependencies == {"rostest"}
    assert manifest.depends() == {"catkin", "roscpp", "eigen", "std_msgs", "amcl", "rostest"}
    assert manifest.plugins == ("/w/rover/plugins/nodelets.xml",)
    assert (manifest.name, manifest.format, manifest.is_catkin, manifest.is_ament) == ("rover", 2, True, False)
    last = manifest.last_dependency
    assert last is not None
    assert last.text == "<test_depend>rostest</test_depend>"
    assert last.source.position(last.span.start) == (9, 3)
    assert manifest.root_end is not None
    assert manifest.source.text[manifest.root_end.start :] == "</package>\n"


@pytest.mark.parametrize(
    ("body", "run"),
    [
        ("<run_depend>a</run_depend>", {"a"}),
        ("<build_depend>a</build_depend>", set()),
        ("<exec_depend>a</exec_depend>", {"a"}),
        ("<test_depend>a</test_depend>", set()),
        ("<run_depend/><run_depend> </run_depend>", set()),
        ("<group><run_depend>a</run_depend></group>", set()),
    ],
)
def test_run_dependencies_of_format_1(body: str, run: set[str]) -> None:
    assert parse_manifest(f"<package><name>p</name>{body}</package>".encode(), "/p/package.xml").run_dependencies == run


@pytest.mark.parametrize(
    ("element", "expected"),
    [("<depend/>", "<depend/>"), ("<depend></depend>", "<depend></depend>"), ("<depend>/></depend>", "<depend>/></depend>")],
)
def test_span_of_the_name_element_whatever_stands_in_it(element: str, expected: str) -> None:
    text = f"<package>é{element.replace('depend', 'name')}</package>"
    span = parse_manifest(text.encode(), "/p/package.xml").name_span
    assert span is not None
    assert text[span.start : span.end] == expected.replace("depend", "name")


def test_manifest_xml() -> None:
    text = """<package><depend package="rospy"/><rosdep name="x"/><depend package="tf"/>
        <export><nodelet plugin="${prefix}/n.xml"/></export></package>"""
    manifest = parse_manifest(text.encode(), "/w/old_robot/manifest.xml")
    assert (manifest.name, manifest.format, manifest.is_catkin) == ("old_robot", 0, False)
    assert manifest.run_dependencies == {"rospy", "tf"}
    assert manifest.plugins == ("/w/old_robot/n.xml",)


@pytest.mark.parametrize(
    ("build_types", "catkin", "ament"),
    [
        ("", True, False),
        ("<build_type>catkin</build_type>", True, False),
        ("<build_type>cmake</build_type>", False, False),
        ("<build_type>ament_cmake</build_type>", False, True),
        ("<build_type condition='$ROS_VERSION == 1'>catkin</build_type><build_type>ament_python</build_type>", True, False),
    ],
)
def test_build_types(build_types: str, catkin: bool, ament: bool) -> None:
    manifest = parse_manifest(f"<package format='3'><name>p</name><export>{build_types}</export></package>".encode(), "/p/package.xml")
    assert (manifest.is_catkin, manifest.is_ament) == (catkin, ament)


def test_file_that_is_too_large_or_no_file(tmp_path: Path) -> None:
    large = tmp_path / "package.xml"
    large.write_bytes(b" " * ((1 << 20) + 1))
    with pytest.raises(OSError, match="it is larger than 1048576 bytes"):
        read_manifest(str(large))
    with pytest.raises(OSError, match="it is not a plain file"):
        read_manifest(str(tmp_path))


def test_people_and_pages() -> None:
    text = """<package format="2"><name>p</name>
      <maintainer email="One@Example.org">One</maintainer><author email="two@example.org">Two</author><author>Three</author>
      <!-- <maintainer email="four@example.org"/> <url type="website">http://wiki.ros.org/none</url> -->
      <url type="repository"> https://github.com/one/p </url><url>http://wiki.ros.org/p</url>
      <export><url>http://elsewhere.org</url><author email="five@example.org"/></export></package>"""
    manifest = parse_manifest(text.encode(), "/p/package.xml")
    assert manifest.people == {"one@example.org", "two@example.org"}
    assert manifest.urls == (("repository", "https://github.com/one/p"), ("", "http://wiki.ros.org/p"))
