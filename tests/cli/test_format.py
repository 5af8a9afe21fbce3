"""``launchlint format`` as people and editors call it."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

from tests.cli.running import Ran, run, write

UGLY = '<launch>\n    <node type="talk.py" pkg="demo" name="talker" />\n</launch>\n'
TIDY = '<launch>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'
BROKEN = "<launch>\n  <group>\n</launch>\n"

DIFFERENCE = """\
--- a/demo/launch/ugly.launch
+++ b/demo/launch/ugly.launch
@@ -1,3 +1,3 @@
 <launch>
-    <node type="talk.py" pkg="demo" name="talker" />
+  <node name="talker" pkg="demo" type="talk.py"/>
 </launch>
"""


@pytest.fixture
def launch(repository: Path) -> Path:
    """The directory of a package's launch files: one in normal form, one not."""
    directory = repository / "demo" / "launch"
    for file in directory.iterdir():
        file.unlink()
    write(directory, {"tidy.launch": TIDY, "ugly.launch": UGLY})
    return directory


def test_files_are_rewritten(repository: Path, launch: Path) -> None:
    assert run(repository, "format") == Ran(
        0, "formatted demo/launch/ugly.launch\n", "launchlint: 1 launch file formatted, 1 launch file in normal form already\n"
    )
    assert (launch / "ugly.launch").read_text() == TIDY
    assert run(repository, "format") == Ran(0, "", "launchlint: 2 launch files in normal form already\n")


def test_check_changes_nothing_and_lists(repository: Path, launch: Path) -> None:
    assert run(repository, "format", "--check") == Ran(
        1, "would format demo/launch/ugly.launch\n", "launchlint: 1 launch file would be formatted, 1 launch file in normal form already\n"
    )
    assert run(repository, "format", "--check", "-q") == Ran(1, "", "")
    assert run(repository, "format", "--check", "demo/launch/tidy.launch").status == 0
    assert (launch / "ugly.launch").read_text() == UGLY


def test_diff_shows_what_would_change(repository: Path, launch: Path) -> None:
    assert run(repository, "format", "--diff", "demo/launch/ugly.launch") == Ran(
        1, DIFFERENCE, "launchlint: 1 launch file would be formatted\n"
    )
    colored = run(repository, "format", "--diff", "--color", "always", "demo/launch/ugly.launch").output
    assert "\x1b[32m+  <node name=" in colored
    assert "\x1b[31m-    <node type=" in colored
    assert (launch / "ugly.launch").read_text() == UGLY


def test_diff_is_harmless_on_a_terminal(repository: Path, launch: Path) -> None:
    write(launch, {"ugly.launch": "<launch>\n<!-- \u202e\u0085 \t<x -->\n</launch>"})
    assert run(repository, "format", "--diff", "demo/launch/ugly.launch").output == (
        "--- a/demo/launch/ugly.launch\n+++ b/demo/launch/ugly.launch\n@@ -1,3 +1,3 @@\n <launch>\n-<!-- \\u202e\\x85 \t<x -->\n"
        "-</launch>\n\\ No newline at end of file\n+  <!-- \\u202e\\x85 \t<x -->\n+</launch>\n"
    )


def test_standard_input_goes_to_standard_output(repository: Path) -> None:
    assert run(repository, "format", "-", stdin=UGLY) == Ran(0, TIDY, "")
    assert run(repository, "format", "-", "--stdin-filename", "demo/launch/x.launch", stdin=UGLY) == Ran(0, TIDY, "")
    assert run(repository, "format", "--check", "-", stdin=UGLY) == Ran(1, "would format stdin.launch\n", "")
    assert run(repository, "format", "--check", "-", stdin=TIDY) == Ran(0, "", "")


def test_standard_input_keeps_its_encoding_and_line_ends(repository: Path) -> None:
    text = "\ufeff<launch>\r\n<arg name='é'/>\r\n</launch>\r\n"
    assert run(repository, "format", "-", stdin=text).output == '\ufeff<launch>\r\n  <arg name="é"/>\r\n</launch>\r\n'


def test_what_cannot_be_read_is_left_alone_and_told(repository: Path, launch: Path) -> None:
    write(launch, {"broken.launch": BROKEN})
    finding = "demo/launch/broken.launch:2:3: error LL101 malformed-xml: not well-formed XML: <group> is never closed\n"
    ran = run(repository, "format")
    assert ran == Ran(
        2,
        "formatted demo/launch/ugly.launch\n",
        f"{finding}launchlint: 1 launch file formatted, 1 launch file in normal form already, 1 launch file left alone\n",
    )
    assert (launch / "broken.launch").read_text() == BROKEN
    assert run(repository, "format", "-", stdin=BROKEN) == Ran(2, "", finding.replace("demo/launch/broken.launch", "stdin.launch"))


