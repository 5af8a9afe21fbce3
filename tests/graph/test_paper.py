"""The case study of the paper, end to end.

Its launch files are in ``paper/``: the listings input.launch, output.launch, include.launch and nested.launch, as printed, and what
the text says of the nodes (``library.json``). Turtlesim is what launchlint knows itself.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from launchlint.check.entry import EntryChecker
from launchlint.check.graphs import graphs_of
from launchlint.check.options import EntryRequest, Options
from launchlint.graph.containment import Port, ports
from launchlint.graph.topology import Topology
from launchlint.graph.topology import topology as record
from launchlint.report.graph import mermaid, text
from tests.cli.running import run
from tests.graph import tiny

PAPER = Path(__file__).with_name("paper")


def topology(directory: Path, file: str) -> Topology:
    """What ``file`` of the paper connects."""
    environment = {"HOME": "/home/user", "PATH": "/usr/bin:/bin"}
    options = Options(frozenset(), (str(directory),), True, environment, str(directory), library=(str(PAPER / "library.json"),))
    at = str(directory / file)
    return record(graphs_of(EntryChecker(options), EntryRequest(at, at)))


def triples(of: Topology, kind: str = "topic") -> set[tuple[str, str, str]]:
    """Every publisher, topic and subscriber that meet."""
    return {(giver, name, taker) for giver, its_kind, name, taker in tiny.pairs(of) if its_kind == kind}


def held(of: Topology) -> dict[str, set[tuple[str, str, str]]]:
    """Namespace of each group → the triples that lie wholly in it; the empty one for those that lie in none."""
    around = {node.name: node.container for node in of.nodes}
    labels = {container.id: container.label for container in of.containers} | {"": ""}
    found: dict[str, set[tuple[str, str, str]]] = {}
    for triple in triples(of):
        first, second = around[triple[0]], around[triple[2]]
        assert first == second, f"{triple} crosses a border"
        found.setdefault(labels[first], set()).add(triple)
    return found


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    """A workspace with the files of the paper, nested.launch in the package that the listing names."""
    shutil.copytree(PAPER, tmp_path / "ws")
    package = tmp_path / "ws" / "pkg-name"
    package.mkdir()
    (package / "package.xml").write_text("<package><name>pkg-name</name><version>1.0.0</version></package>", encoding="utf-8")
    shutil.move(tmp_path / "ws" / "nested.launch", package / "nested.launch")
    return tmp_path / "ws"


def test_before_the_controllers_do_not_reach_their_turtles(directory: Path) -> None:
    """The square drives three turtles; circle and circle_radius drive none; line drives one of the two turtles that are called sim2."""
    assert triples(topology(directory, "input.launch")) == {
        ("/line", "/line_cmd_vel", "/sim2"),
        ("/square", "/turtle1/cmd_vel", "/sim1"),
        ("/square", "/turtle1/cmd_vel", "/sim2"),
        ("/square", "/turtle1/cmd_vel", "/sim4"),
        ("/sim1", "/turtle1/pose", "/square"),
        ("/sim2", "/turtle1/pose", "/square"),
        ("/sim4", "/turtle1/pose", "/square"),
    }


def test_before_findings_say_which_remap_and_which_namespace_are_missing(directory: Path) -> None:
    ran = run(directory, "check", "input.launch", "--library", "library.json", "--workspace", ".", "--select", "LL301,LL613,LL615")
    assert ran.status == 1
    firsts = [line.split(": ", 1)[1] for line in ran.output.splitlines() if line.startswith("input.launch:")]
    assert [line.split(" ")[1] for line in firsts] == ["LL613", "LL301", "LL615", "LL613"]
    helps = [line for line in ran.output.splitlines() if line.startswith("   = help: put <remap")]
    for line, (source, node, turtle) in zip(
        helps, (("cmd_vel", "circle", "sim1"), ("cmd_vel_radius", "circle_radius", "sim4")), strict=True
    ):
        assert f'put <remap from="{source}" to="turtle1/cmd_vel"/> into the <node> of /{node}' in line
        assert f'give it a <group ns="…"> of its own together with /{turtle}' in line


def test_after_the_four_pairs_are_connected_in_the_right_groups_and_nowhere_else(directory: Path) -> None:
    after = topology(directory, "output.launch")
    assert held(after) == {
        "": {
            ("/circle", "/turtle1/cmd_vel", "/sim1"),
            ("/line", "/line_cmd_vel", "/sim3"),
        },
        "/turtle2": {
            ("/turtle2/square", "/turtle2/turtle1/cmd_vel", "/turtle2/sim2"),
            ("/turtle2/sim2", "/turtle2/turtle1/pose", "/turtle2/square"),
        },
        "/turtle4": {
            ("/turtle4/circle_radius", "/turtle4/turtle1/cmd_vel", "/turtle4/sim4"),
        },
    }
    assert triples(after, "service") == {("/turtle2/sim2", "/turtle2/reset", "/turtle2/square")}


def test_after_nothing_is_said_of_the_connections(directory: Path) -> None:
    ran = run(
        directory, "check", "output.launch", "--library", "library.json", "--workspace", ".", "--select", "LL601,LL611,LL612,LL613,LL614"
    )
    assert (ran.status, ran.output) == (0, "no problems in 1 launch file\n")


def test_after_the_picture_has_the_groups_of_the_paper(directory: Path) -> None:
    assert mermaid.render(topology(directory, "output.launch")) == (
        "flowchart LR\n"
        '  subgraph n1 ["/turtle2"]\n'
        '    n7["sim2<br/>turtlesim/turtlesim_node"]\n'
        '    n8["square<br/>turtlesim/draw_square"]\n'
        "  end\n"
        '  subgraph n2 ["/turtle4"]\n'
        '    n9["circle_radius<br/>my_turtle_pkg/turtle_circle_radius"]\n'
        '    n10["sim4<br/>turtlesim/turtlesim_node"]\n'
        "  end\n"
        '  n3["circle<br/>my_turtle_pkg/turtle_circle"]\n'
        '  n4["line<br/>my_turtle_pkg/turtle_line"]\n'
        '  n5["sim1<br/>turtlesim/turtlesim_node"]\n'
        '  n6["sim3<br/>turtlesim/turtlesim_node"]\n'
        '  n3 -->|"/turtle1/cmd_vel"| n5\n'
        '  n4 -->|"/line_cmd_vel"| n6\n'
        '  n7 -->|"/turtle2/turtle1/pose"| n8\n'
        '  n8 -.->|"/turtle2/reset"| n7\n'
        '  n8 -->|"/turtle2/turtle1/cmd_vel"| n7\n'
        '  n9 -->|"/turtle4/turtle1/cmd_vel"| n10\n'
    )


def test_from_before_to_after(directory: Path) -> None:
    ran = run(directory, "graph", "diff", "input.launch", "output.launch", "--library", "library.json", "--kind", "topic")
    assert (ran.status, ran.errors) == (0, "")
    assert ran.output == (
        "input.launch → output.launch\n"
        "  loads now; before: refused by roslaunch\n"
        "  lost: /sim1 → /square on topic /turtle1/pose\n"
        "      /square is now /turtle2/square\n"
        "  gained: /circle → /sim1 on topic /turtle1/cmd_vel\n"
        "  ~ node /circle_radius is now /turtle4/circle_radius\n"
        "  ~ node /sim2 is now /turtle2/sim2\n"
        "  ~ node /sim4 is now /turtle4/sim4\n"
        "  ~ node /square is now /turtle2/square\n"
        "  + node /sim3 (turtlesim/turtlesim_node)\n"
        "      publishes /turtle1/color_sensor, /turtle1/pose\n"
        "      subscribes /line_cmd_vel\n"
        "  - topic /cmd_vel\n"
        "  ~ /circle publishes /turtle1/cmd_vel instead of /cmd_vel, remapped from /cmd_vel (output.launch:3)\n"
    )


def test_two_nodes_of_one_name_are_told_of_together(directory: Path) -> None:
    shown = text.render(topology(directory, "input.launch")).splitlines()
    at = shown.index("/sim2  turtlesim/turtlesim_node  input.launch:7")
    assert shown[at + 1] == "    has the same name as the one above, where stands what both say and hear"


def inside_out(of: Topology) -> tuple[str, tuple[Port, ...]]:
    """The file of the only include, and its ports."""
    (container,) = of.containers
    return container.label, ports(of)[container.id]


def test_the_include_as_it_is_printed(directory: Path) -> None:
    """Its remap stands behind the nodes, where roslaunch does not let it act on them: they meet on /msg, whatever the paper draws."""
    found = topology(directory, "include.launch")
    assert inside_out(found) == (
        "pkg-name/nested.launch",
        (
            Port("topic", "/msg", False, ("/listener",), inner=True, outer=False),
            Port("topic", "/msg", True, ("/talker",), inner=True, outer=False),
        ),
    )
    ran = run(directory, "check", "include.launch", "--library", "library.json", "--workspace", ".", "-v", "--format", "concise")
    rules = {line.split(" ")[2] for line in ran.output.splitlines() if "pkg-name/nested.launch:5:" in line}
    assert rules & {"LL602", "LL603", "LL604", "LL605", "LL606", "LL607"}, ran.output


def test_the_include_with_its_remap_before_the_nodes(directory: Path) -> None:
    """Seen from outside as ports: talker out, listener in, both on /chatter; and, what the paper could not, expanded inside."""
    nested = directory / "pkg-name" / "nested.launch"
    lines = nested.read_text(encoding="utf-8").splitlines()
    nested.write_text("\n".join([lines[0], lines[4], *lines[1:4], lines[5]]), encoding="utf-8")
    found = topology(directory, "include.launch")
    assert inside_out(found) == (
        "pkg-name/nested.launch",
        (
            Port("topic", "/chatter", False, ("/listener",), inner=True, outer=False),
            Port("topic", "/chatter", True, ("/talker",), inner=True, outer=False),
        ),
    )
    assert triples(found) == {("/talker", "/chatter", "/listener")}
    assert {
        (each.node, each.declared, each.name, tuple((step.source, step.target, step.place) for step in each.remaps))
        for each in found.connections
    } == {
        ("/listener", "/msg", "/chatter", (("/msg", "/chatter", "pkg-name/nested.launch:2:5"),)),
        ("/talker", "/msg", "/chatter", (("/msg", "/chatter", "pkg-name/nested.launch:2:5"),)),
    }
