"""Whatever a repository holds: a clear finding or error, bounded time and memory, no traceback, nothing read or run that must not be.

Each check is a process of its own with 1 GiB of address space and a minute of processor.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from xml.dom.minidom import parseString

import pytest

from tests.cli.forking import forks
from tests.cli.running import CLEAN, DOUBLE, PACKAGE, Ran, clean_environment, write

MEMORY = 1 << 30
SECONDS = 60
FORMATS = ("text", "concise", "json", "jsonl", "sarif", "github", "gitlab", "junit")
FORBIDDEN = re.compile(rb"[\x00-\x09\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\x8b-\x8f\xa8-\xae]|\xe2\x81[\xa6-\xa9]|\xef\xbb\xbf")
"""Control characters but the line feed, bidi and zero-width marks, line separators, byte order marks."""
NODE = '<node name="{}" pkg="demo" type="talk.py"/>'


def run(directory: Path, *words: str, stdin: bytes = b"") -> Ran:
    """Run launchlint in ``directory`` within the limits; what it prints must be harmless, and no traceback."""
    environment = clean_environment(directory.parent / "cache")
    status, output, errors = forks().run(directory, words, environment, stdin, seconds=SECONDS, memory=MEMORY)
    assert b"Traceback" not in errors
    assert b"itself failed" not in errors
    assert b"LL000" not in output
    assert FORBIDDEN.search(output) is None, output[:2000]
    assert FORBIDDEN.search(errors) is None, errors[:2000]
    assert status in (0, 1, 2)
    return Ran(status, output.decode(), errors.decode())


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    directory = tmp_path / "repository"
    write(directory, {".git/HEAD": "", "demo/package.xml": PACKAGE.format(name="demo"), "demo/scripts/talk.py": "#!/usr/bin/env python3\n"})
    return directory


def check(repository: Path, text: str | bytes, *words: str) -> Ran:
    """Check one launch file ``x.launch`` with this content."""
    (repository / "x.launch").write_bytes(text if isinstance(text, bytes) else text.encode())
    return run(repository, "check", "-v", "--format", "concise", "--no-cache", *words, "x.launch")


def bomb(levels: int = 12) -> str:
    entities = "".join(f'<!ENTITY a{level} "{f"&a{level - 1};" * 10}">' for level in range(1, levels))
    return f'<!DOCTYPE launch [<!ENTITY a0 "aaaaaaaaaa">{entities}]>'


FAR_MORE = "x.launch:1:19: error LL101 malformed-xml: not well-formed XML: the entities of this file expand to far more than is written\n"


@pytest.mark.parametrize(
    "text",
    [
        bomb() + '<launch><param name="x" value="&a11;"/></launch>',
        bomb() + "<launch>&a11;</launch>",
        '<!DOCTYPE launch [<!ENTITY a "' + "a" * 100_000 + '">]><launch>' + '<param name="x" value="&a;"/>' * 1000 + "</launch>",
        '<!DOCTYPE launch [<!ENTITY a "&b;"><!ENTITY b "&a;">]><launch>&a;</launch>',
    ],
    ids=["attribute", "text", "quadratic", "circle"],
)
def test_entity_bombs(repository: Path, text: str) -> None:
    ran = check(repository, text)
    assert (ran.status, ran.output.startswith("x.launch:1:"), "LL101" in ran.output) == (1, True, True)


@pytest.mark.parametrize(
    "text",
    [
        '<!DOCTYPE launch [<!ENTITY x SYSTEM "file://{secret}">]><launch><param name="p" value="v">&x;</param>&x;</launch>',
        '<!DOCTYPE launch SYSTEM "file://{secret}"><launch/>',
        '<!DOCTYPE launch [<!ENTITY % p SYSTEM "file://{secret}">%p;]><launch/>',
        '<!DOCTYPE launch PUBLIC "-//X//Y" "http://127.0.0.1:9/evil.dtd"><launch/>',
        '<launch xmlns:xi="http://www.w3.org/2001/XInclude"><xi:include href="file://{secret}" parse="text"/></launch>',
    ],
    ids=["entity", "dtd", "parameter entity", "network", "xinclude"],
)
def test_nothing_external_is_read(repository: Path, tmp_path: Path, text: str) -> None:
    secret = tmp_path / "secret.txt"
    secret.write_text("TOPSECRET")
    (repository / "x.launch").write_text(text.replace("{secret}", str(secret)))
    for words in (["check", "--no-cache", "--format", "json", "x.launch"], ["model", "--format", "json", "x.launch"]):
        ran = run(repository, *words)
        assert "TOPSECRET" not in ran.output + ran.errors


def test_include_cycles(repository: Path) -> None:
    write(
        repository,
        {
            "self.launch": '<launch><include file="$(dirname)/self.launch"/></launch>',
            "a.launch": '<launch><include file="$(dirname)/b.launch"/></launch>',
            "b.launch": '<launch><include file="$(dirname)/a.launch"/></launch>',
            "grows.launch": '<launch><arg name="x" default="x"/><include file="$(dirname)/grows.launch">'
                            '<arg name="x" value="$(arg x)x"/></include></launch>',
            "doubles.launch": '<launch><arg name="x" default="x"/><include file="$(dirname)/doubles.launch">'
                              '<arg name="x" value="$(arg x)$(arg x)"/></include></launch>',
            "deepens.launch": '<launch><include file="$(dirname)/deepens.launch" ns="deeper"/></launch>',
        },
    )  # fmt: skip
    for name, rule in (("self", "LL402"), ("a", "LL402"), ("grows", "LL402"), ("doubles", "LL216"), ("deepens", "LL402")):
        assert rule in run(repository, "check", "--format", "concise", f"{name}.launch").output, name
    assert run(repository, "model", "--format", "json", ".").status == 1


def test_includes_that_multiply(repository: Path) -> None:
    """Thirty files, each of which includes the next one twice: a thousand million copies of the last."""
    both = '<include file="$(dirname)/f{0}.launch" ns="a"/><include file="$(dirname)/f{0}.launch" ns="b"/>'
    write(repository, {f"f{level}.launch": f"<launch>{both.format(level + 1)}</launch>" for level in range(30)})
    write(repository, {"f30.launch": f"<launch>{NODE.format('n')}</launch>"})
    assert "LL216 evaluation-bound" in run(repository, "check", "--format", "concise", "f0.launch").output


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("depth", [10_000, 100_000])
def test_deep_nesting(repository: Path, depth: int, closed: bool) -> None:
    ran = check(repository, "<launch>" + "<group>" * depth + ("</group>" * depth + "</launch>" if closed else ""))
    assert (ran.status, "LL101" in ran.output) == (1, True)


def test_nesting_that_roslaunch_loads(repository: Path) -> None:
    """What is nested less deeply than its own bound is evaluated, whatever Python's is."""
    ran = check(repository, "<launch>" + "<group>" * 200 + NODE.format("n") + "</group>" * 200 + "</launch>")
    assert ran == (0, "", "")


