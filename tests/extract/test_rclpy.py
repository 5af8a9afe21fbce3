"""Small programs of rclpy and all that is found in them.

A case is a file: the program, a line of dashes, what is found. ``--update`` writes the latter.
"""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from launchlint.extract.fact import Descriptor, Fact, Made, Qos
from launchlint.extract.python.program import Extracted
from launchlint.extract.python.ros2.modules import AmentModules
from launchlint.extract.python.ros2.program import rclpy_program
from tests.cli.running import write

CASES = Path(__file__).parent / "rclpy_cases"
LINE = "-----\n"
MANIFEST = "<package format='3'><name>p</name><export><build_type>ament_python</build_type></export></package>"


def shown(found: Extracted) -> str:
    """What was found, a line each."""
    lines = [of_node(node) for node in found.nodes]
    lines += [told(fact) for fact in found.facts]
    doubts: dict[str, list[str]] = {}
    for each in found.doubts:
        doubts.setdefault(f"{each.reason} @{each.path}:{each.line}", []).append(each.category)
    lines += [f"? {', '.join(categories) if len(categories) < 6 else 'all'}: {reason}" for reason, categories in doubts.items()]
    return "".join(f"{line}\n" for line in lines)


def of_node(node: Made) -> str:
    """A node in one line."""
    words = [f"node {node.name or '?'}", f"as {node.key}" if node.key else "", f"in {node.namespace}" if node.namespace else ""]
    words += [each for each in ("lifecycle", "managed", "undeclared") if getattr(node, each)]
    return " ".join([*filter(None, words), f"@{node.line}", *([f"if {node.condition}"] if node.condition else [])])


def told(fact: Fact) -> str:
    """A fact in one line: what is not at its default."""
    words = [fact.category, fact.name, fact.type]
    for name in ("role", "node", "default", "value_type", "declared", "when", "exists"):
        value = getattr(fact, name)
        if name == "default":
            words += [] if value is None else [f"default={value!r}"]
        elif value not in ("", None, "start"):
            words.append(f"{name}={value}")
    words += [] if fact.descriptor is None else [_said(fact.descriptor, Descriptor())]
    words += [] if fact.qos is None else [_said(fact.qos, Qos())]
    place = f"@{fact.line}" if fact.path == "node.py" else f"@{fact.path}:{fact.line}"
    return " ".join(filter(None, [*words, place, f"if {fact.condition}" if fact.condition else ""]))


def _said(value: Descriptor | Qos, plain: Descriptor | Qos) -> str:
    known = [f"{name}={getattr(value, name)}" for name in value._fields if getattr(value, name) != getattr(plain, name)]
    return f"({' '.join(known)})"


def follow(directory: Path, source: str, entry: str = "", path: str = "node.py") -> Extracted:
    """What ``source`` does, alone in a package."""
    write(directory, {path: source})
    return rclpy_program(str(directory / path), str(directory), str(directory), AmentModules({str(directory): "p"}), entry)


@pytest.mark.parametrize("case", sorted(CASES.glob("*.txt")), ids=lambda case: case.stem)
def test_program(case: Path, tmp_path: Path, update: bool) -> None:
    source, _, expected = case.read_text(encoding="utf-8").partition(LINE)
    found = shown(follow(tmp_path, source))
    if update:
        case.write_text(source + LINE + found, encoding="utf-8")
    else:
        assert found == expected


@pytest.mark.parametrize("case", sorted(CASES.glob("*.txt")), ids=lambda case: case.stem)
def test_the_same_program_twice_is_the_same(case: Path, tmp_path: Path) -> None:
    source = case.read_text(encoding="utf-8").partition(LINE)[0]
    assert follow(tmp_path, source) == follow(tmp_path, source)


