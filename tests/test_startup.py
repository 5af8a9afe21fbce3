"""Cold start is the product: what `launchlint check one.launch` imports, and what it does not.

Timers lie on busy machines, `sys.modules` does not.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent

PLAIN = """\
<launch>
  <arg name="rate" default="10"/>
  <group ns="robot">
    <node name="talker" pkg="demo_nodes" type="talker" output="screen">
      <param name="rate" value="$(arg rate)"/>
      <remap from="chatter" to="talk"/>
    </node>
  </group>
</launch>
"""

# Each of these costs milliseconds, or hundreds of them, and one file needs none of them.
HEAVY = (
    "asyncio",
    "attr",
    "concurrent.futures",
    "dataclasses",
    "docker",
    "email",
    "http",
    "jinja2",
    "lxml",
    "multiprocessing",
    "networkx",
    "requests",
    "sarif_om",
    "ssl",
    "tree_sitter",
    "unittest",
    "urllib.request",
    "yaml",
)

NOT_ASKED = (
    *("launchlint.workspace.cmake", "launchlint.workspace.cmake_facts", "launchlint.workspace.executables", "shlex"),
    *("launchlint.rules.judging.left_out", "launchlint.rules.judging.ros2_params", "ast", "unicodedata"),
)
"""What is needed where a node lies in a package that is here, or a file of it is named; where something is told; in ROS 2."""

MOST_PATTERNS = 30
"""Regular expressions compiled on the way: each takes as long as to import a small module."""

SHOW_MODULES = """
import json, re, sys
before = set(sys.modules)
from launchlint.cli import main
try:
    main(sys.argv[1:], standalone_mode=False)
except SystemExit:
    pass
print()
print(json.dumps([len(re._cache), *sorted(set(sys.modules) - before)]))
"""


def modules_after(arguments: list[str], directory: Path) -> set[str]:
    """Names of all modules that launchlint, run with ``arguments`` in ``directory``, has imported."""
    return after(arguments, directory)[1]


def after(arguments: list[str], directory: Path) -> tuple[int, set[str]]:
    """How many regular expressions launchlint, run with ``arguments`` in ``directory``, has compiled, and the modules it has imported."""
    command = [sys.executable, "-c", SHOW_MODULES, *arguments]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "XDG_CACHE_HOME": str(directory / ".cache")}
    run = subprocess.run(command, cwd=directory, env=environment, capture_output=True, text=True, timeout=60, check=False)
    assert run.returncode == 0, run.stderr
    patterns, *modules = json.loads(run.stdout.splitlines()[-1])
    return patterns, set(modules)


def among(modules: set[str], names: tuple[str, ...]) -> list[str]:
    return [name for name in names if name in modules or any(module.startswith(f"{name}.") for module in modules)]


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package with one plain launch file."""
    (tmp_path / ".git").mkdir()
    (tmp_path / "package.xml").write_text(
        '<package format="2"><name>demo</name><version>1.0.0</version><description>A demo.</description>'
        '<maintainer email="a@example.com">A</maintainer><license>MIT</license><exec_depend>demo_nodes</exec_depend></package>\n',
        encoding="utf-8",
    )
    (tmp_path / "plain.launch").write_text(PLAIN, encoding="utf-8")
    return tmp_path


def test_check_of_one_plain_file_imports_nothing_heavy(package: Path) -> None:
    patterns, modules = after(["check", "plain.launch"], package)
    assert "launchlint.cli" in modules
    assert among(modules, (*HEAVY, *NOT_ASKED)) == []
    assert patterns <= MOST_PATTERNS


def test_check_makes_the_graph_and_neither_records_nor_pictures_of_it(package: Path) -> None:
    text = PLAIN.replace('pkg="demo_nodes" type="talker"', 'pkg="turtlesim" type="turtlesim_node"')
    (package / "known.launch").write_text(text, encoding="utf-8")
    modules = modules_after(["check", "known.launch"], package)
    assert "launchlint.graph.connect" in modules
    rooms = ("launchlint.graph.topology", "launchlint.library.file", "launchlint.library.format", "launchlint.report.graph")
    not_needed = (*rooms, "hashlib", "typing")
    assert among(modules, (*HEAVY, *not_needed)) == []


def test_sources_are_read_only_for_a_program_of_these_packages_that_nobody_knows_better(package: Path) -> None:
    rooms = ("launchlint.extract", "launchlint.knowledge.programs", "launchlint.knowledge.reading", "tree_sitter")
    launch = PLAIN.replace('pkg="demo_nodes" type="talker"', 'pkg="demo" type="talker.py"')
    (package / "own.launch").write_text(launch, encoding="utf-8")
    assert among(modules_after(["check", "plain.launch"], package), rooms) == []
    assert among(modules_after(["check", "--no-extract", "own.launch"], package), rooms) == []
    # Python's own parser is enough for a script; and what is known already needs none.
    (package / "talker.py").write_text("#!/usr/bin/env python3\nimport rospy\n", encoding="utf-8")
    (package / "talker.py").chmod(0o755)
    assert among(modules_after(["check", "own.launch"], package), rooms) == list(rooms[:3])
    assert among(modules_after(["check", "own.launch"], package), rooms) == ["launchlint.knowledge.programs"]


def test_second_check_with_a_warm_cache_imports_nothing_heavy(package: Path) -> None:
    modules_after(["check", "plain.launch"], package)
    assert among(modules_after(["check", "plain.launch"], package), HEAVY) == []


def test_check_of_a_file_with_rosparam_may_import_yaml_and_no_more(package: Path) -> None:
    text = PLAIN.replace('<group ns="robot">', '<rosparam>{gain: 1.5}</rosparam>\n  <group ns="robot">')
    (package / "yaml.launch").write_text(text, encoding="utf-8")
    heavier = tuple(name for name in HEAVY if name != "yaml")
    assert among(modules_after(["check", "yaml.launch"], package), heavier) == []


def test_format_of_one_file_imports_neither_click_nor_what_evaluates(package: Path) -> None:
    not_needed = ("click", "difflib", "launchlint.rules", "launchlint.graph", "launchlint.library", "launchlint.workspace.packages")
    for words in (["format", "plain.launch"], ["format", "--check", "-q", "plain.launch"]):
        modules = modules_after(words, package)
        assert "launchlint.fix.format.printer" in modules
        assert among(modules, (*HEAVY, *not_needed)) == []


def test_version_and_help_import_hardly_anything(package: Path) -> None:
    for option in ("--version", "--help"):
        modules = modules_after([option], package)
        assert among(modules, HEAVY) == []
        rooms = {module.split(".")[1] for module in modules if module.startswith("launchlint.")}
        assert rooms & {"evaluate", "syntax", "rules", "workspace", "report"} == set(), option