def test_a_file_that_is_no_launch_file_is_left_alone(repository: Path) -> None:
    before = (repository / "demo/package.xml").read_bytes()
    ran = run(repository, "format", "demo/package.xml")
    assert (ran.status, ran.output) == (2, "")
    assert ran.errors.startswith("demo/package.xml:1:2: error LL102 root-not-launch: ")
    assert (repository / "demo/package.xml").read_bytes() == before


def test_a_link_that_leaves_the_repository_is_not_followed_to_write(repository: Path, launch: Path, tmp_path: Path) -> None:
    outside = tmp_path / "outside.launch"
    outside.write_text(UGLY)
    (launch / "ugly.launch").unlink()
    (launch / "ugly.launch").symlink_to(outside)
    ran = run(repository, "format", "demo/launch/ugly.launch")
    assert ran.status == 2
    assert "'demo/launch/ugly.launch' is left as it is: it lies outside of" in ran.errors
    assert ran.errors.endswith("launchlint: 1 launch file left alone\n")
    assert outside.read_text() == UGLY


def test_permissions_stay(repository: Path, launch: Path) -> None:
    (launch / "ugly.launch").chmod(0o640)
    assert run(repository, "format").status == 0
    assert (launch / "ugly.launch").stat().st_mode & 0o777 == 0o640


def test_configuration(repository: Path, launch: Path) -> None:
    write(repository, {".launchlint.yaml": "format: {indent: 4, line-width: 40, sort-attributes: false}\nexclude: [tidy.launch]\n"})
    expected = '<launch>\n    <node type="talk.py"\n          pkg="demo"\n          name="talker"/>\n</launch>\n'
    assert run(repository, "format", "-", stdin=UGLY).output == expected
    assert run(repository, "format").errors == "launchlint: 1 launch file formatted\n"
    assert (launch / "ugly.launch").read_text() == expected


def test_args_are_sorted_where_the_project_wants_it_and_nothing_changes(repository: Path, launch: Path) -> None:
    text = '<launch>\n  <param name="p" value="1"/>\n{}  <arg name="a" default="1"/>\n</launch>\n'
    write(launch, {"tidy.launch": text.format(""), "ugly.launch": text.format('  <param name="q" value="$(arg a)"/>\n')})
    assert run(repository, "format").errors == "launchlint: 2 launch files in normal form already\n"
    write(repository, {".launchlint.yaml": "format: {sort-args: true}\n"})
    assert run(repository, "format").output == "formatted demo/launch/tidy.launch\n"
    assert (launch / "tidy.launch").read_text() == ('<launch>\n  <arg name="a" default="1"/>\n  <param name="p" value="1"/>\n</launch>\n')
    assert run(repository, "format").output == ""


def test_test_files_and_machine_files_are_launch_files(repository: Path, launch: Path) -> None:
    write(
        launch,
        {
            "ugly.launch": TIDY,
            "a.test": '<launch><test type="t" pkg="p" test-name="x"/></launch>',
            "robot.machine.xml": '<launch><machine address="here" name="m"/></launch>',
            "other.xml": "<robot><a/></robot>",
        },
    )
    assert run(repository, "format").output == "formatted demo/launch/a.test\nformatted demo/launch/robot.machine.xml\n"
    assert (launch / "a.test").read_text() == '<launch>\n  <test test-name="x" pkg="p" type="t"/>\n</launch>\n'
    assert (launch / "robot.machine.xml").read_text() == '<launch>\n  <machine name="m" address="here"/>\n</launch>\n'


@pytest.mark.parametrize(
    ("stands", "moved"),
    [
        ('<node pkg="demo" exec="talk"/><arg name="a" default="1"/><node pkg="demo" exec="$(var a)"/>', ["arg", "node", "node"]),
        ('<let name="a" value="2"/><arg name="a" default="1"/>', None),  # the arg would set it
        ('<set_env name="A" value="2"/><arg name="a" default="$(env A 1)"/>', None),
        ('<group><node pkg="demo" exec="talk"/><arg name="a" default="1"/></group>', ["group", "arg", "node"]),
        ('<node pkg="demo" exec="talk"/><arg name="a" default="$(command x)"/>', ["arg", "node"]),
        # a condition that is not met as the file is started alone
        (
            '<arg name="s" default="0"/><let name="a" value="2" if="$(var s)"/><arg name="a" default="1"/><log message="$(var a)"/>',
            None,
        ),
    ],
)
def test_args_of_ros2_are_sorted_where_nothing_changes(stands: str, moved: list[str] | None, repository: Path, launch: Path) -> None:
    write(launch, {"tidy.launch": TIDY, "ugly.launch": TIDY, "a.launch.xml": f"<launch>{stands}</launch>\n"})
    write(repository, {".launchlint.yaml": "format: {sort-args: true}\n"})
    assert run(repository, "format").status == 0
    found = re.findall(r"<([a-z_]+)", (launch / "a.launch.xml").read_text())[1:]
    assert found == (re.findall(r"<([a-z_]+)", stands) if moved is None else moved)


