"""``launchlint graph`` and ``launchlint graph diff``, as a user runs them."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

from tests.cli.running import PACKAGE, run, write

TALKER = {"publishers": [{"name": "chatter", "type": "std_msgs/String"}], "params": [{"name": "~rate"}]}
LISTENER = {"subscribers": [{"name": "chatter"}, {"name": "/tf"}]}
EXECUTABLES = {name: {"class": "roscpp", "variants": {"default": each}} for name, each in (("talker", TALKER), ("listener", LISTENER))}
LIBRARY = json.dumps({"format": "launchlint-library", "version": 1, "packages": {"demo": {"executables": EXECUTABLES}}})
TALK = """\
<launch>
  <arg name="loud" default="false"/>
  <node name="talker" pkg="demo" type="talker"/>
  <node name="listener" pkg="demo" type="listener">
    <remap from="chatter" to="shout" if="$(arg loud)"/>
  </node>
</launch>
"""
APART = TALK.replace('name="talker"', 'name="talker" ns="a"')
FILES = {
    "demo/package.xml": PACKAGE.format(name="demo"),
    "library.json": LIBRARY,
    ".launchlint.yaml": "library: [library.json]\n",
    "demo/launch/talk.launch": TALK,
}


def git(directory: Path, *words: str) -> None:
    command = ["git", "-c", "user.name=t", "-c", "user.email=t@example.org", *words]
    subprocess.run(command, cwd=directory, check=True, capture_output=True)


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """A repository with one commit of one package with a talker and a listener."""
    directory = tmp_path / "repository"
    write(directory, FILES)
    git(directory, "init", "-q", "-b", "main")
    git(directory, "add", "-A")
    git(directory, "commit", "-q", "-m", "base")
    return directory


def shown(directory: Path, *words: str) -> str:
    ran = run(directory, "graph", *words)
    assert (ran.status, ran.errors) == (0, "")
    return ran.output


def refused(directory: Path, *words: str) -> str:
    ran = run(directory, "graph", *words)
    assert (ran.status, ran.output) == (2, "")
    assert ran.errors.count("\n") == 1
    return ran.errors.rstrip("\n")


def test_text(workspace: Path) -> None:
    assert shown(workspace, "demo/launch/talk.launch") == (
        "demo/launch/talk.launch: 2 nodes; 1 of 1 topic connected\n"
        "\n"
        "/listener  demo/listener  demo/launch/talk.launch:4\n"
        "    subscribes  /chatter  ← /talker\n"
        "\n"
        "/talker  demo/talker  demo/launch/talk.launch:3\n"
        "    publishes  /chatter  → /listener  (std_msgs/String)\n"
        "\n"
        "not shown: /tf (--hubs)\n"
    )


def test_every_configuration(workspace: Path) -> None:
    assert shown(workspace, "--every-configuration", "--topic", "/*", "demo/launch/talk.launch") == (
        "demo/launch/talk.launch: 2 nodes; 1 of 2 topics connected; 2 configurations\n"
        "\n"
        "/listener  demo/listener  demo/launch/talk.launch:4\n"
        "    subscribes  /chatter  ← /talker  [only by default]\n"
        "    subscribes  /shout    ← nobody  [only with loud:=true]\n"
        "                  remapped from /chatter (line 5)\n"
        "\n"
        "/talker  demo/talker  demo/launch/talk.launch:3\n"
        "    publishes  /chatter  → /listener  (std_msgs/String)\n"
    )


def test_args_are_given_as_to_roslaunch(workspace: Path) -> None:
    assert "/shout  ← nobody" in shown(workspace, "demo/launch/talk.launch", "--arg", "loud:=true")


@pytest.mark.parametrize(
    ("format_", "start"),
    [
        ("mermaid", "flowchart LR\n"),
        ("dot", "digraph connections {\n"),
        ("graphml", "<?xml "),
        ("json", '{\n  "entry": "demo/launch/talk.launch",\n'),
    ],
)
def test_formats(workspace: Path, format_: str, start: str) -> None:
    assert shown(workspace, "--format", format_, "demo/launch/talk.launch").startswith(start)


def test_formats_for_programs_leave_nothing_out(workspace: Path) -> None:
    for words, names in (((), ["/chatter", "/tf"]), (("--no-hubs",), ["/chatter"]), (("--topic=chatter",), ["/chatter"])):
        read = json.loads(shown(workspace, "demo/launch", "--format=json", *words))
        assert [each["name"] for each in read["channels"]] == names


def test_several_files(workspace: Path) -> None:
    write(workspace, {"demo/launch/more.launch": APART})
    assert [line for line in shown(workspace).splitlines() if ".launch: " in line] == [
        "demo/launch/more.launch: 2 nodes; 0 of 2 topics connected",
        "demo/launch/talk.launch: 2 nodes; 1 of 1 topic connected",
    ]
    assert [each["entry"] for each in json.loads(shown(workspace, "--format=json"))] == [
        "demo/launch/more.launch",
        "demo/launch/talk.launch",
    ]
    assert shown(workspace, "--format=mermaid").count("flowchart LR") == 1
    assert shown(workspace, "--format=dot").count("digraph") == 2
    assert refused(workspace, "--format=graphml") == (
        "launchlint: --format graphml makes one document, and here are 2 launch files; give one"
    )


def test_standard_input(workspace: Path) -> None:
    ran = run(workspace, "graph", "-", "--stdin-filename", "demo/launch/new.launch", stdin=TALK)
    assert (ran.status, ran.output.splitlines()[0]) == (0, "demo/launch/new.launch: 2 nodes; 1 of 1 topic connected")


def test_help_tells_of_both(workspace: Path) -> None:
    text = shown(workspace, "--help")
    assert text.startswith("Usage: launchlint graph [OPTIONS] [PATHS]...\n       launchlint graph diff [OPTIONS] BASE [HEAD] [PATHS]...\n")
    assert "--every-configuration" in text
    assert "--exit-code" in shown(workspace, "diff", "--help")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["nosuch.launch"], "nosuch.launch: No such file or directory; give launch files, or directories to search for them"),
        (["--node", "/talkre", "demo"], "--node /talkre: there is no such node here; did you mean /talker?"),
        (["--topic", "/nothing", "demo"], "--topic /nothing: there is no such topic here"),
        (["--namespace", "a", "demo"], "--namespace a: there is no such namespace here"),
        (["demo/nothing"], "demo/nothing: No such file or directory; give launch files, or directories to search for them"),
        (["--library", "nosuch.json", "demo"], "nosuch.json"),
        (["--format", "svg", "demo"], "Invalid value for '--format'"),
        (["diff"], "Missing argument 'BASE'"),
        (["diff", "nosuch"], "nosuch is no revision of the git repository"),
        (["diff", "HEAD", "nosuch"], "nosuch is no revision of the git repository"),
        (["diff", "main..other"], "main..other is no revision of the git repository"),
        (["diff", "-x"], "No such option '-x'"),
        (["diff", "--", "-x"], "-x is no revision of the git repository"),
        (["diff", "HEAD", "main", "nowhere"], "nowhere: there is no such file or directory, neither before nor after"),
        (["diff", "HEAD", "main", "-"], "graph diff compares files or revisions; it takes neither standard input nor --entries"),
    ],
)
def test_what_cannot_be_done_is_told_in_one_line(workspace: Path, words: list[str], told: str) -> None:
    assert told in refused(workspace, *words)


def test_an_empty_directory(tmp_path: Path) -> None:
    directory = tmp_path / "empty"
    directory.mkdir()
    assert refused(directory, ".") == "launchlint: there is no launch file to show; give one"
    assert "is not in a git repository" in refused(directory, "diff", "HEAD")


LOST = """\
demo/launch/talk.launch
  lost: /talker → /listener on topic /chatter
      /talker is now /a/talker
  ~ node /talker is now /a/talker
