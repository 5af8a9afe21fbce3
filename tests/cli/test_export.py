"""``launchlint export``."""

from __future__ import annotations

from pathlib import Path

from tests.cli.running import run, write

ROBOT = """\
<launch>
    <arg name="rate" default="5"/>   <!-- per second -->
    <include file="$(find demo)/launch/part.launch">
        <arg name="rate" value="$(arg rate)"/>
    </include>
</launch>
"""
PART = """\
<launch>
  <arg name="rate"/>
  <group ns="robot">
    <node name="talker" pkg="demo" type="talk.py">
      <param name="rate" value="$(arg rate)"/>
    </node>
  </group>
</launch>
"""
FILES = {"demo/launch/robot.launch": ROBOT, "demo/launch/part.launch": PART}
PLAIN = """\
<launch>
  <arg name="rate" default="5"/> <!-- per second -->
  <include file="$(find demo)/launch/part.launch">
    <arg name="rate" value="$(arg rate)"/>
  </include>
</launch>
"""
FLAT = """\
<launch>
  <!-- Flattened by launchlint from robot.launch{with_}. -->

  <!-- from demo/launch/part.launch -->
  <node name="talker" pkg="demo" type="talk.py" ns="robot">
    <param name="rate" value="{rate}"/>
  </node>
</launch>
"""
UNKNOWN_TAG = '<launch>\n  <nod name="a" pkg="demo" type="talk.py"/>\n  <node name="b" pkg="demo" type="talk.py"/>\n</launch>\n'
UNKNOWN_ATTRIBUTE = '<launch>\n  <node name="b" pkg="demo" type="talk.py" speed="1"/>\n</launch>\n'
UNCLOSED = '<launch>\n  <group ns="a">\n  <node name="b" pkg="demo" type="talk.py"/>\n</launch>\n'


def test_the_file_itself_in_normal_form(repository: Path) -> None:
    write(repository, FILES)
    assert run(repository, "export", "demo/launch/robot.launch") == (0, PLAIN, "")


def test_one_file(repository: Path) -> None:
    write(repository, FILES)
    assert run(repository, "export", "demo/launch/robot.launch", "--flatten") == (0, FLAT.format(with_="", rate="5"), "")


def test_one_file_with_args_into_a_file(repository: Path) -> None:
    write(repository, FILES)
    assert run(repository, "export", "demo/launch/robot.launch", "rate:=9", "--flatten", "-o", "flat.launch") == (0, "", "")
    assert (repository / "flat.launch").read_text() == FLAT.format(with_=", started with rate:=9", rate="9")


def test_standard_input(repository: Path) -> None:
    write(repository, FILES)
    ran = run(repository, "export", "-", "--flatten", "--stdin-filename", "demo/launch/robot.launch", stdin=ROBOT.replace("5", "7"))
    assert ran == (0, FLAT.format(with_="", rate="7"), "")


def test_other_encodings_stay(repository: Path) -> None:
    latin = '<?xml version="1.0" encoding="ISO-8859-1"?>\n<launch>\n  <param name="street" value="Allé"/>\n</launch>\n'.encode("latin-1")
    (repository / "latin.launch").write_bytes(latin)
    assert run(repository, "export", "latin.launch", "-o", "out.launch") == (0, "", "")
    assert (repository / "out.launch").read_bytes() == latin


def test_what_is_fixed_is_told(repository: Path) -> None:
    choosing = '<launch>\n  <arg name="part" default="part"/>\n  <include file="$(dirname)/$(arg part).launch"/>\n</launch>\n'
    write(
        repository,
        {"demo/launch/choosing.launch": choosing, "demo/launch/part.launch": '<launch>\n  <param name="p" value="1"/>\n</launch>\n'},
    )
    expected = """\
<launch>
  <!-- Flattened by launchlint from choosing.launch. -->
  <!-- Fixed: the arg part, 'part' here, since $(dirname)/$(arg part).launch decides which file is included -->

  <arg name="part" value="part"/>

  <!-- from demo/launch/part.launch -->
  <param name="p" value="1"/>
</launch>
"""
    notice = "launchlint: fixed: the arg part, 'part' here, since $(dirname)/$(arg part).launch decides which file is included\n"
    assert run(repository, "export", "demo/launch/choosing.launch", "--flatten", "--args-kept") == (0, expected, notice)


