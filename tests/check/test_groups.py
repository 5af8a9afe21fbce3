"""What is taken from an earlier run without a look at single results: directories of entry files, what was told of files, all of a run.

Whatever changes, what is told is what a run without a cache tells; and what nothing has changed of is not read.
"""

from __future__ import annotations

import json
import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from tests.check import test_asked as workspaces
from tests.check.test_asked import put, remove, rename, replace
from tests.check.test_trusted import Trusting
from tests.cli.running import run_program, write

PROGRAM = """
import sys
from launchlint.check import cache, entry, groups, judges, same
from launchlint.cli import main
from launchlint.workspace import contents, looking

contents.RACY, contents.WORTH_WRITING, looking._MANY = 0, 1, 2
counts = dict.fromkeys(("computed", "read", "gathered", "judged"), 0)

def counted(module, name, what):
    function = getattr(module, name)

    def count(*given, **named):
        counts[what] += 1
        return function(*given, **named)

    setattr(module, name, count)

counted(entry.EntryChecker, "check", "computed")
counted(cache, "entry_from_json", "read")
counted(groups, "gathered", "gathered")
counted(judges, "judged", "judged")
{more}
main(["check", "--exit-zero", "--format", "json", "--jobs", "1", *sys.argv[1:]], standalone_mode=False)
print()
print(*counts.values())
"""
NOTHING = [0, 0, 0, 0]
KILLED = "def killed(*_): raise SystemExit\n"
ENDS = {  # where a run ends
    "before it keeps what was told": KILLED + "groups.Groups.keep = killed",
    "before it keeps all of the run": KILLED + "same.SameRun.keep = killed",
    "when nothing can be written any more": "groups.Groups._keep = lambda *_: [][0]",
}


class Workspace(Trusting):
    """A repository that is checked with a cache, and what runs do."""

    def run(self, *words: str, more: str = "") -> tuple[str, list[int]]:
        """What is said; how many entry files are computed, how many results read, how often is gathered, and judged."""
        done = run_program(self.directory, PROGRAM.format(more=more), *words, cache=self.cache)
        assert done.status == 0, done.errors
        said, _, counts = done.output.rstrip().rpartition("\n")
        return said, [int(count) for count in counts.split()]

    @property
    def database(self) -> Path:
        (file,) = (self.cache / "launchlint").glob("*.sqlite")
        return file


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    made = Workspace(tmp_path)
    shutil.rmtree(made.directory)
    write(made.directory, dict(workspaces._files()))
    for name in workspaces.PACKAGES:
        (made.directory / name / "scripts/talk.py").chmod(0o755)
    write(made.directory, FILES)
    return made