"""


def test_the_working_tree_against_a_revision(workspace: Path) -> None:
    assert shown(workspace, "diff", "HEAD") == "no connection changed\n"
    write(workspace, {"demo/launch/talk.launch": APART})
    assert shown(workspace, "diff", "HEAD") == LOST
    assert shown(workspace, "diff", "HEAD", "demo") == LOST
    assert shown(workspace, "diff", "HEAD", "demo/launch/talk.launch") == LOST
    assert run(workspace, "graph", "diff", "HEAD", "--exit-code").status == 1


def test_two_revisions(workspace: Path) -> None:
    write(workspace, {"demo/launch/talk.launch": APART})
    git(workspace, "commit", "-qam", "apart")
    assert shown(workspace, "diff", "HEAD~1", "HEAD") == LOST
    assert shown(workspace, "diff", "HEAD~1", "HEAD", "demo") == LOST
    assert shown(workspace, "diff", "HEAD~1") == LOST
    assert run(workspace, "graph", "diff", "HEAD", "HEAD", "--exit-code").status == 0
    assert "gained: /talker → /listener on topic /chatter" in shown(workspace, "diff", "HEAD", "HEAD~1")


def test_two_files(workspace: Path) -> None:
    write(workspace, {"demo/launch/more.launch": APART})
    found = shown(workspace, "diff", "demo/launch/talk.launch", "demo/launch/more.launch")
    assert found == LOST.replace("talk.launch", "talk.launch → demo/launch/more.launch", 1)


def test_two_files_in_two_copies_of_a_workspace(workspace: Path, tmp_path: Path) -> None:
    """Each includes the file of its own copy."""
    other = tmp_path / "other"
    include = '<launch><include file="$(find demo)/launch/talk.launch"/></launch>\n'
    write(workspace, {"demo/launch/all.launch": include})
    write(other, {**FILES, "demo/launch/talk.launch": APART, "demo/launch/all.launch": include, ".git/HEAD": ""})
    found = shown(workspace, "diff", "demo/launch/all.launch", str(other / "demo/launch/all.launch"))
    assert found.splitlines()[1:] == LOST.splitlines()[1:]


def test_from_a_subdirectory_and_through_a_link(workspace: Path, tmp_path: Path) -> None:
    write(workspace, {"demo/launch/talk.launch": APART})
    options = ("--library", "../../library.json")
    assert shown(workspace / "demo/launch", "diff", "HEAD", *options) == LOST.replace("demo/launch/", "")
    (tmp_path / "link").symlink_to(workspace)
    assert shown(workspace, "diff", "HEAD", str(tmp_path / "link/demo")) == LOST


def test_new_deleted_and_renamed_files(workspace: Path) -> None:
    write(workspace, {"demo/launch/new.launch": '<launch><node name="other" pkg="demo" type="listener"/></launch>'})
    os.rename(workspace / "demo/launch/talk.launch", workspace / "demo/launch/speak.launch")
    assert shown(workspace, "diff", "HEAD") == ("demo/launch/new.launch\n  + node /other (demo/listener)\n      subscribes /chatter\n")
    write(workspace, {"demo/launch/speak.launch": APART})
    assert "demo/launch/talk.launch → demo/launch/speak.launch\n  lost: " in shown(workspace, "diff", "HEAD")
    (workspace / "demo/launch/speak.launch").unlink()
    assert shown(workspace, "diff", "HEAD", "demo/launch/talk.launch").splitlines() == [
        "demo/launch/talk.launch",
        "  - node /listener (demo/listener)",
        "      subscribes /chatter, /shout",
        "  - node /talker (demo/talker)",
        "      publishes /chatter",
    ]


def test_an_included_file_is_told_of_where_it_is_started(workspace: Path) -> None:
    include = '<launch><include file="$(find demo)/launch/talk.launch"/></launch>\n'
    write(workspace, {"demo/launch/one.launch": include, "demo/launch/two.launch": include})
    git(workspace, "add", "-A")
    git(workspace, "commit", "-qm", "includes")
    write(workspace, {"demo/launch/talk.launch": APART})
    assert shown(workspace, "diff", "HEAD").splitlines()[:2] == [
        "in 2 launch files: demo/launch/one.launch, demo/launch/two.launch",
        "  lost: /talker → /listener on topic /chatter",
    ]
    assert shown(workspace, "diff", "HEAD", "demo/launch/talk.launch") == LOST


def test_a_file_that_is_only_in_the_index_or_untracked_counts_for_the_working_tree(workspace: Path) -> None:
    write(workspace, {"demo/launch/staged.launch": TALK, "demo/launch/untracked.launch": APART})
    git(workspace, "add", "demo/launch/staged.launch")
    titles = [line for line in shown(workspace, "diff", "HEAD").splitlines() if not line.startswith(" ") and line]
    assert titles == ["demo/launch/staged.launch", "demo/launch/untracked.launch"]


def test_selections_narrow_a_comparison(workspace: Path) -> None:
    write(workspace, {"demo/launch/talk.launch": APART})
    assert shown(workspace, "diff", "HEAD", "--topic", "/nothing") == "no connection changed\n"
    assert shown(workspace, "diff", "HEAD", "--kind", "service").splitlines()[1:] == ["  ~ node /talker is now /a/talker"]


def test_a_comparison_in_other_formats(workspace: Path) -> None:
    write(workspace, {"demo/launch/talk.launch": APART})
    (read,) = json.loads(shown(workspace, "diff", "HEAD", "--format=json"))
    assert (read["entry"], read["moved"], [(each["node"], each["partners"]) for each in read["lost"]]) == (
        "demo/launch/talk.launch",
        {"/talker": "/a/talker"},
        [("/listener", ["/talker"])],
    )
    assert "linkStyle 0 stroke:#cf222e" in shown(workspace, "diff", "HEAD", "--format=mermaid")
    assert "#cf222e" in shown(workspace, "diff", "HEAD", "--format=dot")
    assert json.loads(shown(workspace, "diff", "HEAD", "HEAD", "--format=json")) == []
    assert shown(workspace, "diff", "HEAD", "HEAD", "--format=mermaid").startswith("flowchart LR\n")
    assert shown(workspace, "diff", "HEAD", "HEAD", "--format=dot") == ""


def test_nothing_stays_in_the_temporary_directory(workspace: Path, tmp_path: Path) -> None:
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    write(workspace, {"demo/launch/talk.launch": APART})
    for words in (["graph", "diff", "HEAD~0", "main"], ["graph", "diff", "nosuch"], ["check", "--base", "HEAD"]):
        run(workspace, *words, environment={"TMPDIR": str(scratch)})
        assert list(scratch.iterdir()) == []


def test_a_repository_of_somebody_else(workspace: Path) -> None:
    ran = run(workspace, "graph", "diff", "HEAD", environment={"GIT_TEST_ASSUME_DIFFERENT_OWNER": "1"})
    assert ran.status == 2
    assert "is no revision of the git repository" in ran.errors
    assert "dubious ownership" in ran.errors
    assert ran.errors.count("\n") == 1


def test_check_tells_what_is_lost(workspace: Path) -> None:
    write(workspace, {"demo/launch/talk.launch": APART})
    words = ("check", "--base", "HEAD", "--select", "LL620", "--format", "concise")
    found = run(workspace, *words)
    assert found.output == (
        "demo/launch/talk.launch:4:15: warning LL620 lost-connection: /listener has lost its publisher /talker on /chatter\n"
    )
    assert run(workspace, *words, "demo/launch/talk.launch").output == found.output
    assert run(workspace, *words, "--no-cache", "--jobs", "2").output == found.output
    assert run(workspace, "check", "--select", "LL620", "--format", "concise").output == ""
    assert run(workspace, *words, "--fail-on", "warning").status == 1


def test_check_with_a_baseline_and_with_suppressions(workspace: Path) -> None:
    write(workspace, {"demo/launch/talk.launch": APART})
    words = ("check", "--base", "HEAD", "--select", "LL620,LL803", "--format", "concise")
    assert run(workspace, *words, "--write-baseline", "known.json").status == 0
    assert run(workspace, *words, "--baseline", "known.json").output == ""
    comment = "<!-- launchlint: ignore[LL620] meant so -->\n  "
    write(workspace, {"demo/launch/talk.launch": APART.replace('<node name="listener"', f'{comment}<node name="listener"')})
    assert run(workspace, *words).output == ""
    # Without a base nobody knows whether it suppresses something.
    assert run(workspace, "check", "--select", "LL620,LL803", "--format", "concise").output == ""


def test_check_against_a_base_that_lacks_the_file_or_has_another_one(workspace: Path) -> None:
    os.rename(workspace / "demo/launch/talk.launch", workspace / "demo/launch/new.launch")
    assert run(workspace, "check", "--base", "HEAD", "--select", "LL620").status == 0
    write(workspace, {"demo/launch/talk.launch": "<launch><not closed"})
    git(workspace, "commit", "-qam", "broken")
    write(workspace, {"demo/launch/talk.launch": TALK})
    assert run(workspace, "check", "--base", "HEAD", "--select", "LL620", "--format", "concise").output == ""
    ran = run(workspace, "check", "--base", "nosuch")
    assert (ran.status, ran.output, "nosuch is no revision" in ran.errors) == (2, "", True)


def test_check_in_a_hook(workspace: Path) -> None:
    """Git runs hooks with variables that name the repository and the index of the commit."""
    write(workspace, {"demo/launch/talk.launch": APART})
    hook = {"GIT_DIR": ".git", "GIT_INDEX_FILE": ".git/index.lock", "GIT_PREFIX": "demo/"}
    ran = run(workspace, "check", "--base", "HEAD", "--select", "LL620", "--format", "concise", environment=hook)
    assert ran.output.count("LL620") == 1


def test_check_with_args_of_the_configuration(workspace: Path) -> None:
    """The same file started in two ways is compared with itself started in the same way."""
    entries = "entries:\n  - file: demo/launch/talk.launch\n  - file: demo/launch/talk.launch\n    args: {loud: 'true'}\n"
    write(workspace, {".launchlint.yaml": f"library: [library.json]\n{entries}"})
    assert run(workspace, "check", "--base", "HEAD", "--select", "LL620", "--format", "concise").output == ""
    ran = run(workspace, "graph", "diff", "HEAD")
    assert ran.output == "no connection changed\n"


REFUSED = '<launch>\n  <node name="talker" pkg="demo" type="talker"/>\n  <node name="talker" pkg="demo" type="talker"/>\n</launch>\n'


def test_what_is_drawn_of_a_refused_launch_says_so(tmp_path: Path) -> None:
    write(tmp_path, {**FILES, "demo/launch/talk.launch": REFUSED})
    said = "refused by roslaunch: two nodes are named /talker; shown is what it would start otherwise"
    drawn = {each: run(tmp_path, "graph", "--format", each, "demo").output for each in ("text", "mermaid", "dot", "graphml", "json")}
    assert drawn["text"].splitlines()[1] == f"    {said}"
    escaped = "refused by roslaunch#58; two nodes are named /talker#59; shown is what it would start otherwise"
    assert drawn["mermaid"].splitlines()[1] == f'  n1["{escaped}"]'
    assert f'label="demo/launch/talk.launch; {said}";' in drawn["dot"]
    assert '<data key="g1">refused by roslaunch: two nodes are named /talker</data>' in drawn["graphml"]
    assert json.loads(drawn["json"])["verdict"]["word"] == "refused"
    write(tmp_path, FILES)
    in_order = {each: run(tmp_path, "graph", "--format", each, "demo").output for each in ("text", "mermaid", "dot")}
    assert not [each for each, text in in_order.items() if "refused" in text]


def test_a_launch_that_is_refused_now_is_a_change(tmp_path: Path) -> None:
    once = REFUSED.replace('  <node name="talker" pkg="demo" type="talker"/>\n', "", 1)
    write(tmp_path, {**FILES, "demo/launch/talk.launch": once})
    git(tmp_path, "init", "-q")
    git(tmp_path, "add", "-A")
    git(tmp_path, "commit", "-qm", "one")
    assert run(tmp_path, "graph", "diff", "HEAD", "--exit-code").status == 0
    write(tmp_path, {"demo/launch/talk.launch": REFUSED})
    ran = run(tmp_path, "graph", "diff", "HEAD", "--exit-code")
    assert (ran.status, ran.output) == (
        1,
        "demo/launch/talk.launch\n  now: refused by roslaunch: two nodes are named /talker; shown is what it would start otherwise\n",
    )
    changed = json.loads(run(tmp_path, "graph", "diff", "HEAD", "--format", "json").output)[0]["verdict"]
    assert (changed["before"]["word"], changed["after"]["word"]) == ("loads", "refused")
    git(tmp_path, "commit", "-qam", "two")
    write(tmp_path, {"demo/launch/talk.launch": once})
    assert run(tmp_path, "graph", "diff", "HEAD").output == "demo/launch/talk.launch\n  loads now; before: refused by roslaunch\n"