Piece = tuple[str, int]
"""A text and how often it stands in a row: the files are made in the test that needs them."""


def build(pieces: list[Piece]) -> str:
    return "".join(text * count for text, count in pieces)


@pytest.mark.parametrize(
    ("pieces", "rule"),
    [
        ([("<launch><!--", 1), ("x", 50_000_000), ("--></launch>", 1)], "LL100"),
        ([("<launch>", 1), ('<nod name="a"/>', 3_400_000), ("</launch>", 1)], "LL100"),
        ([("\0", 50_000_000)], "LL100"),
        ([("<launch>", 1), ('<nod name="a"/>', 2_000_000), ("</launch>", 1)], "LL100"),
        ([("<launch>", 1), ('<nod name="a"/>\n', 1_900_000), ("</launch>", 1)], "LL100"),
        ([("<launch>", 1), ("x <a/>", 3_000_000), ("</launch>", 1)], "LL100"),
        ([("\0", 31_000_000)], "LL101"),
        ([("<launch>", 1), ("<", 31_000_000)], "LL101"),
        ([("<launch>", 1), ("x", 31_000_000)], "LL101"),
        ([('<launch><param name="', 1), ("x", 31_000_000)], "LL101"),
    ],
    ids=lambda value: value[0][0][:1] + value[-1][0][:12] if isinstance(value, list) else value,
)
def test_huge_files(repository: Path, pieces: list[Piece], rule: str) -> None:
    ran = check(repository, build(pieces))
    assert (ran.status, ran.output.split()[2]) == (1, rule)
    assert len(ran.output) < 2_000