BROKEN = """\
<launch>
  <arg name="robot"/>
  <node name="w" pkg="beta" type="nobody" args="$(arg robot)"/>
  <arg name="idle" default="1"/>
</launch>
"""
CALLS = '<launch>\n  <include file="$(find beta)/parts/broken.launch">{}</include>\n</launch>\n'
GIVES = '<arg name="robot" value="{}"/>'
PART = """\
<launch>
  <arg name="robot"/>
  <param name="robot" value="$(arg robot)"/>
  <arg name="all" default="true"/>
  <include if="$(arg all)" file="$(find beta)/parts/inner.launch"><arg name="program" value="nobody"/></include>
</launch>
"""
INNER = '<launch>\n  <arg name="program" default="talk.py"/>\n  <node name="w" pkg="beta" type="$(arg program)"/>\n</launch>\n'
DRIVES = """\
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "drive");
  ros::NodeHandle own("~");
  double speed;
  own.param("speed", speed, 1.0);
  ros::spin();
}
"""
FILES = {
    "beta/parts/broken.launch": BROKEN,
    "beta/parts/inner.launch": INNER,
    "beta/parts/part.launch": PART,
    "alpha/calls/one.launch": CALLS.format(GIVES.format("one")),
    "gamma/calls/two.launch": CALLS.format(GIVES.format("two")),
    "delta/old/aside.launch": '<launch><node name="a" pkg="beta" type="nobody"/></launch>\n',
    "delta/ignored/loose.launch": '<launch><node name="a" pkg="beta" type="nobody"/></launch>\n',
    "alpha/src/drive.cpp": DRIVES,
    "alpha/moveit/move_group.launch": '<launch><arg name="debug" default="false"/><arg name="info" default="true"/></launch>\n',
}
USES_OLD = '<launch><include file="$(find delta)/old/aside.launch"/></launch>\n'
GIVES_BOTH = GIVES.format("r") + '<arg name="all" value="false"/>'
LEAVES_OUT = f'<launch><include file="$(find beta)/parts/part.launch">{GIVES_BOTH}</include></launch>\n'
SILENT = '<launch>\n  <!-- launchlint: ignore[LL301] so -->\n  <node name="w" pkg="beta" type="nobody"/>\n</launch>\n'
CHANGES: dict[str, Callable[[Path], None]] = {
    "git ignores a file": put(".gitignore", "made.yaml\n"),
    "git ignores it no more": put(".gitignore", "*.bag\n"),
    "a program reads another param": replace("alpha/src/drive.cpp", '"speed"', '"speeds"'),
    "and that of before": replace("alpha/src/drive.cpp", '"speeds"', '"speed"'),
    "one more leads to the mistake": put("alpha/calls/more.launch", CALLS.format(GIVES.format("more"))),
    "it gives another value": replace("alpha/calls/more.launch", "more", "other"),
    "its lines move": replace("alpha/calls/more.launch", "<launch>\n", "<launch>\n\n"),
    "it leads there no more": put("alpha/calls/more.launch", "<launch/>\n"),
    "it is gone": remove("alpha/calls/more.launch"),
    "nobody gives what is needed": replace("gamma/calls/two.launch", GIVES.format("two"), ""),
    "one includes it": remove("gamma/calls/two.launch"),
    "nobody includes it: it is no part any more": put("alpha/calls/one.launch", "<launch/>\n"),
    "a part again": put("alpha/calls/one.launch", CALLS.format(GIVES.format("one"))),
    "it needs nothing any more": replace("beta/parts/broken.launch", '<arg name="robot"/>', '<arg name="robot" default="r"/>'),
    "the mistake moves": replace("beta/parts/broken.launch", "<launch>\n", "<launch>\n\n\n"),
    "another directory": rename("beta/parts", "beta/pieces"),
    "and back": rename("beta/pieces", "beta/parts"),
    "a part shows nothing of what it includes by itself": put("alpha/calls/some.launch", LEAVES_OUT),
    "it is no part any more, and does": put("alpha/calls/some.launch", "<launch/>\n"),
    "a directory is gone": remove("gamma/calls"),
    "a document gives an arg": put("README.md", "roslaunch beta broken.launch idle:=2\n"),
    "a workflow names a package": put(".github/workflows/ci.yml", "steps:\n  - run: git clone https://example.com/lost.git\n"),
    "it names another": put(".github/workflows/ci.yml", "steps:\n  - run: git clone https://example.com/most.git\n"),
    "an assistant made the package": put("alpha/.setup_assistant", "moveit_setup_assistant_config: {}\n"),
    "nobody made it": remove("alpha/.setup_assistant"),
    "a directory is hidden": put("delta/ignored/CATKIN_IGNORE", ""),
    "somebody uses what was put aside": put(
        "alpha/calls/old.launch", '<launch><include file="$(find delta)/old/aside.launch"/></launch>\n'
    ),
    "a comment silences": put("delta/old/aside.launch", SILENT),
    "and silences nothing": put("delta/old/aside.launch", SILENT.replace("LL301", "LL302")),
    "a manifest that lacks what is used": replace("alpha/package.xml", "</package>", "<exec_depend>roscpp</exec_depend></package>"),
    "a level": put(".launchlint.yaml", "severity:\n  LL206: error\n"),
    "off somewhere": put(".launchlint.yaml", "per-file-ignores:\n  'alpha/**': [LL206, LL411]\n"),
    "entries": put(".launchlint.yaml", "entries:\n  - file: alpha/launch/e1.launch\n    args: {speed: '7'}\n"),
    "entries that are others": put(".launchlint.yaml", "entries:\n  - file: alpha/launch/e1.launch\n    args: {speed: '8'}\n"),
    "none": remove(".launchlint.yaml"),
}


def test_whatever_changes(workspace: Workspace) -> None:
    workspace.agrees()
    for name, change in CHANGES.items():
        change(workspace.directory)
        _, again = workspace.agrees()
        assert again == NOTHING, name


BLIND = """
contents.RACY = 10**18
contents._signature = lambda status: [7, 7, 7, 7, 7]
"""


def test_files_that_were_changed_a_moment_ago_are_told_by_their_content(workspace: Workspace) -> None:
    """Where ``stat`` may say nothing of a change, and in fact says nothing."""
    for name, change in list(CHANGES.items())[:6]:
        anew = workspace.run("--no-cache")[0]
        assert workspace.run(more=BLIND)[0] == anew, name
        assert workspace.run(more=BLIND) == (anew, NOTHING), name
        change(workspace.directory)