ENTRY = """\
import rclpy
from p.other import TOPIC
from .names import OTHER
from std_msgs.msg import String


def main(args=None):
    rclpy.init(args=args)
    node = rclpy.create_node('entered')
    node.create_publisher(String, TOPIC, 1)
    node.create_publisher(String, OTHER, 1)
    rclpy.spin(node)


class App:
    @staticmethod
    def run():
        rclpy.create_node('application')


if __name__ == '__main__':
    rclpy.create_node('script')
"""


@pytest.mark.parametrize("setup", ["setup(packages=['p'])", "setup(packages=find_packages(exclude=['test']))"])
def test_an_entry_point_is_called_and_its_package_is_found(tmp_path: Path, setup: str) -> None:
    files = {
        "package.xml": MANIFEST,
        "setup.py": setup,
        "p/__init__.py": "",
        "p/other.py": "TOPIC = 'there'\n",
        "p/names.py": "OTHER = 'here'\n",
    }
    write(tmp_path, files)
    found = follow(tmp_path, ENTRY, "p.entry:main", "p/entry.py")
    assert [each.name for each in found.facts] == ["there", "here"]
    assert [each.name for each in found.nodes] == ["entered"]
    assert not found.doubts
    assert [each.name for each in follow(tmp_path, ENTRY, "p.entry:App.run", "p/entry.py").nodes] == ["application"]


def test_modules_that_cmake_installs(tmp_path: Path) -> None:
    write(
        tmp_path,
        {"CMakeLists.txt": "ament_python_install_package(${PROJECT_NAME} PACKAGE_DIR python/p)", "python/p/__init__.py": "T = 'far'\n"},
    )
    source = "import rclpy, p\nfrom std_msgs.msg import String\nrclpy.create_node('n').create_publisher(String, p.T, 1)\n"
    assert [each.name for each in follow(tmp_path, source, path="scripts/node.py").facts] == ["far"]


def test_modules_below_directories_without_an_init_file(tmp_path: Path) -> None:
    files = {"package.xml": MANIFEST, "setup.py": "setup(packages=['p'])", "p/__init__.py": "", "p/parts/deep/names.py": "T = 'deep'\n"}
    write(tmp_path, {**files, "p/data/photo/list.txt": ""})
    source = (
        "import rclpy\nfrom std_msgs.msg import String\nfrom .parts.deep.names import T\nfrom .data.photo import other\n"
        "def main():\n    node = rclpy.create_node('n')\n    node.create_publisher(String, T, 1)\n    other.made(node)\n"
    )
    found = follow(tmp_path, source, "p.entry:main", "p/entry.py")
    assert [each.name for each in found.facts] == ["deep"]
    # A directory in which no module is, however deep, is no package.
    assert any("p.data.photo" in each.reason for each in found.doubts)


def test_an_entry_point_that_is_not_there(tmp_path: Path) -> None:
    found = follow(tmp_path, ENTRY, "p.entry:missing", "p/entry.py")
    assert "its entry point missing was not found" in {each.reason for each in found.doubts}


def test_modules_beside_an_entry_point_are_not_its_own(tmp_path: Path) -> None:
    write(tmp_path, {"p/serial.py": "import rclpy\nrclpy.create_node('wrong')\n"})
    source = "import rclpy, serial\ndef main():\n    rclpy.create_node('right')\n    serial.Serial('port')\n"
    assert [each.name for each in follow(tmp_path, source, "p.entry:main", "p/entry.py").nodes] == ["right"]


def test_an_entry_point_that_ends_the_program(tmp_path: Path) -> None:
    source = (
        "import sys, rclpy\nfrom std_msgs.msg import String\ndef main():\n    rclpy.init()\n    node = rclpy.create_node('n')\n"
        "    node.create_timer(1, lambda: node.create_publisher(String, 'later', 1))\n    sys.exit(rclpy.spin(node))\n"
    )
    assert [each.name for each in follow(tmp_path, source, "p.entry:main", "p/entry.py").facts] == ["later"]


DESCRIBED = """\
controller:
  base_frame: {type: string, default_value: base_link, description: "the frame", read_only: true}
  gains:
    p: {type: double, default_value: 1.0, validation: {bounds<>: [0.0, 5.0]}}
"""


