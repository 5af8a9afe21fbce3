"""`launchlint library show`, `validate`, `merge`, `diff` and `schema`, as people call them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from launchlint.library.schema import json_schema
from launchlint.library.write import canonical
from tests.cli.running import Ran, run
from tests.library.samples import evidence, executable, library, one, publishers, written
from tests.library.test_schema import EVERYTHING

AT = "owner/demo@0a1b2c3d4e5f:src/relay.cpp"
WORDS = {"words": "~goals", "default": ["a", "b"]}
DEMO: dict[str, Any] = library(
    demo={
        "executables": {
            "relay": {
                "class": "roscpp",
                "options": {"-r": 1, "-l": 0},
                "variants": {
                    "default": {
                        "publishers": [
                            {"name": "{arg:2|{arg:1}_relay}", "type": "*", "when": "message", "evidence": evidence("manual", f"{AT}:103")},
                            {"name": "~image", "type": "sensor_msgs/Image", "transport": "image", "latched": True, "when": "subscriber"},
                        ],
                        "subscribers": [{"name": "{each}", "each": {"args": 1}, "evidence": [{"by": "dynamic", "run": "7"}]}],
                        "services": [{"name": "~reset", "type": "std_srvs/Empty", "condition": {"not": {"option": "-l"}}}],
                        "clients": [{"name": "get_map", "condition": {"text": "if (debug_)"}}],
                        "actions": [{"name": "{each}", "type": "demo/GoAction", "role": "server", "each": WORDS}],
                        "params": [{"name": "~rate", "type": "double", "default": 10.0, "min": 0, "max": 50}],
                        "open": {"params": "whatever its plugins want"},
                    },
                    "check": {"match": {"all": [{"arg": 1, "is": "check"}, {"param": "~dry", "default": False}]}},
                },
            },
            "copy": {"like": "relay"},
            "broken": {"status": "failed", "problems": [{"code": "display", "detail": "cannot open display"}]},
            "tool": {"class": "none"},
        },
        "nodelets": {"demo/Relay": executable(subscribers=[{"name": "in"}])},
    },
    other={"executables": {"node": executable()}},
)  # fmt: skip

RELAY = """\
demo/relay  roscpp
  options: -r (1 value), -l
  variant check, where (argument 1 is check) and (~dry is true (default false))
  no names of its own
  variant default
  publishes   {arg:2|{arg:1}_relay}  *                  after a first message or call
  publishes   ~image                 sensor_msgs/Image  latched, by image_transport, while somebody listens
  subscribes  {each}                 ?                  for each argument from 1 on
  serves      ~reset                 std_srvs/Empty     where not (-l is given)
  calls       get_map                ?                  where «if (debug_)»
  acts        {each}                 demo/GoAction      server, for each word of ~goals (default a b)
  reads       ~rate                  double             default 10.0, 0 to 50
  reads more than is listed: whatever its plugins want
