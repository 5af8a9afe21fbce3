"""The result cache: never wrong, and never in the way."""

from __future__ import annotations

import json
import os
import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from launchlint.check import own_code, rows, surroundings
from launchlint.check.cache import Cache
from launchlint.check.entry import EntryChecker
from launchlint.check.options import Options
from launchlint.check.rows import MOST_DATABASES, sealed
from launchlint.rules.registry import RULES
from launchlint.workspace import contents, text_parts
from launchlint.workspace.contents import Contents
from launchlint.workspace.looking import state
from launchlint.workspace.packages import Packages
from tests.check.many import computed, many
from tests.cli.running import PACKAGE, clean_environment, run, write


class Repository:
    """A repository whose findings are asked for with and without the cache."""

    def __init__(self, directory: Path) -> None:
        self.directory = many(directory, 30)
        self.cache = directory.parent / f"{directory.name}-cache" / "launchlint"

    def findings(self, *words: str, **environment: str) -> list[str]:
        """All findings, the cache being used; they must be those found without it."""
        self._both(*words, **environment)
        return self._both(*words, **environment)

    def _both(self, *words: str, **environment: str) -> list[str]:
        with_cache = run(self.directory, "check", "--format", "json", *words, environment=environment)
        without = run(self.directory, "check", "--format", "json", "--no-cache", *words, environment=environment)
        assert with_cache == without
        return [f"{each['path']}:{each['line']} {each['rule']} {each['message']}" for each in json.loads(without.output)["findings"]]

    def computed(self, *words: str) -> int:
        """How many entry files are computed anew in one run with the cache."""
        return computed(self.directory, *words, cache=self.cache.parent)


@pytest.fixture
def repository(tmp_path: Path) -> Repository:
    return Repository(tmp_path / "repository")


FILES = 36


def test_a_second_run_computes_nothing(repository: Repository) -> None:
    assert repository.computed() == FILES
    assert repository.computed() == 0
    assert repository.computed("base", "arm/launch") == 0, "what was asked for does not matter"


def test_packages_of_one_name_are_no_reason_to_compute_again(repository: Repository) -> None:
    shutil.copytree(repository.directory / "arm", repository.directory / "old/arm")
    assert repository.computed() > 0
    assert repository.computed() == 0


def test_what_is_kept_grows_with_the_workspace_and_not_with_its_square(tmp_path: Path) -> None:
    def kept(count: int) -> int:
        repository = Repository(tmp_path / str(count))
        for number in range(count):
            name = f"package_{number:03}"
            write(repository.directory, {
                f"{name}/package.xml": PACKAGE.format(name=name),
                f"{name}/README.md": f"see other_{number}",
                f"{name}/config/wheel.yaml": "radius: 0.1\n",
                f"{name}/launch/a.launch": f'<launch><include file="$(find missing_{number})/launch/a.launch"/>'
                '<node name="n" pkg="lost" type="t" output="$(env TALK)"/></launch>\n',
            })  # fmt: skip
        repository.computed()
        connection = sqlite3.connect(database(repository))
        sizes = [connection.execute(f"SELECT sum(length(value)) FROM {table}").fetchone()[0] for table in ("entries", "files", "shared")]
        connection.close()
        return sum(size or 0 for size in sizes)

    few, more, most = map(kept, (30, 60, 120))
    assert most - more <= 2.3 * (more - few)


def test_only_what_changed_is_computed(repository: Repository) -> None:
    assert repository.computed() == FILES
    file = repository.directory / "arm/launch/entry000.launch"
    file.write_text(file.read_text().replace("robot0", "robot9"))
    assert repository.computed() == 1
    os.utime(file, (1, 1))
    assert repository.computed() == 0, "times do not matter"
    part = repository.directory / "arm/launch/part.launch"
    part.write_text(part.read_text() + "<!-- -->\n")
    assert repository.computed() == 16, "part.launch of arm, and the 15 entry files of arm that include it"


def change_included(directory: Path) -> None:
    write(
        directory,
        {"base/launch/part.launch": '<launch><arg name="robot"/><arg name="unused"/><param name="q" value="$(arg unused)"/></launch>\n'},
    )


def change_yaml(directory: Path) -> None:
    write(directory, {"arm/config/wheel.yaml": "radius: [\n"})


def remove_yaml(directory: Path) -> None:
    (directory / "arm/config/wheel.yaml").unlink()


def add_package(directory: Path) -> None:
    write(directory, {"armm/package.xml": PACKAGE.format(name="armm")})


