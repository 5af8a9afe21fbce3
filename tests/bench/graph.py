"""Do time and memory of the connection graph grow with the launch, and no faster? 50, 500 and 5,000 nodes, within one process.

``python -m tests.bench.graph [--runs N]``. The nodes are in nested namespaces, five in each: a driver, a filter, a manager and two
nodelets. All but managers use the hubs /tf or /diagnostics, some are remapped. Only ``connect`` is measured, not the evaluation before it.
"""

from __future__ import annotations

import argparse
import gc
import json
import sys
import tempfile
import time
import tracemalloc
from pathlib import Path
from statistics import median
from typing import Any

from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.graph.connect import connect
from launchlint.graph.connections import ConnectionGraph
from launchlint.library.file import open_library
from launchlint.library.lookup import Library
from launchlint.model import Launch
from launchlint.workspace.packages import Packages
from tests.bench.timing import milliseconds, table

SIZES = (50, 500, 5000)
TF, DIAGNOSTICS = {"name": "/tf", "type": "tf2_msgs/TFMessage"}, {"name": "/diagnostics", "type": "diagnostic_msgs/DiagnosticArray"}
IMAGE = {"name": "image", "type": "sensor_msgs/Image", "transport": "image"}
LOAD = {"name": "~load_nodelet", "type": "nodelet/NodeletLoad"}


def program(client: str, **interface: Any) -> dict[str, Any]:
    """An executable or nodelet with one variant."""
    return {"class": client, "variants": {"default": interface}}


PACKAGES = {
    "demo": {
        "executables": {
            "driver": program("roscpp", publishers=[IMAGE, {"name": "{arg:1}_info"}, TF, DIAGNOSTICS], services=[{"name": "~start"}]),
            "filter": program(
                "rospy", publishers=[TF, {"name": "{remap:image}/thin"}], subscribers=[IMAGE, TF], params=[{"name": "~rate"}]
            ),
        },
        "nodelets": {"demo/Rectify": program("nodelet", publishers=[{"name": "~flat"}, DIAGNOSTICS], subscribers=[IMAGE, TF])},
    },
    "nodelet": {
        "executables": {
            "nodelet": {
                "class": "roscpp",
                "variants": {
                    "manager": {"match": {"arg": 1, "is": "manager"}, "services": [LOAD]},
                    "default": {"clients": [{"name": "{arg:3}/load_nodelet"}]},
                },
            }
        }
    },
}
CELL = """
<group ns="n{number}">
  <remap from="image" to="raw"/>
  <node pkg="demo" type="driver" name="driver" args="camera"><remap from="/tf" to="/tf"/></node>
  <node pkg="demo" type="filter" name="filter"><param name="rate" value="5"/><remap from="raw/thin" to="~thin"/></node>
  <node pkg="nodelet" type="nodelet" name="manager" args="manager"/>
  <node pkg="nodelet" type="nodelet" name="left" args="load demo/Rectify manager"/>
  <node pkg="nodelet" type="nodelet" name="right" args="load demo/Rectify manager"><remap from="~flat" to="flat"/></node>
  {inner}
</group>
"""


def launch_of(directory: Path, size: int) -> Launch:
    """The evaluated launch with ``size`` nodes: chains of up to ten namespaces, each in the one before."""
    chains = []
    for start in range(0, size // 5, 10):
        inner = ""
        for number in reversed(range(start, min(start + 10, size // 5))):
            inner = CELL.format(number=number, inner=inner)
        chains.append(inner)
    file = directory / "main.launch"
    file.write_text(f"<launch>{''.join(chains)}</launch>", encoding="utf-8")
    return evaluate(Session(Packages([str(directory)], {}, explicit=True), {}, str(directory)), str(file), ()).launch


def measure(size: int, runs: int) -> tuple[ConnectionGraph, float, int]:
    """The graph of ``size`` nodes; median seconds to make it, and the bytes that it takes."""
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        (directory / "library.json").write_text(
            json.dumps({"format": "launchlint-library", "version": 1, "packages": PACKAGES}), encoding="utf-8"
        )
        library = Library([open_library(str(directory / "library.json"))], bundled=False)
        launch = launch_of(directory, size)
        connect(launch, library)
        seconds = []
        for _ in range(runs):
            started = time.perf_counter()
            connect(launch, library)
            seconds.append(time.perf_counter() - started)
        tracemalloc.start()
        graph = connect(launch, library)
        taken = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    return graph, median(seconds), taken


def main(arguments: list[str]) -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--runs", type=int, default=5, help="runs of each size (default: 5)")
    parser.add_argument("--without-collector", action="store_true", help="switch Python's garbage collector off")
    options = parser.parse_args(arguments)
    runs = options.runs
    if options.without_collector:
        gc.disable()
    rows = []
    costs = []
    for size in SIZES:
        graph, seconds, taken = measure(size, runs)
        nodes = len(graph.instances)
        costs.append((seconds / nodes, taken / nodes))
        endpoints = sum(len(instance.endpoints) for instance in graph.instances)
        cells = [milliseconds(seconds), f"{1e6 * seconds / nodes:.0f}", f"{taken / 2**20:.1f}", f"{taken / nodes / 1024:.1f}"]
        rows.append([str(nodes), str(endpoints), str(len(graph.channels)), *cells])
    print(table(["nodes", "endpoints", "channels", "ms", "µs per node", "MiB", "KiB per node"], rows))
    times, memories = zip(*costs, strict=True)
    time_ratio, memory_ratio = times[-1] / times[0], memories[-1] / memories[0]
    print(f"\ncost of a node in the largest launch over that in the smallest: time {time_ratio:.2f}, memory {memory_ratio:.2f}")
    print("How to read it: 1 is linear. Python's garbage collector makes large ones dearer; --without-collector leaves it out.")


if __name__ == "__main__":
    main(sys.argv[1:])