@pytest.mark.parametrize(
    "pieces",
    [
        [("<launch><!--", 1), ("x", 31_000_000), ("--></launch>", 1)],
        [('<launch><param name="a" value="', 1), ("&lt;", 7_000_000), ('"/></launch>', 1)],
        [('<launch><param name="a" value="', 1), ("$(dirname)", 2_000_000), ('"/></launch>', 1)],
        [('<launch><param name="a" value="', 1), ("$(find demo)", 2_000_000), ('"/></launch>', 1)],
        [('<launch><param name="a" value="$(eval ', 1), ("1+", 5_000_000), ('1)"/></launch>', 1)],
        [('<launch><param name="a" value="', 1), ("(", 5_000_000), ('"/></launch>', 1)],
        [('<launch><param name="a" value="', 1), ("$(", 5_000_000), ('"/></launch>', 1)],
        [("<launch>", 1), ("<!-- launchlint -->", 100_000), ("</launch>", 1)],
        [("<launch>", 1), ("<!-- launchlint: ignore[LL301] x -->", 50_000), (NODE.format("n"), 1), ("</launch>", 1)],
        [("<!-- launchlint: ignore-file[", 1), ("LL301,", 300_000), ("] x --><launch/>", 1)],
    ],
    ids=["comment", "entities", "dirname", "find", "eval", "brackets", "dollars", "comments", "suppressions", "suppressed rules"],
)
def test_huge_but_small_enough(repository: Path, pieces: list[Piece]) -> None:
    check(repository, build(pieces))


@pytest.mark.parametrize(
    "expression",
    [
        "9**9**9",
        "'a' * 999999999",
        "[0] * 999999999",
        "1 &lt;&lt; 999999999",
        "(" * 5000 + "1" + ")" * 5000,
        "-" * 100_000 + "1",
        "not " * 100_000 + "1",
        "1" * 1_000_000,
        "range(10**12)",
        "sum(range(10**9))",
        "'%999999999d' % 1",
        "'{:999999999}'.format(1)",
        "'a'.ljust(999999999)",
        "'a'.join('b' * 100000 for x in 'c' * 100000)",
        "[x for x in range(10**9)]",
        "int('9' * 100000) ** 9",
        "str(10**100000)",
        "round(1.5, 10**10)",
        "'a'.replace('', 'b' * 10**9)",
        "__import__('os').system('touch owned')",
        "().__class__.__bases__[0].__subclasses__()",
        "open('owned', 'w')",
        "exec('open(\\'owned\\', \\'w\\')')",
        "arg('x').__class__",
        "lambda: 0",
    ],
)
def test_expressions(repository: Path, expression: str) -> None:
    """Bounded, and whatever they try, nothing is executed."""
    expression = expression.replace('"', "&quot;")
    check(repository, f'<launch><arg name="x" default="1"/><param name="p" value="$(eval {expression})"/></launch>')
    assert not (repository / "owned").exists()