SORTED_IN_YAML = {
    "comments": (
        """\
# a robot
launch:
# what is said first
- log: {message: hello}

# how fast
- arg: {name: rate, default: "5"}   # Hz

- arg:
    name: level
    default: "1"
    # deeper: of the arg
# about what follows
- group:
  - log: {message: $(var rate)}
  # of both
  - arg: {name: two, default: $(var rate)}
  - log: {message: $(var two)}
""",
        """\
# a robot
launch:
# how fast
- arg: {name: rate, default: "5"}   # Hz
- arg:
    name: level
    default: "1"
    # deeper: of the arg
# what is said first
- log: {message: hello}

# about what follows
- group:
  - arg: {name: two, default: $(var rate)}
  - log: {message: $(var rate)}
  # of both
  - log: {message: $(var two)}
""",
    ),
    "children": (
        """\
launch:
- group:
    scoped: "false"
    children:
    - log: {message: hello}
    - arg: {name: a, default: "1"}
""",
        """\
launch:
- group:
    scoped: "false"
    children:
    - arg: {name: a, default: "1"}
    - log: {message: hello}
""",
    ),
    "one that uses what is set before it": (
        """\
launch:
- let: {name: x, value: "3"}
- arg: {name: y, default: $(var x)}
- arg: {name: z, default: "4"}
""",
        """\
launch:
- arg: {name: z, default: "4"}
- let: {name: x, value: "3"}
- arg: {name: y, default: $(var x)}
""",
    ),
}
STAYS_IN_YAML = {
    "in brackets": 'launch: [{log: {message: hello}}, {arg: {name: a, default: "1"}}]\n',
    "a word to launchlint": "launch:\n- log: {message: hello}\n# launchlint: ignore[LL206] later\n- arg: {name: a, default: '1'}\n",
    "an anchor": "launch:\n- log: {message: &said hello}\n- arg: {name: a, default: *said}\n",
    "of an include": "launch:\n- include:\n    file: $(dirname)/b.launch.yaml\n    arg:\n    - {name: a, value: '1'}\n",
}


@pytest.mark.parametrize(("before", "after"), SORTED_IN_YAML.values(), ids=SORTED_IN_YAML)
def test_args_in_yaml_go_up_with_their_comments(before: str, after: str, repository: Path, launch: Path) -> None:
    write(launch, {"tidy.launch": TIDY, "ugly.launch": TIDY, "a.launch.yaml": before, "b.launch.yaml": "launch: []\n"})
    write(repository, {".launchlint.yaml": "format: {sort-args: true}\n"})
    assert run(repository, "format").output == "formatted demo/launch/a.launch.yaml\n"
    assert (launch / "a.launch.yaml").read_text() == after
    assert run(repository, "format").output == ""


@pytest.mark.parametrize("text", STAYS_IN_YAML.values(), ids=STAYS_IN_YAML)
def test_args_in_yaml_stay_where_nothing_is_proved(text: str, repository: Path, launch: Path) -> None:
    write(launch, {"tidy.launch": TIDY, "ugly.launch": TIDY, "a.launch.yaml": text, "b.launch.yaml": "launch: []\n"})
    write(repository, {".launchlint.yaml": "format: {sort-args: true}\n"})
    assert run(repository, "format").status == 0
    assert (launch / "a.launch.yaml").read_text() == text


def test_files_of_ros2_are_formatted_and_their_args_stay(repository: Path, launch: Path) -> None:
    node, rest = '<node exec="talker" pkg="demo" name="a" namespace="b"/>', '<let name="a" value="b"/><arg name="c" default="$(var a)"/>'
    other = f"<launch>{node}{rest}</launch>"
    write(launch, {"ugly.launch": other})
    write(repository, {".launchlint.yaml": "format: {sort-args: true}\n", "demo/launch/b.launch.py": ""})
    ran = run(repository, "format")
    assert (ran.status, ran.output) == (0, "formatted demo/launch/ugly.launch\n")
    assert "left out the launch file demo/launch/b.launch.py" in ran.errors
    tags = [line.split()[0] for line in (launch / "ugly.launch").read_text().splitlines()]
    assert tags == ["<launch>", "<node", "<let", "<arg", "</launch>"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("missing.launch",), "missing.launch: No such file or directory; give launch files, or directories to search for them"),
        (("-", "a.launch"), "- stands for standard input and cannot be mixed with other paths; check them in two calls"),
        (("--stdin-filename", "a.launch"), "--stdin-filename names standard input; give - as the path too"),
    ],
)
def test_wrong_usage_is_one_message(repository: Path, words: tuple[str, ...], message: str) -> None:
    assert run(repository, "format", *words) == Ran(2, "", f"launchlint: {message}\n")


def test_a_file_that_cannot_be_read_is_told(repository: Path, launch: Path) -> None:
    os.mkfifo(launch / "pipe.launch")
    ran = run(repository, "format", "demo/launch/pipe.launch")
    assert ran == Ran(2, "", "launchlint: demo/launch/pipe.launch: it is not a plain file\nlaunchlint: 1 launch file left alone\n")