def test_few_are_read_where_one_has_changed(workspace: Workspace) -> None:
    workspace.run()
    replace("gamma/launch/e3.launch", 'name="drive"', 'name="driver"')(workspace.directory)
    first, again = workspace.agrees()
    directory = workspaces.EACH
    assert first == [1, directory - 1, 1, 0]  # those of its directory are looked at one by one; nothing else is told of it
    assert again == NOTHING
    replace("gamma/launch/e3.launch", "<launch>", "<launch>\n<arg name='idle'/>")(workspace.directory)
    first, again = workspace.agrees()
    assert first == [1, directory - 1, 1, 1]
    assert again == NOTHING


def test_what_says_the_same_is_told_as_it_was_unless_that_hangs_on_more(workspace: Workspace) -> None:
    """One launch file that says what it said, and beside it something that only those look at who judge all findings."""
    workspace.run()
    changes = {
        "a document": put("README.md", "roslaunch beta broken.launch idle:=2\n"),
        "a launch file": put("delta/calls/new.launch", CALLS.format(GIVES.format("new") + GIVES.format("x").replace("robot", "idle"))),
        "a manifest": replace("beta/package.xml", "</package>", "<exec_depend>roscpp</exec_depend></package>"),
        "a setup assistant": put("alpha/.setup_assistant", "moveit_setup_assistant_config: {}\n"),
        "a level": put(".launchlint.yaml", "severity:\n  LL206: error\n"),
    }
    for number, (name, change) in enumerate(changes.items()):
        put("gamma/launch/e3.launch", f"<launch>\n</launch>\n<!-- {number} -->\n")(workspace.directory)
        assert workspace.agrees()[1] == NOTHING
        put("gamma/launch/e3.launch", f"<launch>\n</launch>\n<!-- {number} again -->\n")(workspace.directory)
        change(workspace.directory)
        assert workspace.agrees()[1] == NOTHING, name


def test_files_that_change_while_all_is_told(workspace: Workspace) -> None:
    """What was told of the text of before is not taken for what is told of the one of now."""
    more = """
document = "README.md"
real = judges.judged

def judged(*given):
    told = real(*given)
    open(document, "w").write("roslaunch beta broken.launch idle:=2\\n")
    return told

judges.judged = judged
"""
    put("README.md", "roslaunch beta broken.launch robot:=2\n")(workspace.directory)
    workspace.run(more=more)
    assert workspace.agrees()[1] == NOTHING


def test_others_are_read_who_show_something_of_the_same_file(workspace: Workspace) -> None:
    workspace.run()
    replace("alpha/calls/one.launch", GIVES.format("one"), GIVES.format("uno"))(workspace.directory)
    first, again = workspace.agrees()
    assert first == [1, 2, 1, 1]  # who includes the same file, and that itself
    assert again == NOTHING


def test_what_is_asked_for_is_told(workspace: Workspace) -> None:
    for words in ((), ("alpha", "beta"), (), ("alpha", "beta", "gamma"), ("alpha", "beta", "gamma")):
        assert workspace.run(*words)[0] == workspace.run("--no-cache", *words)[0], words
    assert workspace.run()[1] == NOTHING  # that of all was kept beside that of a part


def test_what_only_a_judge_looks_at_in_a_hidden_directory(workspace: Workspace) -> None:
    aside = workspace.directory / ".parked"
    write(aside, {"x.launch": '<launch><node name="a" pkg="beta" type="nobody"/></launch>\n'})
    words = (".", ".parked/x.launch")
    before = workspace.run(*words)[0]
    assert workspace.run(*words) == (before, NOTHING)
    write(aside, {"package.xml.bak": ""})
    anew = workspace.run("--no-cache", *words)[0]
    assert anew != before
    assert workspace.run(*words)[0] == anew


def test_environment_variables(workspace: Workspace, monkeypatch: pytest.MonkeyPatch) -> None:
    workspace.agrees()
    for value in ("here", "there", ""):
        monkeypatch.setenv("WHERE_IT_IS", value)
        anew = workspace.run("--no-cache")[0]
        assert workspace.run()[0] == anew
        assert workspace.run() == (anew, NOTHING)