@pytest.mark.parametrize(
    "text",
    [
        "a: &a [x,x,x,x,x,x,x,x,x]\n"
        + "".join(f"{chr(98 + n)}: &{chr(98 + n)} [{','.join([f'*{chr(97 + n)}'] * 9)}]\n" for n in range(12)),
        "a: &a {x: 1}\n" + "".join(f"b{n}: &b{n} {{<<: [*{'a' if not n else f'b{n - 1}'}, *a]}}\n" for n in range(500)),
        "a: &a [*a]\n",
        "a: " + "[" * 50_000 + "]" * 50_000,
        "a: " + "{a: " * 50_000 + "}" * 50_000,
        "".join(f"{' ' * n}a:\n" for n in range(2_000)),
        "".join(f"k{n}: {n}\n" for n in range(300_000)),
        "a: " + "9" * 1_000_000,
        "a: 1:" + "59:" * 100_000 + "1",
        "a: " + "1e" + "9" * 100_000,
        "a: !!python/object/apply:os.system ['touch owned']\n",
        "a: !!binary " + "A" * 1_000_000,
        "? " * 10_000,
        "a: '" + "x" * 5_000_000,
        "a: 2001-01-01T00:00:00" + "." + "9" * 100_000,
        "a: deg(" + "9*" * 100_000 + "9)",
        "a: rad(__import__('os').system('touch owned'))",
        "\0\x1b\u202e: 1",
        "%YAML 99.9\n---\na: 1",
    ],
)
def test_yaml(repository: Path, text: str) -> None:
    """Bombs and depths in files that launch files load."""
    (repository / "x.yaml").write_text(text)
    check(repository, '<launch><rosparam file="$(dirname)/x.yaml"/></launch>')
    run(repository, "model", "x.launch")
    assert not (repository / "owned").exists()


def many(count: int, line: str, start: str = "") -> str:
    return "<launch>" + start + "".join(line.replace("{}", str(number)) for number in range(count)) + "</launch>"


@pytest.mark.parametrize(
    "text",
    [
        many(50_000, NODE + "\n"),
        many(50_000, NODE),
        many(50_000, '<node name="n" pkg="demo" type="talk.py"/>'),
        many(50_000, '<arg name="a{}" default="1"/>\n'),
        many(50_000, '<param name="p{}" value="1"/>'),
        many(20_000, '<node name="n{}" pkg="demo" type="nothing.py"/>'),
        many(3_000, '<arg name="a{}" default="0"/><group if="$(arg a{})"><node name="n{}" pkg="demo" type="talk.py"/></group>'),
        many(3_000, NODE, "".join(f'<remap from="a{n}" to="b{n}"/>' for n in range(3_000))),
        many(3_000, NODE, "".join(f'<env name="a{n}" value="b{n}"/>' for n in range(3_000))),
        many(3_000, NODE, "".join(f'<param name="~a{n}" value="b{n}"/>' for n in range(3_000))),
        many(30_000, '<remap from="a{}" to="b"/>' + NODE),
        many(30_000, '<test test-name="t{}" name="t{}" pkg="demo" type="talk.py"/>'),
        many(30_000, '<machine name="m{}" address="a"/>'),
        many(30_000, '<include file="nowhere{}.launch"/>'),
        many(20_000, '<param name="a/' + "b/" * 50 + '{}" value="1"/>'),
        many(5_000, '<param name="a' + "/b" * 20 + '{}" value="$(arg nothing)"/>'),
        '<launch><node name="a" pkg="demo" type="talk.py" ' + " ".join(f'a{n}="1"' for n in range(50_000)) + "/></launch>",
        "<launch>" + "<group>" * 150 + many(3_000, NODE)[8:-9] + "</group>" * 150 + "</launch>",
    ],
    ids=["nodes", "nodes in a line", "same name", "args", "params", "no executable", "conditions", "remaps", "env", "private params",
         "remaps between", "tests", "machines", "includes", "deep params", "undeclared", "attributes", "groups"],
)  # fmt: skip
def test_great_numbers(repository: Path, text: str) -> None:
    check(repository, text)


def test_a_great_number_of_findings_in_every_format_and_in_the_model(repository: Path) -> None:
    write(repository, {"x.launch": many(10_000, '<node name="n" pkg="demo" type="talk.py"/>')})
    for name in FORMATS:
        assert run(repository, "check", "--no-cache", "--format", f"{name}:out", "x.launch").status == 1
    assert run(repository, "model", "x.launch").status == 1
    assert run(repository, "model", "--format", "json", "x.launch").status == 1