def change_package(directory: Path) -> None:
    write(directory, {"base/package.xml": PACKAGE.format(name="bass")})


def declare_dependency(directory: Path) -> None:
    text = PACKAGE.format(name="arm").replace("</license>", "</license><exec_depend>base</exec_depend>")
    write(directory, {"arm/package.xml": text})


def change_build_file(directory: Path) -> None:
    write(directory, {"arm/CMakeLists.txt": "project(x)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"})


def change_included_build_file(directory: Path) -> None:
    text = (directory / "arm/CMakeLists.txt").read_text()
    write(directory, {"arm/CMakeLists.txt": text + "include(cmake/more.cmake)\n", "arm/cmake/more.cmake": "\n"})


def change_only_the_included_build_file(directory: Path) -> None:
    write(directory, {"arm/cmake/more.cmake": "add_executable(drve drive.cpp)\n"})


def list_sources(directory: Path) -> None:
    write(directory, {".gitmodules": '[submodule "x"]\n  path = lib/armm\n', "more.repos": "repositories:\n"})


def take_executable_bit(directory: Path) -> None:
    (directory / "base/scripts/talk.py").chmod(0o644)


def take_first_line(directory: Path) -> None:
    (directory / "base/scripts/talk.py").write_text("import rospy\n")


def add_near_name(directory: Path) -> None:
    write(directory, {"arm/launch/prd.launch": "<launch/>\n"})


def ignore_package(directory: Path) -> None:
    write(directory, {"base/CATKIN_IGNORE": ""})


def link_package(directory: Path) -> None:
    write(directory.parent, {"elsewhere/armm/package.xml": PACKAGE.format(name="armm")})
    (directory / "linked").symlink_to(directory.parent / "elsewhere")


@pytest.mark.parametrize(
    ("change", "appears", "disappears"),
    [
        ([change_included], "LL407", None),
        ([change_yaml], "LL503", None),
        ([remove_yaml], "LL502", None),
        ([add_package], None, "the package armm is not known"),
        ([list_sources], None, "the package armm is not known"),
        ([change_package], "package base is not known", None),
        ([declare_dependency], None, "does not declare base, which arm/"),
        ([change_build_file], "has no executable drive", None),
        ([change_included_build_file, change_only_the_included_build_file], None, "has no executable drve"),
        ([take_executable_bit], "LL305", None),
        ([take_first_line], "LL305", None),
        ([add_near_name], None, None),
        ([ignore_package], "LL210", None),
        ([link_package], None, "the package armm is not known"),
    ],
    ids=lambda value: value[-1].__name__ if isinstance(value, list) else "",
)
def test_every_change_is_noticed(
    repository: Repository, change: list[Callable[[Path], None]], appears: str | None, disappears: str | None
) -> None:
    before = "\n".join(repository.findings())
    for step in change:
        step(repository.directory)
        after = "\n".join(repository.findings())
    assert after != before or change == [add_near_name]
    if appears is not None:
        assert after.count(appears) > before.count(appears)
    if disappears is not None:
        assert after.count(disappears) < before.count(disappears)


def test_a_hint_from_looking_around_is_noticed(repository: Repository) -> None:
    """The nearest name is part of a finding, wherever the directory is."""
    words = ["check", "--format", "text", "--select", "LL401"]
    # Where part.launch is included anyhow, it is not what was meant; two files of another package do not include it.
    assert run(repository.directory, *words).output.count("did you mean $(find arm)/launch/part.launch?") == 1
    write(repository.directory, {"arm/launch/prts.launch": "<launch/>\n"})
    assert "did you mean $(find arm)/launch/prts.launch?" in run(repository.directory, *words).output
    write(repository.directory, {"arm/launch/prt1.launch": "<launch/>\n"})
    assert run(repository.directory, *words) == run(repository.directory, *words, "--no-cache")
    outside = repository.directory.parent / "outside"
    write(repository.directory, {"arm/launch/entry000.launch": f'<launch><include file="{outside}/a/robot.launch"/></launch>\n'})
    for step in ({"a/robots.launch": "<launch/>\n"}, {"a/robot2.launch": "<launch/>\n"}, {"a/robot.launch": "<launch/>\n"}):
        assert run(repository.directory, *words) == run(repository.directory, *words, "--no-cache")
        write(outside, step)
    assert run(repository.directory, *words) == run(repository.directory, *words, "--no-cache")


