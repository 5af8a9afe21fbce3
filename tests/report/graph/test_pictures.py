"""Mermaid, DOT, GraphML and JSON of the connection graph: valid for their readers, whatever names are in them."""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import networkx
import pytest
from lxml import etree

from launchlint.graph.difference import difference
from launchlint.graph.multigraph import multigraph
from launchlint.graph.topology import Topology
from launchlint.report.graph import dot, graphml, mermaid
from launchlint.report.graph.json import as_object, difference_as_object, text
from tests.graph import tiny
from tests.report.graph import hostile

ROBOT = tiny.topology(
    "/cam/driver > /cam/image",
    "/cam/flip < /cam/image",
    "/planner > /cmd_vel?",
    "/wheels < /cmd_vel",
    "/planner calls /map",
    "/mapper serves /map",
    "/planner does /go",
    "/ui asks /go",
    nodes=[tiny.node("/mapper", knowledge="unknown"), tiny.node("/ui", conditions=('if="$(arg ui)"',))],
)
CHANGED = tiny.topology(
    "/cam/driver > /cam/image",
    "/cam/flip < /cam/image",
    "/planner > /cmd_vel=/cmd_vel_raw",
    "/wheels < /cmd_vel",
    "/planner calls /map",
    "/mapper serves /map",
    "/ui asks /go",
    nodes=[tiny.node("/mapper", "demo/better"), tiny.node("/ui")],
)


def changed_mermaid(_: Topology) -> str:
    before, after = hostile.changed()
    return mermaid.render(after, difference(before, after))


PICTURES: Mapping[str, Callable[[Topology], str]] = {
    "mermaid": mermaid.render,
    "mermaid, dangling": lambda topology: mermaid.render(topology, dangling=True),
    "mermaid, several": lambda topology: mermaid.render_all([mermaid.Picture(name, topology) for name in hostile.NAMES]),
    "mermaid, changed": changed_mermaid,
}


def test_mermaid() -> None:
    assert mermaid.render(ROBOT) == (
        "flowchart LR\n"
        '  subgraph n1 ["/cam"]\n'
        '    n2["driver<br/>demo/node"]\n'
        '    n3["flip<br/>demo/node"]\n'
        "  end\n"
        '  n4["mapper<br/>demo/node"]\n'
        '  n5["planner<br/>demo/node"]\n'
        '  n6["ui<br/>demo/node"]\n'
        '  n7["wheels<br/>demo/node"]\n'
        '  n2 -->|"/cam/image"| n3\n'
        '  n5 -.->|"/map"| n4\n'
        '  n5 -.->|"/cmd_vel"| n7\n'
        '  n6 ==>|"/go"| n5\n'
        "  classDef unknown stroke-dasharray: 2 3\n"
        "  classDef conditional stroke-dasharray: 6 4\n"
        "  class n4 unknown\n"
        "  class n6 conditional\n"
    )


def test_mermaid_of_a_change() -> None:
    assert mermaid.render(CHANGED, difference(ROBOT, CHANGED)) == (
        "flowchart LR\n"
        '  n1["mapper<br/>demo/better"]\n'
        '  n2["planner<br/>demo/node"]\n'
        '  n3["ui<br/>demo/node"]\n'
        '  n4["wheels<br/>demo/node"]\n'
        '  n5(["/cmd_vel_raw"])\n'
        '  n2 -.->|"/cmd_vel"| n4\n'
        "  n2 --> n5\n"
        '  n3 ==>|"/go"| n2\n'
        '  n6["2 nodes did not change and are not shown"]\n'
        "  linkStyle 0 stroke:#cf222e,stroke-width:3px,stroke-dasharray: 4 4\n"
        "  linkStyle 1 stroke:#1a7f37,stroke-width:3px\n"
        "  linkStyle 2 stroke:#cf222e,stroke-width:3px,stroke-dasharray: 4 4\n"
        "  classDef conditional stroke-dasharray: 6 4\n"
        "  classDef channel font-style:italic\n"
        "  classDef note stroke:none,fill:none\n"
        "  classDef added stroke:#1a7f37,stroke-width:3px\n"
        "  classDef changed stroke:#9a6700,stroke-width:3px\n"
        "  class n5 conditional\n"
        "  class n5 channel\n"
        "  class n6 note\n"
        "  class n5 added\n"
        "  class n1 changed\n"
    )