"""


@pytest.fixture
def here(tmp_path: Path) -> Path:
    """A directory with demo.json."""
    directory = tmp_path / "here"
    directory.mkdir()
    written(directory / "demo.json", DEMO)
    return directory


def shown(here: Path, *words: str) -> Ran:
    return run(here, "library", "show", "--no-bundled", "--library", "demo.json", *words)


def test_show_lists_packages(here: Path) -> None:
    assert shown(here) == (
        0,
        ("demo   4 executables, 1 nodelet class\n"
        "other  1 executable, 0 nodelet classes\n"
        "\n"
        "2 packages, 5 executables, 1 nodelet class\n"),
        "",
    )  # fmt: skip
    assert json.loads(shown(here, "--format", "json").output) == [
        {"package": "demo", "middleware": "ros1", "executables": 4, "nodelets": 1},
        {"package": "other", "middleware": "ros1", "executables": 1, "nodelets": 0},
    ]


def test_show_an_executable(here: Path) -> None:
    assert shown(here, "demo/relay") == (0, RELAY, "")


def test_show_the_evidence(here: Path) -> None:
    lines = shown(here, "-v", "demo/relay").output.splitlines()
    assert [line for line in lines if line not in RELAY.splitlines()] == [
        "      manual  owner/demo@0a1b2c3d4e5f:src/relay.cpp:103",
        "      dynamic  7",
    ]


def test_show_a_package(here: Path) -> None:
    output = shown(here, "demo").output
    assert output.split("\n\n") == [
        "demo/broken\n  problem: display: cannot open display\n  its interface is not known: it could not be run",
        RELAY.rstrip("\n").replace("demo/relay  roscpp", "demo/copy\n  the same program as relay"),
        RELAY.rstrip("\n"),
        "demo/tool  none\n  no names of its own",
        "demo/Relay (nodelet of demo)\n  subscribes  in  ?\n",
    ]


def test_show_as_json(here: Path) -> None:
    programs, relay = DEMO["packages"]["demo"]["executables"], DEMO["packages"]["demo"]["nodelets"]["demo/Relay"]
    place = {"package": "demo", "middleware": "ros1"}
    assert json.loads(shown(here, "--format", "json", "demo/copy", "demo/Relay", "demo/broken").output) == [
        {**place, "kind": "executable", "name": "copy", "said": {"like": "relay"}, "interface": programs["relay"]},
        {**place, "kind": "nodelet class", "name": "demo/Relay", "said": relay, "interface": relay},
        {**place, "kind": "executable", "name": "broken", "said": programs["broken"], "interface": None},
    ]


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("demmo", "did you mean demo?"),
        ("zzz", "launchlint library show lists the packages"),
        ("demo/relai", "did you mean demo/relay?"),
        ("demo/copi", "did you mean demo/copy?"),
        ("demo/zzzzz", "launchlint library show demo lists what is known of the package"),
        ("dmo/relay", "did you mean demo?"),
        ("zzz/relay", "there is no package zzz, and no nodelet class of that name; launchlint library show lists the packages"),
    ],
)
def test_show_what_is_not_known(here: Path, name: str, hint: str) -> None:
    assert shown(here, name) == (2, "", f"launchlint: nothing is known of {name}: {hint}\n")


def test_show_knows_the_bundled_library_and_the_configuration(here: Path) -> None:
    (here / ".launchlint.yaml").write_text("library: [demo.json]\n")
    assert run(here, "library", "show", "demo/tool").output == "demo/tool  none\n  no names of its own\n"
    assert run(here, "library", "show", "topic_tools/relay").output.startswith(
        "topic_tools/relay  roscpp\n  publishes   {arg:2|{arg:1}_relay}"
    )
    assert run(here, "library", "show", "--no-bundled", "topic_tools/relay").status == 2


def test_show_hostile_text(here: Path) -> None:
    """Whatever a library says, the terminal gets plain lines."""
    entry = {"name": "x", "condition": {"text": "\x1b[2J\n"}, "evidence": [{"by": "static", "at": "\u202e\x07"}]}
    program = {
        **executable(publishers=[entry], open={"clients": "\x1b\n"}),
        "problems": [{"code": "\x9b", "detail": "##[error]\r"}],
        "options": {"\x1b": 1},
    }
    hostile = library(**{"\x1bp": {"executables": {"\x1b]0;x\x07": program}, "nodelets": {"\x1bp/\n": program}}})
    written(here / "demo.json", hostile)
    for words in ([], ["\x1bp"], ["-v", "\x1bp"], ["\x1bq"]):
        ran = shown(here, *words)
        assert (ran.output + ran.errors).replace("\n", "").isprintable()
        assert "##[" not in ran.output
    written(here / "empty.json", library())
    ran = run(here, "library", "diff", "empty.json", "demo.json")
    assert (ran.status, ran.output.replace("\n", "").isprintable()) == (1, True)
    assert run(here, "library", "merge", "demo.json", "-o", "-").output.replace("\n", "").isprintable()
    assert run(here, "library", "validate", "demo.json").output.replace("\n", "").isprintable()


def test_validate(here: Path) -> None:
    written(here / "wrong.json", '{"format": "launchlint-library",\n "version": 3, "packages": []}')
    written(here / "useless.json", one({"like": "node"}))
    assert run(here, "library", "validate", "demo.json") == (0, "demo.json: ok: 2 packages, 5 executables, 1 nodelet class\n", "")
    assert run(here, "library", "validate", "-q", "demo.json") == (0, "", "")
    assert run(here, "library", "validate", "wrong.json", "none.json", "demo.json", "useless.json") == (
        2,
        (
            "wrong.json:2:13: this launchlint reads the versions 1 and 2 of the format, and this is version 3: use a newer launchlint\n"
            "wrong.json:2:28: this must be a mapping from each package to what it is, and is a list\n"
            "none.json: the library cannot be read: No such file or directory\n"
            "demo.json: ok: 2 packages, 5 executables, 1 nodelet class\n"
            'useless.json:1:103: `like` leads in a circle: "node" → "node"\n'
        ),
        "",
    )


def test_merge(here: Path) -> None:
    written(here / "seen.json", publishers({"name": "x", "type": "a/B", "evidence": evidence("dynamic")}))
    written(here / "read.json", publishers({"name": "x", "queue": 1, "evidence": evidence("static")}))
    expected = publishers({"name": "x", "type": "a/B", "queue": 1, "evidence": [*evidence("dynamic"), *evidence("static")]})
    assert run(here, "library", "merge", "read.json", "seen.json", "-o", "out.json") == (0, "", "")
    assert (here / "out.json").read_text() == canonical(expected)
    assert run(here, "library", "merge", "read.json", "seen.json", "-o", "-") == (0, canonical(expected), "")
    assert run(here, "library", "merge", "out.json", "-o", "out.json").status == 0
    assert (here / "out.json").read_text() == canonical(expected)


def test_merge_that_cannot_be_done(here: Path) -> None:
    for name, md5 in (("a.json", "a" * 32), ("b.json", "b" * 32)):
        written(here / name, {**library(), "messages": {"a/B": {"md5": md5}}})
    assert run(here, "library", "merge", "a.json", "b.json", "-o", "out.json") == (
        2,
        "",
        (
            "launchlint: a.json, b.json: these libraries cannot be joined: they were made with different versions of the message a/B "
            f"(MD5 {'b' * 32} and {'a' * 32})\n"
        ),
    )
    assert run(here, "library", "merge", "none.json", "-o", "out.json") == (
        2, "", "launchlint: none.json: the library cannot be read: No such file or directory\n",
    )  # fmt: skip
    assert run(here, "library", "merge", "a.json", "-o", "no/out.json").errors == (
        "launchlint: cannot write the library to 'no/out.json': the directory 'no' does not exist; create it first\n"
    )
    assert not (here / "out.json").exists()


def test_diff(here: Path) -> None:
    new = json.loads(json.dumps(DEMO))
    relay = new["packages"]["demo"]["executables"]["relay"]["variants"]["default"]
    relay["publishers"][1] |= {"type": "std_msgs/String", "queue": 1}
    relay["params"] = []
    del new["packages"]["other"]
    new["packages"]["fresh"] = {"nodelets": {"fresh/A": executable(publishers=[{"name": "/x", "type": "std_msgs/String"}])}}
    written(here / "new.json", new)
    assert run(here, "library", "diff", "demo.json", "demo.json") == (0, "", "")
    assert run(here, "library", "diff", "demo.json", "new.json") == (
        1,
        (
            "demo/relay\n"
            "  ~ publisher ~image: queue none → 1, type sensor_msgs/Image → std_msgs/String\n"
            "  - param ~rate (double, default 10.0, max 50, min 0)\n"
            "\n"
            "+ fresh/A (nodelet of fresh)\n"
            "  + publisher /x (std_msgs/String)\n"
            "\n"
            "- other/node\n"
        ),
        "",
    )
    changes = json.loads(run(here, "library", "diff", "--format", "json", "demo.json", "new.json").output)
    assert changes[0] == {
        "change": "changed", "package": "demo", "kind": "executable", "program": "relay", "variant": "default", "what": "publisher",
        "name": "~image", "before": {"type": "sensor_msgs/Image"}, "after": {"queue": 1, "type": "std_msgs/String"},
    }  # fmt: skip
    assert [change["change"] for change in changes] == ["changed", "removed", "added", "added", "removed"]


def test_diff_with_what_is_no_library(here: Path) -> None:
    (here / "wrong.json").write_text("[]")
    assert run(here, "library", "diff", "demo.json", "wrong.json") == (
        2, "", "launchlint: wrong.json:1:1: the library must be a mapping, and is a list\n",
    )  # fmt: skip


def test_schema(here: Path) -> None:
    ran = run(here, "library", "schema")
    assert (ran.status, json.loads(ran.output), ran.errors) == (0, json_schema(), "")


def test_everything_can_be_shown_and_compared(here: Path) -> None:
    written(here / "demo.json", EVERYTHING)
    written(here / "empty.json", library())
    assert (shown(here, "-v", "demo").status, run(here, "library", "diff", "demo.json", "empty.json").status) == (0, 1)


def test_help_and_slips(here: Path) -> None:
    assert run(here, "library")[:2] == (2, "")
    assert run(here, "library", "vlidate", "x").errors.startswith("launchlint: ")
    for name in ("show", "validate", "merge", "diff", "schema"):
        ran = run(here, "library", name, "--help")
        assert (ran.status, ran.errors) == (0, "")
        assert ran.output.startswith(f"Usage: launchlint library {name}")