@pytest.mark.parametrize(
    "text",
    [
        '<launch><node name="{}" pkg="demo" type="talk.py"/></launch>',
        '<launch><node name="a" pkg="{}" type="talk.py"/></launch>',
        '<launch><node name="a" pkg="demo" type="{}"/></launch>',
        '<launch><node name="a" pkg="demo" type="talk.py" {}="1"/></launch>',
        '<launch><node name="a" pkg="demo" type="talk.py" respawn="{}"/></launch>',
        "<launch><{}/></launch>",
        '<launch><include file="{}"/></launch>',
        '<launch><include file="$(find {})/x.launch"/></launch>',
        '<launch><param name="{}" value="1"/><param name="{}" value="2"/></launch>',
        '<launch><param name="a" type="int" value="{}"/></launch>',
        '<launch><param name="a" value="$(arg {})"/></launch>',
        '<launch><param name="a" value="$(env {})"/></launch>',
        '<launch><param name="a" value="$({} b)"/></launch>',
        '<launch><arg name="{}" default="1"/></launch>',
        '<launch><remap from="{} " to="b"/></launch>',
        '<launch><group if="{}"/></launch>',
        '<launch><machine name="{}" address="a"/><machine name="{}" address="b"/></launch>',
        '<launch><param name="a" command="{}"/></launch>',
        "<launch>{}</launch>",
        "<launch><!-- launchlint: ignore[{}] x --></launch>",
        "<launch><rosparam>{}</rosparam></launch>",
    ],
)
def test_one_enormous_value(repository: Path, text: str) -> None:
    """Five megabytes in one place: told of in a line that can be read."""
    ran = check(repository, text.replace("{}", "a" * 5_000_000))
    assert all(len(line) < 4_000 for line in ran.output.splitlines())
    for name in ("text", "json", "sarif"):
        output = run(repository, "check", "-v", "--no-cache", "--format", name, "x.launch").output
        assert len(output) < 1_000_000, f"{name}: all but what SARIF says of the rules themselves, which is 400 KB, is short"


NASTY = "a\n::error::b\r##[error]c\t\u202eevil\u2066\u2028\u200bd\x7f\x85"
AS_ATTRIBUTE = "".join(f"&#{ord(character)};" for character in NASTY)


@pytest.mark.parametrize("name", FORMATS)
def test_names_with_tricks(repository: Path, name: str) -> None:
    """Newlines and ``::`` (GitHub annotations), ``##[``, control characters, bidi and zero-width marks: shown, never passed on."""
    (repository / "x.launch").write_text(
        f'<launch><node name="{AS_ATTRIBUTE}" pkg="{AS_ATTRIBUTE}" type="{AS_ATTRIBUTE}"/>'
        f'<node name="{AS_ATTRIBUTE}" pkg="demo" type="talk.py" respawn="{AS_ATTRIBUTE}"/><include file="$(dirname)/{AS_ATTRIBUTE}"/>'
        f'<param name="{AS_ATTRIBUTE}" value="$(arg {AS_ATTRIBUTE})"/><arg name="{AS_ATTRIBUTE}" default="1"/></launch>\n'
    )  # fmt: skip
    ran = run(repository, "check", "-v", "--no-cache", "--format", name, "x.launch")
    assert ran.status == 1
    lines = ran.output.splitlines()
    if name == "github":
        assert all(re.match(r"::(?:error|warning|notice) file=", line) for line in lines)
    else:
        assert not any(line.startswith("::") for line in lines)
    assert "##[error]" not in ran.output
    if name in ("json", "sarif", "gitlab"):
        json.loads(ran.output)
    if name == "junit":
        parseString(ran.output)


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize(
    "file",
    [
        b"a\n::error::b.launch",
        b"\x1b[31mred.launch",
        "\u202egnp.launch".encode(),
        b"\xff\xfe.launch",
        b"::warning::a.launch",
        b"##[group]a.launch",
        b"-rf.launch",
        b"a b'\"$(touch owned).launch",
        b"<script>.launch",
        b"%0A::error::.launch",
    ],
)
def test_file_names_with_tricks(repository: Path, name: str, file: bytes) -> None:
    (repository / os.fsdecode(file)).write_text(DOUBLE)
    ran = run(repository, "check", "-v", "--no-cache", "--format", name)
    assert ran.status == 1
    assert "LL301" in ran.output
    if name == "github":
        assert all(re.match(r"::(?:error|warning|notice) file=", line) for line in ran.output.splitlines())
    else:
        assert not any(line.lstrip().startswith("::") for line in ran.output.splitlines())
    if name in ("json", "sarif", "gitlab"):
        json.loads(ran.output)
    if name == "junit":
        parseString(ran.output)


