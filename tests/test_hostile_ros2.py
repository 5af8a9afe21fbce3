"""Launch files of ROS 2 that are made to crash, to hang or to have something executed: as :mod:`tests.test_hostile` for ROS 1."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.running import Ran, write
from tests.test_hostile import run

PACKAGE = (
    '<package format="3"><name>demo</name><version>1.0.0</version><description>A demo.</description>'
    '<maintainer email="a@b.org">A</maintainer><license>BSD</license><export><build_type>ament_cmake</build_type></export></package>\n'
)
BUILD = "add_executable(talk talk.cpp)\ninstall(TARGETS talk DESTINATION lib/demo)\n"
NODE = '<node pkg="demo" exec="talk" name="n{}"/>'
COMPONENT = '<composable_node pkg="demo" plugin="a::B" name="c{}" namespace=""/>'
WITH_FILE = (
    '<launch><node pkg="demo" exec="talk" name="n"><param from="$(dirname)/p.yaml"/></node>'
    '<node_container pkg="demo" exec="talk" name="c" namespace=""><composable_node pkg="demo" plugin="a::B" name="d" namespace="">'
    '<param from="$(dirname)/p.yaml"/></composable_node></node_container><set_parameters_from_file filename="$(dirname)/p.yaml"/>'
    '<node pkg="demo" exec="talk" name="e"><param from="$(dirname)/p.yaml" allow_substs="true"/></node></launch>'
)


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    directory = tmp_path / "repository"
    write(directory, {".git/HEAD": "", "demo/package.xml": PACKAGE, "demo/CMakeLists.txt": BUILD})
    return directory


def check(repository: Path, text: str | bytes, name: str = "x.launch.xml") -> Ran:
    (repository / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    return run(repository, "check", "-v", "--format", "concise", "--no-cache", name)


def many(count: int, line: str, start: str = "") -> str:
    return f"<launch>{start}{''.join(line.replace('{}', str(number)) for number in range(count))}</launch>"


def settings(line: str) -> str:
    return "".join(line.replace("{}", str(number)) for number in range(2_000))


def nested(opening: str, inner: str, closing: str, depth: int) -> str:
    return opening * depth + inner + closing * depth


@pytest.mark.parametrize(
    "text",
    [
        many(10_000, NODE),
        many(10_000, '<arg name="a{}" default="1"/>'),
        many(10_000, '<let name="a{}" value="$(var a{})"/>'),
        many(100, '<let name="a" value="$(var a)$(var a)"/>', '<let name="a" value="xx"/>'),
        many(2_000, '<arg name="a{}" default="false"/><group if="$(var a{})"><node pkg="demo" exec="talk" name="n{}"/></group>'),
        many(2_000, NODE, settings('<set_remap from="a{}" to="b{}"/>')),
        many(2_000, NODE, settings('<set_env name="a{}" value="b{}"/>')),
        many(5_000, '<push_ros_namespace namespace="a{}"/>'),
        many(5_000, '<include file="nowhere{}.launch.xml"/>'),
        f'<launch><node_container pkg="demo" exec="talk" name="n" namespace="">{settings(COMPONENT)}</node_container></launch>',
        many(2_000, f'<timer period="1.0">{NODE}</timer>'),
        f"<launch>{nested('<group>', NODE, '</group>', 100_000)}</launch>",
        f'<launch><let name="a" value="{nested("$(var ", "a", ")", 100_000)}"/></launch>',
        f'<launch><let name="a" value="{"$(var " * 500_000}"/></launch>',
        f'<launch><let name="a" value="{"$(dirname)" * 200_000}"/></launch>',
        f'<launch><let name="a" value="{"$(find-pkg-share demo)" * 50_000}"/></launch>',
        f'<launch><include file="{"$(find-pkg-share demo)" * 50_000}/a.launch.xml"/></launch>',
        f'<launch><let name="a" value="$(file-content {"$(find-pkg-share demo)" * 50_000})"/></launch>',
        f'<launch><node pkg="demo" exec="talk" name="n" args="--ros-args {"-p a:=1 " * 20_000}"/></launch>',
        f'<launch><node pkg="{"a" * 2_000_000}" exec="{"b" * 2_000_000}" name="n"/></launch>',
    ],
    ids=["nodes", "args", "names nobody set", "doubling", "conditions", "remaps", "env", "namespaces", "includes", "components", "timers",
         "groups", "nested", "open", "dirname", "share", "long include", "long file", "arguments", "long names"],
)  # fmt: skip
def test_great_numbers(repository: Path, text: str) -> None:
    check(repository, text)


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("launch:\n- " + nested("{group: [", "", "]}", 50_000), "LL100"),
        ("launch: " + nested("[", "", "]", 100_000), "LL100"),
        ("launch: &a\n- group: *a\n", "LL100"),
        (
            "launch:\n- group: &a0 [{log: {message: x}}]\n"
            + "".join(f"- group: &a{n + 1} [{','.join([f'{{group: *a{n}}}'] * 9)}]\n" for n in range(12)),
            "LL100",
        ),
        ("launch: !!python/object/apply:os.system ['touch owned']\n", "LL101"),
        ("launch: []\n---\n" * 5_000, "LL101"),
        ("launch:\n- log: {message: \0}\n", "LL101"),
        (b"\xff\xfe\x00launch: []", "LL101"),
        ("", "LL102"),
        ("launch:\n- arg: {name: a, default: " + "9" * 1_000_000 + "}\n", "LL101"),
        ("launch:\n" + "- nod: {}\n" * 5_000, "LL103"),
    ],
    ids=["groups", "brackets", "circle", "bomb", "tag", "documents", "nul", "bytes", "empty", "digits", "unknown"],
)
def test_yaml(repository: Path, text: str | bytes, rule: str) -> None:
    ran = check(repository, text, "x.launch.yaml")
    assert (ran.status, ran.output.split(" ")[2]) == (1, rule)
    assert not (repository / "owned").exists()


@pytest.mark.parametrize(
    "text",
    [
        "".join(f"k{n}: {{ros__parameters: {{a: 1}}}}\n" for n in range(5_000)),
        "/**:\n  ros__parameters: " + nested("{a: ", "", "}", 50_000),
        f"'{'/**' * 2_000}/x': {{ros__parameters: {{a: 1}}}}\n",
        "/**:\n  ros__parameters: {a: [" + "1, " * 50_000 + "1]}\n",
        "a: &a [x,x,x,x]\n" + "".join(f"b{n}: &b{n} [*{f'b{n - 1}' if n else 'a'}, *a]\n" for n in range(50)),
        "/**: {ros__parameters: {a: 1e" + "9" * 100_000 + "}}\n",
        "/**: {ros__parameters: {a: !!python/object/apply:os.system ['touch owned']}}\n",
        "\0\x1b\u202e: 1",
    ],
    ids=["keys", "deep", "wild", "list", "bomb", "exponent", "tag", "letters"],
)
def test_parameter_files(repository: Path, text: str) -> None:
    (repository / "p.yaml").write_text(text)
    check(repository, WITH_FILE)
    assert not (repository / "owned").exists()


def test_includes_in_circles_and_diamonds(repository: Path) -> None:
    again = '<include file="$(dirname)/{}.launch.xml"/>'
    write(repository, {f"f{level}.launch.xml": f"<launch>{again.format(f'f{level + 1}') * 2}</launch>" for level in range(30)})
    write(repository, {"f30.launch.xml": f"<launch>{NODE}</launch>", "self.launch.xml": f"<launch>{again.format('self')}</launch>"})
    write(repository, {"a.launch.xml": f"<launch>{again.format('b')}</launch>", "b.launch.xml": f"<launch>{again.format('a')}</launch>"})
    for name, rule in (("self", "LL402"), ("a", "LL402"), ("f0", "LL216")):
        assert rule in run(repository, "check", "--no-cache", "--format", "concise", f"{name}.launch.xml").output, name


@pytest.mark.parametrize(
    "expression",
    [
        "9**9**9", "'a' * 999999999", "(" * 5_000 + "1" + ")" * 5_000, "sum(range(10**9))", "[x for x in range(10**9)]", "factorial(10**7)",
        "'%999999999d' % 1", "__import__('os').system('touch owned')", "open('owned', 'w')", "().__class__.__bases__[0].__subclasses__()",
    ],
)  # fmt: skip
def test_expressions(repository: Path, expression: str) -> None:
    """Bounded, told as not computed, and nothing is executed."""
    ran = check(repository, f'<launch><let name="a" value="$(eval &quot;{expression}&quot;)"/></launch>')
    assert (ran.status, "launchlint does not compute this" in ran.output) == (0, True)
    assert not (repository / "owned").exists()


@pytest.mark.parametrize("words", [("check", "--no-cache"), ("model",), ("graph",), ("format", "--diff")])
def test_nothing_is_executed(repository: Path, words: tuple[str, ...]) -> None:
    touch = f"touch {repository}/owned"
    write(
        repository,
        {
            "x.launch.xml": f"""<launch><let name="a" value="$(command '{touch}')"/>
                <node pkg="demo" exec="talk" name="n" launch-prefix="{touch};"><param name="p" value="$(command '{touch}')"/></node>
                <executable cmd="{touch}" shell="true"/></launch>""",
            "y.launch.yaml": f"launch:\n- let: {{name: a, value: \"$(command '{touch}')\"}}\n- executable: {{cmd: '{touch}'}}\n",
        },
    )
    for file in ("x.launch.xml", "y.launch.yaml"):
        run(repository, *words, file)
        assert not (repository / "owned").exists(), file
