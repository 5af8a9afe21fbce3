"""Launch files in Python that ask the machine: directories, patterns of names, the command line, clocks; what of it can be told."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from launchlint.cli import main
from launchlint.syntax.ros2.python import patterns
from tests.syntax.ros2.python.test_python_libraries import Asked, asked, model

__all__ = ["asked"]
FILES = {"config__a": "", "config__b": "", "config__c": ""}


def started(tmp_path: Path, body: str, asked: Asked) -> dict[str, Any]:
    return model(tmp_path, body, asked, **FILES)


def names(found: dict[str, Any]) -> list[Any]:
    return [node.get("name") for node in found["nodes"]]


SORTED = "return LaunchDescription([Node(package='robot', executable='drive', name=n) for n in {}])"


@pytest.mark.parametrize(
    "listed",
    [
        "sorted(f[:-3] for f in os.listdir(share + '/config'))",
        "sorted([p.stem for p in (Path(share) / 'config').iterdir()])",
        "[p.stem for p in sorted(Path(share).glob('config/*.py'))]",
        "[os.path.basename(p)[:-3] for p in sorted(glob.glob(share + '/*/[abc].py'))]",
        "sorted({p.stem for p in Path(share).rglob('?.py')})",
    ],
)
def test_what_is_in_a_directory(listed: str, tmp_path: Path, asked: Asked) -> None:
    found = started(tmp_path, "import glob\n" + SORTED.format(listed), asked)
    assert names(found) == ["a", "b", "c"]
    assert (found["verdict"], found["complete"]) == ("ok", True)


def test_the_order_of_a_directory_is_nobodys(tmp_path: Path, asked: Asked) -> None:
    body = (
        "import re\n"
        "found = []\n"
        "first = None\n"
        "for each in (Path(share) / 'config').iterdir():\n"
        "    match = re.compile(r'^(.*)\\.py$').search(each.name)\n"
        "    first = first or match.group(1)\n"
        "    if match:\n"
        "        found.append(match.groups()[0])\n"
        "last = 'b' if 'b' in found and len(found) == 3 else 'x'\n"
        "return LaunchDescription([Node(package='robot', executable='drive', name=last, arguments=found),\n"
        "                          Node(package='robot', executable='drive', name=first, arguments=sorted(found))])"
    )
    one, other = started(tmp_path, body, asked)["nodes"]
    assert one["name"] == "b"
    assert "unknown" in one["arguments"]
    assert "unknown" in other["name"]
    assert other["arguments"] == ["a", "b", "c"]


def test_nodes_for_whatever_is_there(tmp_path: Path, asked: Asked) -> None:
    body = (
        "ld = LaunchDescription()\n"
        "for each in os.listdir(os.path.join(share, 'config')):\n"
        "    ld.add_action(Node(package='robot', executable='drive', name=os.path.splitext(each)[0]))\n"
        "return ld"
    )
    found = started(tmp_path, body, asked)
    assert sorted(names(found)) == ["a", "b", "c"]
    assert found["complete"] is True
    assert not any(node.get("maybe") for node in found["nodes"])


def test_the_command_line(tmp_path: Path, asked: Asked) -> None:
    body = (
        "import sys\n"
        "given = [each for each in sys.argv if len(each.split(':=')) == 2]\n"
        "name = 'plain'\n"
        "for each in sys.argv:\n"
        "    if each.startswith('name:='):\n"
        "        name = each[6:]\n"
        "return LaunchDescription([Node(package='robot', executable='drive', name=name, arguments=given)])"
    )
    (found,) = started(tmp_path, body, asked)["nodes"]
    assert (found["name"], found.get("arguments")) == ("plain", None) or (found["name"], found["arguments"]) == ("plain", [])


def test_what_the_moment_says_raises_nothing(tmp_path: Path, asked: Asked) -> None:
    body = (
        "import datetime, logging, tempfile, time\n"
        "from typing import List, Optional\n"
        "names: Optional[List[str]] = []\n"
        "kinds = List[str]\n"
        "logging.getLogger('x').info('%s', time.time())\n"
        "stamp = datetime.datetime.now().strftime('%Y')\n"
        "tool = node(arguments=['-o', 'run_' + stamp], cwd=tempfile.mkdtemp(prefix='x'))\n"
        "return LaunchDescription([tool])"
    )
    found = started(tmp_path, body, asked)
    assert found["verdict"] == "ok"
    assert "datetime" not in str(found["nodes"][0]["arguments"])
    assert "strftime" in str(found["nodes"][0]["arguments"])


def test_a_substitution_of_the_programs_own(tmp_path: Path, asked: Asked) -> None:
    body = (
        "from launch import Substitution\n"
        "class Louder(Substitution):\n"
        "    def __init__(self, of):\n"
        "        self.of = of\n"
        "    def perform(self, context):\n"
        "        return self.of.perform(context).upper()\n"
        "loud = Louder(LaunchConfiguration('x'))\n"
        "return LaunchDescription([DeclareLaunchArgument('x', default_value='low'), node(arguments=[loud], parameters=[{'p': loud}])])"
    )
    (found,) = started(tmp_path, body, asked)["nodes"]
    assert found["arguments"] == ["LOW"]
    assert found["parameters"] == {"p": ["str", "LOW"]}


def test_where_a_package_is(tmp_path: Path, asked: Asked) -> None:
    body = (
        "from ament_index_python.packages import get_package_share_path\n"
        "from launch_ros.substitutions import FindPackageShare\n"
        "return LaunchDescription([node(arguments=[str(get_package_share_path('robot') / 'x'), FindPackageShare('robot').find('robot')])])"
    )
    (found,) = started(tmp_path, body, asked)["nodes"]
    assert found["arguments"] == [f"{tmp_path}/x", str(tmp_path)]


@pytest.mark.parametrize("pattern", ["(a+)+b", "(a|aa)*c", r"(a)\1", "a*a*a*a*a*a*b", "x" * 400])
def test_patterns_that_may_take_long_are_not_worked_out(pattern: str) -> None:
    text = "a" * 200
    found = patterns.call("re.search", [pattern, text], {}, lambda size: None)
    assert type(found).__name__ == "Missing"


def test_the_command_line_that_gives_arguments(tmp_path: Path, asked: Asked) -> None:
    started(tmp_path, "import sys\nreturn LaunchDescription([node(arguments=[a for a in sys.argv if ':=' in a])])", asked)
    entries = tmp_path / "entries.yaml"
    entries.write_text("".join(f"- {{file: {tmp_path}/launch/a.launch.py, args: {{a: '{given}'}}}}\n" for given in "12"), encoding="utf-8")
    main(["model", "--format", "jsonl", "--workspace", str(tmp_path), "--entries", str(entries)], standalone_mode=False)
    one, other = map(json.loads, asked[1].readouterr().out.splitlines())
    assert one["nodes"][0]["arguments"] == ["a:=1"]
    assert other["nodes"][0]["arguments"] == ["a:=2"]


@pytest.mark.parametrize(
    ("body", "rule"),
    [
        ("raise RuntimeError('not today')", "LL949"),
        ("return LaunchDescription([node(arguments=[{'a': 'b'}['c']])])", "LL949"),
        ("return LaunchDescription([node(arguments=[open(share + '/none.txt').read()])])", "LL949"),
        ("return LaunchDescription([node(arguments=[get_package_share_directory('nobody')])])", "LL210"),
        ("return LaunchDescription([node(arguments=[os.environ['NOT_SET_ANYWHERE']])])", "LL209"),
        ("def f(context):\n    assert False, 'no'\nreturn LaunchDescription([OpaqueFunction(function=f)])", "LL949"),
        (
            "return LaunchDescription([RewrittenYaml(source_file=params, param_rewrites={'a': os.environ.get('NOT_SET_ANYWHERE')})])",
            "LL922",
        ),
    ],
)
def test_a_program_that_ends_with_an_exception_for_certain(body: str, rule: str, tmp_path: Path, asked: Asked) -> None:
    found = started(tmp_path, body, asked)
    assert (found["verdict"], found["error"]["rule"]) == ("error", rule)


@pytest.mark.parametrize(
    "body",
    [
        "if os.getcwd() == '/x':\n    raise RuntimeError('not today')\nreturn LaunchDescription([])",
        "try:\n    os.environ['NOT_SET_ANYWHERE']\nexcept KeyError:\n    pass\nreturn LaunchDescription([])",
    ],
)
def test_a_program_that_may_end_with_an_exception(body: str, tmp_path: Path, asked: Asked) -> None:
    assert started(tmp_path, body, asked)["error"] is None


def test_an_object_of_a_class_that_is_made_of_one_of_launch(tmp_path: Path, asked: Asked) -> None:
    body = (
        "class Flag(DeclareLaunchArgument):\n"
        "    def __init__(self, name, *, default=False):\n"
        "        super().__init__(name, default_value=str(default), choices=['True', 'False'])\n"
        "return LaunchDescription([Flag('deep'), node(arguments=[LaunchConfiguration('deep')])])"
    )
    found = started(tmp_path, body, asked)
    assert found["args"][0]["value"] == "False"
    assert found["nodes"][0]["arguments"] == ["False"]