@pytest.mark.parametrize(
    "data",
    [
        b'<launch><node name="\xff\xfe" pkg="demo" type="talk.py"/></launch>',
        b'<?xml version="1.0" encoding="utf-9"?><launch/>',
        b'<?xml version="1.0" encoding="' + b"x" * 100_000 + b'"?><launch/>',
        b"\xff\xfe<\0l\0a",
        b"\xfe\xff\0<",
        b"\xef\xbb\xbf\xef\xbb\xbf<launch/>",
        b"\xff\xfe" + "<launch>\udc80</launch>".encode("utf-16-le", "surrogatepass"),
        b'<?xml version="1.0" encoding="utf-7"?>+ADw-launch/+AD4-',
        b'<?xml version="1.0" encoding="idna"?><launch/>',
        b'<?xml version="1.0" encoding="zlib"?><launch/>',
        b"",
        b"\x1b[31m<launch/>",
        b"\x00",
        b"\x80" * 100,
    ],
)
def test_bytes_that_are_no_text(repository: Path, data: bytes) -> None:
    for name in ("text", "json"):
        (repository / "x.launch").write_bytes(data)
        ran = run(repository, "check", "--no-cache", "--format", name, "x.launch")
        assert ran.status in (0, 1)


def test_directories_and_links_that_are_called_like_launch_files(repository: Path) -> None:
    (repository / "folder.launch").mkdir()
    write(repository, {"folder.launch/inside.launch": DOUBLE})
    (repository / "dangling.launch").symlink_to("nowhere")
    (repository / "itself.launch").symlink_to("itself.launch")
    (repository / "up").symlink_to("..")
    (repository / "loop_a").symlink_to("loop_b")
    (repository / "loop_b").symlink_to("loop_a")
    (repository / "here").symlink_to(".")
    (repository / "there").symlink_to("here/here/here/demo")
    ran = run(repository, "check", "--format", "concise")
    assert ran == (1, "folder.launch/inside.launch:3:15: error LL301 duplicate-node-name: two nodes are named /talker\n", "")
    for name, words in (("dangling", "No such file or directory"), ("itself", "Too many levels of symbolic links")):
        refused = run(repository, "check", f"{name}.launch")
        assert refused == (2, "", f"launchlint: {name}.launch: {words}; give launch files, or directories to search for them\n")
    write(
        repository,
        {"x.launch": many(1, "".join(f'<include file="$(dirname)/{name}.launch"/>' for name in ("folder", "dangling", "itself")))},
    )  # fmt: skip
    assert run(repository, "check", "--format", "concise", "x.launch").output.count("LL401") == 3