def test_a_refused_file_is_a_finding_and_nothing_is_written(repository: Path) -> None:
    write(repository, {"unclosed.launch": UNCLOSED, "out.launch": "mine"})
    ran = run(repository, "export", "unclosed.launch", "--flatten", "-o", "out.launch")
    assert (ran.status, ran.output) == (1, "")
    assert ran.errors == (
        "unclosed.launch:2:3: error LL101 malformed-xml: not well-formed XML: <group> is never closed\n"
        '    2 |   <group ns="a">\n'
        "      |   ^^^^^^^^^^^^^^\n"
        "    4 | </launch>\n"
        "      | ^^^^^^^^^ </launch> comes first\n"
        "   = roslaunch stops with: Invalid roslaunch XML syntax\n"
        "   = show it: roslaunch unclosed.launch\n"
        "   = help: end it with /> or add </group>      [explain LL101]\n"
        "\n"
        "1 error in 1 launch file\n"
        "launchlint: unclosed.launch is not exported, since roslaunch refuses it\n"
    )
    assert (repository / "out.launch").read_text() == "mine"


def test_a_required_arg_is_asked_for(repository: Path) -> None:
    write(repository, FILES)
    ran = run(repository, "export", "demo/launch/part.launch", "--flatten")
    assert (ran.status, ran.output) == (1, "")
    assert ran.errors.startswith("demo/launch/part.launch:2:14: info LL202 required-arg-unset: ")
    assert run(repository, "export", "demo/launch/part.launch", "rate:=3", "--flatten").status == 0


def test_the_three_mistakes_of_the_paper(repository: Path) -> None:
    """A tag that does not exist, an attribute that does not exist, a tag that is not closed (section Import and Export of Launch Files)."""
    write(repository, {"tag.launch": UNKNOWN_TAG, "attribute.launch": UNKNOWN_ATTRIBUTE, "unclosed.launch": UNCLOSED})
    told = {name: run(repository, "export", f"{name}.launch", "--flatten") for name in ("tag", "attribute", "unclosed")}
    assert {name: (ran.status, ran.errors.splitlines()[0]) for name, ran in told.items()} == {
        "tag": (0, "tag.launch:2:4: warning LL103 unknown-tag: there is no tag <nod>"),
        "attribute": (0, "attribute.launch:2:44: warning LL104 unknown-attribute: <node> has no attribute speed"),
        "unclosed": (1, "unclosed.launch:2:3: error LL101 malformed-xml: not well-formed XML: <group> is never closed"),
    }


def test_options_that_clash(repository: Path) -> None:
    write(repository, FILES)
    message = "launchlint: --args-kept goes with --flatten; without it, all args stay anyway\n"
    assert run(repository, "export", "demo/launch/robot.launch", "--args-kept") == (2, "", message)


def test_a_file_that_does_not_exist(repository: Path) -> None:
    ran = run(repository, "export", "nothing.launch", "--flatten")
    assert (ran.status, ran.output) == (2, "")
    assert ran.errors.startswith("launchlint: nothing.launch")


def test_a_directory_is_no_file(repository: Path) -> None:
    ran = run(repository, "export", "demo", "--flatten")
    assert (ran.status, ran.output, ran.errors) == (2, "", "launchlint: demo is no launch file; give one\n")


def test_however_the_path_is_written(repository: Path) -> None:
    write(repository, FILES)
    plain = run(repository, "export", "demo/launch/robot.launch", "--flatten")
    assert plain.status == 0
    for path in ("./demo/launch/robot.launch", "demo/../demo/launch/robot.launch"):
        assert run(repository, "export", path, "--flatten") == plain


def test_args_are_kept_in_ros1_only(repository: Path) -> None:
    write(repository, {"arg.launch.xml": '<launch>\n  <arg name="rate" default="1"/>\n  <log message="$(var rate)"/>\n</launch>\n'})
    message = "--args-kept is for launch files of ROS 1: in one of ROS 2, any include and any group may change what an arg says"
    assert run(repository, "export", "arg.launch.xml", "--flatten", "--args-kept") == (2, "", f"launchlint: {message}\n")


def test_output_that_cannot_be_written(repository: Path) -> None:
    write(repository, FILES)
    ran = run(repository, "export", "demo/launch/robot.launch", "-o", "no/where.launch")
    message = "launchlint: cannot write the exported file to 'no/where.launch': the directory 'no' does not exist; create it first\n"
    assert ran == (2, "", message)