@pytest.mark.parametrize("more", ENDS.values(), ids=ENDS)
def test_a_run_that_ends(workspace: Workspace, more: str) -> None:
    workspace.run()
    for name in list(CHANGES)[:8]:
        CHANGES[name](workspace.directory)
        workspace.run(more=more)
        assert workspace.agrees()[1] == NOTHING, name
    replace("delta/package.xml", "</package>", "<exec_depend>beta</exec_depend></package>")(workspace.directory)
    workspace.run(more=more)
    assert workspace.agrees()[1] == NOTHING


MOMENTS = (
    replace("beta/parts/broken.launch", "<launch>\n", "<launch>\n\n\n"),
    replace("delta/package.xml", "</package>", "<exec_depend>beta</exec_depend></package>"),
    put("alpha/calls/more.launch", CALLS.format(GIVES.format("more"))),
)


OF_RUN = ("run", "telling", "looked", "outcome")
TABLES = ("entries", "files", "shared", "said", "groups", "told", "whole", "answers", "all", "rows", "programs", *OF_RUN)
"""Tables of the database, and keys in the one called ``held``."""


def test_rows_of_another_moment(workspace: Workspace, tmp_path: Path) -> None:
    """Other runs may write rows at any time: some may be older than others."""
    before, after, files = tmp_path / "before.sqlite", tmp_path / "after.sqlite", tmp_path / "files"
    one = workspace.directory / "alpha/calls/one.launch"
    text = one.read_text()
    for number, change in enumerate(MOMENTS):
        then = workspace.run()[0]
        shutil.copy(workspace.database, before)
        shutil.copytree(workspace.directory, files, dirs_exist_ok=True)
        change(workspace.directory)
        now = workspace.run("--no-cache")[0]
        assert workspace.run()[0] == now
        one.write_text(text.replace(GIVES.format("one"), GIVES.format("uno")))
        later = workspace.run("--no-cache")[0]
        one.write_text(text)
        shutil.copy(workspace.database, after)
        for table in TABLES:
            older(workspace.database, table, before)
            assert workspace.run()[0] == now, (number, table)
            older(workspace.database, table, before, *(("telling",) if table not in OF_RUN else ()))
            one.write_text(text.replace(GIVES.format("one"), GIVES.format("uno")))
            assert workspace.run()[0] == later, (number, table, "and one more change")
            one.write_text(text)
            shutil.copy(after, workspace.database)
        for table in ("groups", "told", "whole"):
            older(workspace.database, table, before, "telling")
            workspace.directory.rename(tmp_path / "aside")
            files.rename(workspace.directory)
            assert workspace.run()[0] == then, (number, table, "and all is as it was then")
            workspace.directory.rename(files)
            (tmp_path / "aside").rename(workspace.directory)
            shutil.copy(after, workspace.database)


def older(file: Path, table: str, before: Path, *without: str) -> None:
    """Put the rows of ``before`` into the database, and leave some of what is held out."""
    with closing(sqlite3.connect(file)) as database:
        database.execute("ATTACH ? AS before", (str(before),))
        is_table = database.execute("SELECT 1 FROM sqlite_master WHERE name = ?", (table,)).fetchone() is not None
        name, only = (table, "") if is_table else ("held", f"WHERE key = '{table}'")
        database.execute(f"INSERT OR REPLACE INTO {name} SELECT * FROM before.{name} {only}")
        for key in ("run" if table not in OF_RUN else "", *without):  # or nothing else would be looked at
            database.execute("DELETE FROM held WHERE key = ?", (key,))
        database.commit()


def test_rows_that_somebody_else_wrote(workspace: Workspace) -> None:
    from launchlint.check.rows import sealed

    said = workspace.run()[0]
    for key in ("whole", "programs", "answers", "all", *OF_RUN):
        for value in ([], {}, [1, 2, 3, 4, 5], "x", {"ROS 1": 7}, [[], [], {}, {}, {}]):
            with closing(sqlite3.connect(workspace.database)) as database:
                database.execute("INSERT OR REPLACE INTO held VALUES (?, ?)", (key, sealed(key, value)))
                database.commit()
            assert workspace.run()[0] == said, (key, json.dumps(value))
    for table in ("groups", "told"):
        with closing(sqlite3.connect(workspace.database)) as database:
            keys = [key for (key,) in database.execute(f"SELECT key FROM {table}")]
            database.executemany(f"INSERT OR REPLACE INTO {table} VALUES (?, ?)", [(key, sealed(key, [7])) for key in keys])
            database.execute("DELETE FROM held WHERE key = 'run'")
            database.commit()
        assert workspace.run()[0] == said, table