def test_what_is_no_plain_file(repository: Path) -> None:
    """Pipes and devices are not waited for, and not read without end."""
    os.mkfifo(repository / "pipe")
    os.mkfifo(repository / "pipe.launch")
    ran = check(
        repository,
        '<launch><include file="$(dirname)/pipe"/><param name="a" textfile="$(dirname)/pipe"/><rosparam file="/dev/zero"/>'
        '<include file="/dev/zero"/><param name="b" binfile="/dev/urandom"/><param name="c" textfile="/proc/self/mem"/></launch>',
    )
    # Two names are asked for twice each, by an include and a param: one finding for both.
    assert [line.split(": ", 2)[2] for line in ran.output.splitlines()] == [
        "the included file pipe does not exist (and at 1 more place)",
        "the file zero does not exist (and at 1 more place)",
        "the file urandom does not exist",
        "the file mem cannot be read: input/output error",
    ]
    assert run(repository, "check", "--format", "concise", "pipe.launch").output.startswith("pipe.launch:1:1: error LL100 unreadable-file")
    run(repository, "check")


def test_unreadable_files_and_directories(repository: Path) -> None:
    """The mode bits say nothing to root, so that the reading itself is made to fail."""
    write(repository, {"locked.launch": CLEAN, "locked.yaml": "a: 1\n", "locked/inside.launch": CLEAN})
    write(repository, {"x.launch": '<launch><include file="$(dirname)/locked.launch"/><rosparam file="$(dirname)/locked.yaml"/></launch>'})
    program = (
        "import builtins, io, os, sys\n"
        "real_open, real_scan, real_os_open = builtins.open, os.scandir, os.open\n"
        "def denied(name):\n"
        "    if 'locked' in os.fspath(name) if isinstance(name, (str, bytes, os.PathLike)) and not isinstance(name, bytes) else False:\n"
        "        raise PermissionError(13, 'Permission denied', name)\n"
        "def opened(name, *rest, **options):\n"
        "    denied(name)\n"
        "    return real_open(name, *rest, **options)\n"
        "def scanned(name='.'):\n"
        "    denied(name)\n"
        "    return real_scan(name)\n"
        "def os_opened(name, *rest, **options):\n"
        "    denied(name)\n"
        "    return real_os_open(name, *rest, **options)\n"
        "builtins.open, os.scandir, os.open = opened, scanned, os_opened\n"
        "from launchlint.cli import main\n"
        "main(sys.argv[1:])\n"
    )
    ran = subprocess.run(
        [sys.executable, "-c", program, "check", "--no-cache", "--format", "concise"], cwd=repository,
        env=clean_environment(repository.parent / "cache"), capture_output=True, text=True, timeout=SECONDS, check=False,
    )  # fmt: skip
    assert (ran.returncode, ran.stderr) == (1, "")
    lines = ran.stdout.splitlines()
    assert [line.split(" ")[2] for line in lines] == ["LL100", "LL401", "LL502"]
    assert lines[0] == "locked.launch:1:1: error LL100 unreadable-file: this launch file cannot be read: permission denied"


def hostile_manifest(repository: Path) -> None:
    write(repository, {"demo/package.xml": bomb() + "<package><name>&a11;</name></package>"})


def external_manifest(repository: Path) -> None:
    (repository.parent / "secret.txt").write_text("TOPSECRET")
    entity = f'<!DOCTYPE p [<!ENTITY x SYSTEM "file://{repository.parent}/secret.txt">]>'
    write(repository, {"demo/package.xml": entity + "<package><name>&x;</name></package>"})


def long_name(repository: Path) -> None:
    write(repository, {"demo/package.xml": PACKAGE.format(name="x" * 900_000)})


def nasty_name(repository: Path) -> None:
    write(
        repository, {f"{each}/package.xml": PACKAGE.format(name=AS_ATTRIBUTE.replace("&#133;", "").replace("&#8232;", "")) for each in "ab"}
    )


def hostile_build_file(repository: Path) -> None:
    loops = "foreach(a RANGE 1000000000)\n" * 50 + "add_executable(x${a} y)\n" + "endforeach()\n" * 50
    grows = "set(a x)\n" + 'set(a "${a}${a}${a}${a}")\n' * 200 + "add_executable(${a} x)\n"
    nests = "if(1)\n" * 20_000
    write(repository, {"demo/CMakeLists.txt": loops + grows + nests + "include(CMakeLists.txt)\nadd_subdirectory(.)\n" + "(" * 100_000})