STEPS: dict[str, tuple[dict[str, str], str]] = {
    ".gitignore": ({".gitignore": "prt.launch\n"}, "git ignores it (prt.launch in .gitignore)"),
    "another pattern": ({".gitignore": "/arm/launch/prt*\n"}, "git ignores it (/arm/launch/prt* in .gitignore)"),
    ".gitignore below": ({".gitignore": "", "arm/launch/.gitignore": "prt.launch\n"}, "in arm/launch/.gitignore)"),
    "the clone's own": ({"arm/launch/.gitignore": "", ".git/info/exclude": "prt.launch\n"}, "in .git/info/exclude)"),
    "template": ({".git/info/exclude": "", "arm/launch/prt.launch.in": "<launch/>\n"}, "arm/launch/prt.launch.in lies beside it"),
    "CMake": ({"arm/CMakeLists.txt": "configure_file(prt.in launch/prt.launch)\n"}, "configure_file (CMakeLists.txt, line 1)"),
    "included": (
        {"arm/CMakeLists.txt": "\ninclude(more.cmake)\n", "arm/more.cmake": "em_expand(a b c prt.launch)\n"},
        "(more.cmake, line 1)",
    ),
}


def test_what_makes_a_file_is_noticed(repository: Repository) -> None:
    """A file that is not here is told of in another way where something makes it."""
    words = ["check", "--format", "text", "--select", "LL401", "-v"]
    assert "error LL401 include-not-found: the included file arm/launch/prt.launch" in run(repository.directory, *words).output
    for name, (files, reason) in STEPS.items():
        write(repository.directory, files)
        told = run(repository.directory, *words)
        assert reason in told.output, name
        assert "error LL401" not in told.output
        assert told == run(repository.directory, *words, "--no-cache")


def test_environment_variables_are_noticed(repository: Repository) -> None:
    unset = repository.findings()
    assert any("TALK_OUTPUT" in finding for finding in unset)
    assert not any("TALK_OUTPUT" in finding for finding in repository.findings(TALK_OUTPUT="screen"))
    assert any("loud" in finding for finding in repository.findings(TALK_OUTPUT="loud"))
    assert repository.findings() == unset


def test_hooks_that_set_variables_are_noticed(repository: Repository) -> None:
    def told() -> bool:
        return any("TALK_OUTPUT" in finding for finding in repository.findings())

    assert told()
    write(repository.directory, {"base/env-hooks/50.base.sh.em": "export TALK_OTHER=1\n"})
    assert told()
    write(repository.directory, {"base/env-hooks/50.base.sh.em": "export TALK_OUTPUT=@(output)\n"})
    assert not told()
    write(repository.directory, {"base/env-hooks/50.base.sh.em": "\n", "arm/60.arm.bash": "export TALK_OUTPUT=screen\n"})
    assert told()
    write(repository.directory, {"arm/CMakeLists.txt": "catkin_add_env_hooks(60.arm SHELLS bash DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})\n"})
    assert not told()
    write(repository.directory, {"arm/60.arm.bash": "# export TALK_OUTPUT=screen\n"})
    assert told()


def test_packages_of_the_environment_are_noticed(repository: Repository, tmp_path: Path) -> None:
    """Those on ROS_PACKAGE_PATH lie outside of the checked repository."""
    path = tmp_path / "more"
    path.mkdir()
    without = repository.findings(ROS_PACKAGE_PATH=str(path))
    write(path, {"armm/package.xml": PACKAGE.format(name="armm")})
    assert repository.findings(ROS_PACKAGE_PATH=str(path)) != without
    write(path, {"armm/scripts/drive": "#!/bin/sh\n"})
    before = repository.findings(ROS_PACKAGE_PATH=str(path))
    (path / "armm/scripts/drive").chmod(0o755)
    assert repository.findings(ROS_PACKAGE_PATH=str(path)) != before


def test_options_are_noticed(repository: Repository) -> None:
    everything = repository.findings()
    assert {finding.split()[1] for finding in repository.findings("--select", "LL301")} == {"LL301"}
    assert repository.findings("--arg", "sim:=false") != everything
    assert repository.findings("--workspace", "arm") != everything
    assert repository.findings() == everything


def test_another_version_starts_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    options = Options(frozenset(), (), True, {}, "/")

    def name() -> str | None:
        held = Contents(str(tmp_path / "contents"))
        return surroundings.Surroundings(options, Packages((), {}, explicit=True), held, own_code.own_code(held)).name

    now = name()
    assert name() == now
    monkeypatch.setattr(own_code, "__version__", "99.0")
    other = name()
    assert other != now
    monkeypatch.setattr(own_code, "_parts", lambda held: iter(["changed"]))
    assert name() not in (now, other)