def test_dot() -> None:
    assert dot.render(ROBOT, title="robot.launch") == (
        "digraph connections {\n"
        "  rankdir=LR;\n"
        '  node [shape=box, fontname="sans-serif"];\n'
        '  edge [fontname="sans-serif"];\n'
        '  label="robot.launch";\n'
        '  subgraph cluster_n1 { label="/cam";\n'
        '    n2 [label="driver\\ndemo/node"];\n'
        '    n3 [label="flip\\ndemo/node"];\n'
        "  }\n"
        '  n4 [label="mapper\\ndemo/node", style="dotted"];\n'
        '  n5 [label="planner\\ndemo/node"];\n'
        '  n6 [label="ui\\ndemo/node", style="dashed"];\n'
        '  n7 [label="wheels\\ndemo/node"];\n'
        '  n2 -> n3 [label="/cam/image"];\n'
        '  n5 -> n4 [label="/map", style="dashed"];\n'
        '  n5 -> n7 [label="/cmd_vel", style="dashed"];\n'
        '  n6 -> n5 [label="/go", style="bold"];\n'
        "}\n"
    )


@pytest.mark.parametrize("picture", PICTURES)
def test_mermaid_holds_nothing_but_plain_labels(picture: str) -> None:
    out = PICTURES[picture](hostile.topology())
    assert len(out) <= mermaid.LONGEST
    name = r"n\d+"
    label = r'"(?:[A-Za-z0-9_\-/.,~ …→]|#\d+;|<br/>)*"'
    line = (
        rf"flowchart LR|\s*(?:end|subgraph {name} \[{label}\]|{name}(?:\[{label}\]|\[\[{label}\]\]|\(\[{label}\]\))"
        rf"|{name} (?:-->|-\.->|==>)(?:\|{label}\|)? {name}|linkStyle \d+ [a-z0-9:#,\- ]+"
        rf"|classDef \w+ [a-z0-9:#,\- ]+|class {name}(?:,{name})* \w+)"
    )
    assert [each for each in out.splitlines() if not re.fullmatch(line, each)] == []
    assert out.isprintable() or set(out) - {"\n"} == {each for each in out if each.isprintable()}


def test_mermaid_stays_within_the_limits_of_github_whatever_the_size() -> None:
    large = hostile.topology(40)
    started = time.process_time()
    for out in (mermaid.render(large), mermaid.render_all([mermaid.Picture("x", large)] * 30), mermaid.render(large, dangling=True)):
        assert len(out) <= 50_000
        assert sum("-->" in line or "-.->" in line or "==>" in line for line in out.splitlines()) <= 500
    assert time.process_time() - started < 20


@pytest.mark.mermaid
def test_mermaid_itself_reads_them(mermaid_directory: str, tmp_path: Path) -> None:
    """Parsed as GitHub does, and what it reads are our boxes and arrows, none of them with a link or a call."""
    large = hostile.topology(40)
    documents = {name: render(hostile.topology()) for name, render in PICTURES.items()}
    documents |= {
        "robot": mermaid.render(ROBOT),
        "change": mermaid.render(CHANGED, difference(ROBOT, CHANGED)),
        "large": mermaid.render(large),
    }
    documents |= {"nothing": mermaid.render(tiny.topology()), "nothing changed": mermaid.render(ROBOT, difference(ROBOT, ROBOT))}
    files = []
    for number, out in enumerate(documents.values()):
        files.append(tmp_path / f"{number}.mmd")
        files[-1].write_text(out, encoding="utf-8")
    script = Path(mermaid_directory) / "launchlint-parse.mjs"
    shutil.copy(Path(__file__).with_name("parse.mjs"), script)  # modules are looked for beside the script
    done = subprocess.run(
        ["node", str(script), *map(str, files)], capture_output=True, text=True, timeout=120, check=False, stdin=subprocess.DEVNULL
    )
    assert done.returncode == 0, done.stderr
    read = dict(zip(documents, map(json.loads, done.stdout.splitlines()), strict=True))
    for name, out in documents.items():
        lines = out.splitlines()
        arrows = sum(bool(re.match(r"\s+n\d+ (-->|-\.->|==>)", line)) for line in lines)
        boxes = sum(bool(re.match(r"\s+n\d+[\[(]", line)) for line in lines)
        groups = sum(line.lstrip().startswith("subgraph ") for line in lines)
        assert read[name] == {"boxes": boxes, "arrows": arrows, "groups": groups, "acting": 0, "foreign": 0}, name