def hostile_plugin(repository: Path) -> None:
    text = PACKAGE.format(name="demo").replace("</license>", '</license><export><nodelet plugin="${prefix}/p.xml"/></export>')
    write(repository, {"demo/package.xml": text, "demo/p.xml": bomb() + "<library>&a11;</library>"})


def endless_package(repository: Path) -> None:
    (repository / "demo/again").symlink_to("..")
    (repository / "demo/root").symlink_to("/")


def many_directories(repository: Path) -> None:
    for number in range(3_000):
        (repository / f"d{number % 50}" / f"e{number}").mkdir(parents=True)


@pytest.mark.parametrize(
    "prepare",
    [hostile_manifest, external_manifest, long_name, nasty_name, hostile_build_file, hostile_plugin, endless_package, many_directories],
)
def test_hostile_packages(repository: Path, prepare: Callable[[Path], None]) -> None:
    prepare(repository)
    write(
        repository,
        {"x.launch": '<launch><node name="a" pkg="demo" type="talk.py"/><node name="b" pkg="nodelet" type="nodelet" args="load demo/x m"/>'
                     '<param name="p" textfile="$(find demo)/nowhere"/></launch>'},
    )  # fmt: skip
    for name in ("text", "github"):
        ran = run(repository, "check", "-v", "--format", name)
        assert "TOPSECRET" not in ran.output
        assert ran.status in (0, 1)


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("a: &a [x,x,x,x,x,x,x,x,x]\n" + "".join(f"b{n}: &b{n} [{','.join([f'*b{n - 1}' if n else '*a'] * 9)}]\n" for n in range(12)), 2),
        ("ignore: " + "[" * 50_000, 2),
        ("ignore: !!python/object/apply:os.system ['touch owned']\n", 2),
        ("select: [" + "x, " * 300_000 + "]", 2),
        ("exclude: ['" + "*a" * 5_000 + "']", 1),
        ("exclude: ['" + "**/" * 2_000 + "x']", 1),
        ("exclude: ['" + "[" * 5_000 + "']", 1),
        ("per-file-ignores: {'" + "*" * 900 + "b': [LL301]}", 1),
        ("\x1b[31m: 1", 2),
        ("workspace: [/]\n", 2),
        (f"workspace: [{'../' * 60}]\n", 2),
        ("env: {PATH: '', LD_PRELOAD: /tmp/x.so, PYTHONPATH: /tmp, HOME: /tmp}\n", 1),
        ("args: {a: {b: '" + "x" * 900_000 + "'}}\n", 1),
    ],
)
def test_hostile_configuration(repository: Path, text: str, status: int) -> None:
    (repository / ".launchlint.yaml").write_text(text)
    (repository / f"{'a' * 200}.launch").write_text(DOUBLE)
    ran = run(repository, "check", "--format", "concise", f"{'a' * 200}.launch")
    assert ran.status == status
    assert len(ran.errors) < 4_000
    assert not (repository / "owned").exists()


def test_hostile_standard_input(repository: Path) -> None:
    assert run(repository, "check", "-", stdin=b"\xff\0" * 1_000_000).status == 1
    assert run(repository, "check", "-", "--stdin-filename", "a\n::error::b\x1b.launch", stdin=DOUBLE.encode()).status == 1
    assert run(repository, "check", "-", "--stdin-filename", "../" * 500 + "etc/x.launch", stdin=DOUBLE.encode()).status == 1
    assert run(repository, "model", "-", stdin=b"").status == 1


def test_hostile_args(repository: Path) -> None:
    write(repository, {"x.launch": '<launch><arg name="a" default="1"/><param name="p" value="$(arg a)"/></launch>'})
    for value in ("$(eval 9**9**9)", "x" * 100_000, "\x1b[31m\n::error::", "$(arg a)", "\u202e", "</launch>"):
        run(repository, "check", "--format", "text", "--arg", f"a:={value}", "x.launch")
        run(repository, "model", "--arg", f"a:={value}", "x.launch")