def test_with_very_many_files_there_is_no_cache(repository: Repository, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(surroundings, "MOST_FILES", 20)
    workspaces = (str(repository.directory),)
    packages = Packages(workspaces, {}, explicit=True)
    options = Options(frozenset(), workspaces, True, {}, "/")
    assert surroundings.Surroundings(options, packages, Contents(str(tmp_path / "contents")), "").name is None


def database(repository: Repository) -> Path:
    (file,) = repository.cache.glob("*.sqlite")
    return file


def destroy(file: Path) -> None:
    file.write_bytes(b"this is no database" * 1000)


def truncate(file: Path) -> None:
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def scramble(file: Path) -> None:
    data = bytearray(file.read_bytes())
    for offset in range(4096, len(data), 97):
        data[offset] ^= 0x55
    file.write_bytes(bytes(data))


def empty(file: Path) -> None:
    file.write_bytes(b"")


def rewrite_values(file: Path) -> None:
    with sqlite3.connect(file) as connection:
        connection.execute("UPDATE entries SET value = replace(value, 'error', 'fine')")
    connection.close()


def other_tables(file: Path) -> None:
    file.unlink()
    with sqlite3.connect(file) as connection:
        connection.execute("CREATE TABLE entries (a, b, c)")
    connection.close()


def directory_instead(file: Path) -> None:
    file.unlink()
    file.mkdir()


@pytest.mark.parametrize("damage", [destroy, truncate, scramble, empty, rewrite_values, other_tables, directory_instead])
def test_a_damaged_cache_is_passed_over(repository: Repository, damage: Callable[[Path], None]) -> None:
    before = run(repository.directory, "check")
    assert repository.computed() == 0
    damage(database(repository))
    after = run(repository.directory, "check")
    assert after == before
    assert after.errors == ""
    assert repository.findings()


def test_a_database_that_has_grown_too_large_is_begun_anew(repository: Repository, monkeypatch: pytest.MonkeyPatch) -> None:
    assert repository.computed() == FILES
    file = database(repository)
    before = file.stat().st_ino
    monkeypatch.setattr(rows, "LARGEST_DATABASE", file.stat().st_size)
    rows.Rows(str(file.parent), file.name).close()
    assert file.stat().st_ino == before
    monkeypatch.setattr(rows, "LARGEST_DATABASE", file.stat().st_size - 1)
    rows.Rows(str(file.parent), file.name).close()
    assert repository.computed() == FILES


def test_values_from_somebody_else_do_no_harm(repository: Repository) -> None:
    """Even with the right seal: what does not have the right form is computed anew."""
    before = run(repository.directory, "check")
    holds: list[object] = [[], [], [[], [], []], []]
    for value in (
        *([], {}, None, 1, holds, [*holds, 1], [*holds, {"a": 1}], [*holds, [1] * 11], [[["a"]], 1, 2, 3, 4], [[], [], [[]], [], [1] * 11]),
        *([[], [], [[], [{}], []], [], [1] * 11], [[], [], [[], [], ["?"]], [], [1] * 11]),
        [[], [], [[], [], [["?rospack os:system true", ""], ["?", 1]]], [], [1] * 11],
        [[], [], [[["a", 1, 2]], ["x"], []], [], [*[1] * 6, ["ros1 arm/launch/part.launch"], *[1] * 4]],
    ):
        file = database(repository)
        with sqlite3.connect(file) as connection:
            keys = [key for (key,) in connection.execute("SELECT key FROM entries")]
            connection.executemany("UPDATE entries SET value = ? WHERE key = ?", [(sealed(key, value), key) for key in keys])
        connection.close()
        assert run(repository.directory, "check") == before, value


def test_what_somebody_else_says_of_other_rows_does_no_harm(repository: Repository) -> None:
    """What holds, what was answered, and what the stamp of the workspaces says."""
    before = run(repository.directory, "check")
    for value in ([], {}, None, 1, [1, 2], [["a"], {"?rospack get arm": ["", [7]]}], [[], {"?": 1}], ["", ["a"]], [[], "a"]):
        (repository.directory / f"{len(json.dumps(value))}.txt").write_text("")  # so that it is looked at
        with sqlite3.connect(database(repository)) as connection:
            for table in ("held", "said", "shared"):
                keys = [key for (key,) in connection.execute(f"SELECT key FROM {table}")]
                connection.executemany(f"UPDATE {table} SET value = ? WHERE key = ?", [(sealed(key, value), key) for key in keys])
        connection.close()
        assert run(repository.directory, "check") == before, value


@pytest.mark.parametrize("kind", ["file", "read-only", "below a file"])
def test_a_cache_directory_that_cannot_be_used(repository: Repository, tmp_path: Path, kind: str) -> None:
    place = tmp_path / "cache-place"
    if kind == "file":
        place.write_text("")
    elif kind == "below a file":
        (tmp_path / "plain").write_text("")
        place = tmp_path / "plain" / "below"
    else:
        place.mkdir()
        place.chmod(0o500)
    before = run(repository.directory, "check", "--no-cache")
    assert run(repository.directory, "check", environment={"XDG_CACHE_HOME": str(place)}) == before


def test_a_relative_cache_home_is_no_cache_home(repository: Repository) -> None:
    """As the XDG base directory specification says; nothing is written into the checked repository."""
    home = repository.directory.parent / "home"
    home.mkdir()
    run(repository.directory, "check", environment={"XDG_CACHE_HOME": "cache", "HOME": str(home)})
    assert not (repository.directory / "cache").exists()
    assert (home / ".cache" / "launchlint").is_dir()


def test_no_cache_neither_reads_nor_writes(repository: Repository) -> None:
    run(repository.directory, "check", "--no-cache")
    assert not repository.cache.exists()


def test_two_processes_at_once(repository: Repository) -> None:
    expected = run(repository.directory, "check", "--no-cache")
    for _ in range(3):
        processes = [
            subprocess.Popen(
                [sys.executable, "-m", "launchlint", "check", "--jobs", "1"], cwd=repository.directory,
                env=clean_environment(repository.cache.parent), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            )
            for _ in range(4)
        ]  # fmt: skip
        for process in processes:
            output, errors = process.communicate(timeout=120)
            assert (process.returncode, output, errors) == expected
        shutil.rmtree(repository.cache)


def test_text_that_stands_in_for_a_file_is_not_kept(repository: Repository) -> None:
    """``as:`` judges other text under the name of a file: that file's own result must stay what it is."""
    listed = [{"file": "arm/launch/part.launch", "as": f"arm/launch/entry{number:03}.launch"} for number in range(0, 30, 2)]
    write(repository.directory, {"entries.json": json.dumps(listed * 2)})
    before = run(repository.directory, "check", "--no-cache")
    other = run(repository.directory, "check", "--entries", "entries.json")
    assert run(repository.directory, "check") == before
    assert run(repository.directory, "check", "--entries", "entries.json") == other
    assert run(repository.directory, "check") == before


def test_the_cache_does_not_grow_without_end(repository: Repository) -> None:
    """Other settings, another database."""
    for rule in RULES[: MOST_DATABASES + 6]:
        run(repository.directory, "check", "-q", "--jobs", "1", "--select", rule.id)
    assert len(list(repository.cache.glob("*.sqlite"))) == MOST_DATABASES


def test_a_part_of_a_text_is_looked_for_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    workspace = tmp_path / "ws"
    workspace.mkdir()
    source = workspace / "talker.py"
    source.write_text("rospy.Publisher('chatter', String)\n")
    looked: list[str] = []
    topics = text_parts.PARTS["topics"]

    def found(text: str) -> Sequence[str]:
        looked.append(text)
        return topics(text)

    monkeypatch.setattr(text_parts, "PARTS", {"topics": found})
    monkeypatch.setattr(contents, "WORTH_WRITING", 1)
    part = f"{source}//topics"
    known = state(part)

    def holds() -> bool:
        checker = EntryChecker(Options(frozenset(), (str(workspace),), True, {}, str(workspace)))
        cache = Cache(str(tmp_path / "cache"), checker)
        try:
            return cache.states.of(part) == known
        finally:
            cache.close()
            assert checker.packages.held is not None
            checker.packages.held.keep()

    looked.clear()
    assert [holds() for _ in range(3)] == [True, True, True]
    assert len(looked) == 1
    source.write_text("# the rest of the text\nrospy.Publisher('chatter', String)\n")
    assert [holds(), holds()] == [True, True]
    assert len(looked) == 2
    source.write_text("rospy.Publisher('chat', String)\n")
    assert [holds(), holds()] == [False, False]