def test_params_of_a_generated_module(tmp_path: Path) -> None:
    write(tmp_path, {"package.xml": MANIFEST, "setup.py": "generate_parameter_module('made', 'p/params.yaml')", "p/params.yaml": DESCRIBED})
    source = (
        "import rclpy\nfrom p.made import controller\nfrom std_msgs.msg import String\n\nrclpy.init()\nnode = rclpy.create_node('n')\n"
        "params = controller.ParamListener(node).get_params()\nnode.create_publisher(String, params.base_frame + '/state', 1)\n"
    )
    assert shown(follow(tmp_path, source)) == (
        "node n @6\n"
        "params ~base_frame default='base_link' value_type=string declared=True (description=the frame read_only=True) @7\n"
        "params ~gains.p default=1.0 value_type=double declared=True (minimum=0.0 maximum=5.0) @7\n"
        "publishers {param:~base_frame|base_link}/state std_msgs/msg/String"
        " (reliability=reliable durability=volatile history=keep_last depth=1) @8\n"
    )
    missing = follow(tmp_path, source.replace("controller", "other"))
    assert {each.reason for each in missing.doubts} == {"it declares the params of p.made.other, whose description was not found"}


LATER = "class A{n}(Node):\n def __init__(self):\n  super().__init__('n')\n  self.create_timer(1, self.t)\n def t(self):\n  A{m}()\n"
HEAD = "import rclpy\nfrom rclpy.node import Node\nfrom rclpy.qos import QoSProfile\nfrom rcl_interfaces.msg import *\n"


@pytest.mark.parametrize(
    "source",
    [
        pytest.param("".join(f"rclpy.create_node('n{each}')\n" for each in range(3_000)), id="many nodes"),
        pytest.param(
            "n = rclpy.create_node('n')\n" + "".join(f"n.declare_parameter('p{each}', 1)\n" for each in range(4_000)), id="many params"
        ),
        pytest.param(
            f"rclpy.create_node('n').declare_parameters('', [{', '.join('(str(1), 1)' for _ in range(4_000))}])\n", id="a long list"
        ),
        pytest.param(
            "q = QoSProfile(depth=1)\n" + "".join(f"if x:\n q.depth = {each}\n" for each in range(4_000)), id="a profile of branches"
        ),
        pytest.param(
            "d = ParameterDescriptor()\nd.integer_range = [d]\nrclpy.create_node('n').declare_parameter('x', d, d)\n", id="in itself"
        ),
        pytest.param("x = []\nx.append(x)\nrclpy.create_node(x, namespace=x).declare_parameters(x, x)\n", id="a list in itself"),
        pytest.param(
            "n = rclpy.create_node('n')\nn.create_publisher()\nn.create_subscription(n, n, n, n)\nn.get_parameter()\n", id="odd arguments"
        ),
        pytest.param(
            "append(1)\nfrom heapq import *\nadd = update = insert = print\nadd(1), update(2), insert(3)\n",
            id="functions called as methods",
        ),
        pytest.param("class A(Node):\n def __init__(self):\n  A()\n  super().__init__('n')\nA()\n", id="a node in itself"),
        pytest.param(
            "".join(LATER.replace("{n}", str(n)).replace("{m}", str(n + 1)) for n in range(1_000)) + "A0()\n",
            id="nodes that make nodes later",
        ),
    ],
)
def test_what_is_made_to_take_long_ends(tmp_path: Path, source: str) -> None:
    start = time.process_time()
    found = follow(tmp_path, HEAD + source)
    assert time.process_time() - start < 5
    assert len(found.nodes) <= 200


def test_more_nodes_than_are_followed_are_told(tmp_path: Path) -> None:
    found = follow(tmp_path, HEAD + "".join(f"rclpy.create_node('n{each}')\n" for each in range(201)))
    assert {each.reason for each in found.doubts} == {"it makes too many nodes to be followed"}