@pytest.mark.graphviz
@pytest.mark.parametrize("topology", [ROBOT, hostile.topology()], ids=["robot", "hostile"])
def test_graphviz_itself_reads_dot(topology: Topology, dot_command: str) -> None:
    out = dot.render(topology, dangling=True, title=topology.entry)
    done = subprocess.run([dot_command, "-Tjson0"], input=out.encode(), capture_output=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    read = json.loads(done.stdout.decode())
    nodes = [each for each in read["objects"] if not each["name"].startswith("cluster")]
    assert len(nodes) == len(re.findall(r"^ +n\d+ \[", out, re.MULTILINE))
    assert len(read.get("edges", ())) == len(re.findall(r"^ +n\d+ -> n\d+", out, re.MULTILINE))


@pytest.mark.parametrize("topology", [ROBOT, hostile.topology()], ids=["robot", "hostile"])
def test_graphml_is_read_back_as_it_was(topology: Topology) -> None:
    out = graphml.render(topology)
    etree.fromstring(out.encode())
    read = networkx.read_graphml(io.BytesIO(out.encode()), force_multigraph=True)
    original = multigraph(topology)
    assert (read.number_of_nodes(), read.number_of_edges()) == (original.number_of_nodes(), original.number_of_edges())
    if topology is ROBOT:
        assert {(source, target, key) for source, target, key in read.edges(keys=True)} == {
            (" ".join(source), " ".join(target), key) for source, target, key in original.edges(keys=True)
        }
        assert read.nodes["node /mapper"]["knowledge"] == "unknown"
        assert sorted(data["certain"] for _, _, data in read.edges(data=True)) == [False, *[True] * 7]
    ids = re.findall(r'<(?:node|edge) id="([^"]*)"', out)
    assert len(set(ids)) == len(ids)


@pytest.mark.parametrize("topology", [ROBOT, hostile.topology()], ids=["robot", "hostile"])
def test_json_is_strict(topology: Topology) -> None:
    before, after = hostile.changed()
    for out in (text(as_object(topology)), text([difference_as_object(difference(before, after))])):
        assert out.isascii()
        assert "\\ud800" not in out.replace("\\\\ud800", "")

        def refuse(word: str) -> Any:
            raise AssertionError(word)

        json.loads(out, parse_constant=refuse)


def test_json_of_a_topology() -> None:
    read = json.loads(text(as_object(tiny.topology("/a > /x", "/b < /x?"))))
    assert list(read) == [
        "entry",
        "configurations",
        "complete",
        "verdict",
        "nodes",
        "channels",
        "connections",
        "params",
        "containers",
        "ports",
    ]
    assert [(each["node"], each["role"], each["name"], each["certain"]) for each in read["connections"]] == [
        ("/a", "publisher", "/x", True),
        ("/b", "subscriber", "/x", False),
    ]
    assert read["channels"] == [{"kind": "topic", "name": "/x", "types": [], "hub": False, "plumbing": False}]


def test_json_says_which_names_are_known_only_in_part() -> None:
    """They are no channels: nobody can say which topic such a name is."""
    topology = tiny.topology("/a > /x", "/b < /x")
    first = topology.nodes[0]
    topology = topology._replace(partly={(first.name, first.place): (("publishers", "/camera*/image"), ("subscribers", "*"))})
    read = json.loads(text(as_object(topology)))
    assert [each["partly"] for each in read["nodes"]] == [
        [{"category": "publishers", "name": "/camera*/image"}, {"category": "subscribers", "name": "*"}],
        [],
    ]
    assert [each["name"] for each in read["channels"]] == ["/x"]


def test_json_of_a_change() -> None:
    read = json.loads(text(difference_as_object(difference(ROBOT, CHANGED))))
    assert [(each["node"], each["name"], each["partners"], each["after"] and each["after"]["name"]) for each in read["lost"]] == [
        ("/planner", "/go", ["/ui"], None),
        ("/ui", "/go", ["/planner"], "/go"),
    ]
    assert [(each["before"]["program"], each["after"]["program"]) for each in read["nodes"]["changed"]] == [("demo/node", "demo/better")]


SAME = """
import hashlib, sys
from tests.report.graph import hostile
from launchlint.graph.difference import difference
from launchlint.report.graph import changes, dot, graphml, mermaid, text
from launchlint.report.graph.json import as_object, text as json_text
t = hostile.topology()
d = difference(*hostile.changed())
parts = [mermaid.render(t), mermaid.render(t, d), dot.render(t), graphml.render(t), json_text(as_object(t))]
parts += [text.render(t, t), changes.render([d])]
print([hashlib.sha256(each.encode("utf-8", "surrogatepass")).hexdigest() for each in parts])
"""


def test_the_same_bytes_for_any_hash_seed() -> None:
    root = Path(__file__).resolve().parents[3]
    found = set()
    for seed in ("0", "1", "4242"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(root)}
        found.add(
            subprocess.run([sys.executable, "-c", SAME], env=environment, capture_output=True, text=True, check=True, timeout=120).stdout
        )
    assert len(found) == 1
