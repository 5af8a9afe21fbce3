"""Does the time grow with the text that is evaluated, and no faster? Chains, trees and fans of includes of growing size.

``python -m tests.bench.linear [--runs N]``. A *chain* is a file that includes the next one, with two args handed on; a *tree* is a file
that includes the next one twice, in two namespaces, so that 2^depth copies of the last are evaluated; a *fan* is one file that includes
many different ones.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from statistics import median

from tests.bench.timing import launchlint, milliseconds, table, timed

BODY = """\
  <arg name="rate" default="10"/>
  <arg name="frame" default="map"/>
  <group ns="stage" if="$(eval arg('rate') > 0)">
    <node name="worker_{name}" pkg="demo_nodes" type="worker" output="screen">
      <param name="rate" value="$(arg rate)"/>
      <param name="frame" value="$(arg frame)_{name}"/>
      <remap from="in" to="out_{name}"/>
    </node>
  </group>
"""


def write(directory: Path, name: str, includes: list[str]) -> int:
    """Write one launch file; return its length in bytes."""
    text = "<launch>\n" + BODY.format(name=name) + "".join(includes) + "</launch>\n"
    (directory / f"{name}.launch").write_text(text, encoding="utf-8")
    return len(text)


def include(name: str, namespace: str) -> str:
    """An include of the file ``name`` in ``namespace`` with both args handed on."""
    return (
        f'  <include file="$(dirname)/{name}.launch" ns="{namespace}">\n'
        '    <arg name="rate" value="$(arg rate)"/>\n    <arg name="frame" value="$(arg frame)"/>\n  </include>\n'
    )


def chain(directory: Path, depth: int) -> int:
    """Write a chain; return the bytes that its evaluation reads."""
    return sum(write(directory, f"f{level}", [include(f"f{level + 1}", "n")] if level < depth else []) for level in range(depth + 1))


def tree(directory: Path, depth: int) -> int:
    """Write a tree; return the bytes that its evaluation reads, each file as often as it is entered."""
    total = 0
    for level in range(depth + 1):
        includes = [include(f"f{level + 1}", side) for side in ("left", "right")] if level < depth else []
        total += write(directory, f"f{level}", includes) * 2**level
    return total


def fan(directory: Path, width: int) -> int:
    """Write a fan; return the bytes that its evaluation reads."""
    leaves = [f"leaf{number}" for number in range(width)]
    return sum(write(directory, leaf, []) for leaf in leaves) + write(directory, "f0", [include(leaf, leaf) for leaf in leaves])


SHAPES = (("chain", chain, (10, 20, 40, 80)), ("tree", tree, (4, 6, 8, 10)), ("fan", fan, (32, 128, 512, 2048)))


def measure(write_shape: Callable[[Path, int], int], size: int, runs: int) -> tuple[int, float, int]:
    """Bytes evaluated, median seconds on the clock, and nodes found, for one shape of one size."""
    with tempfile.TemporaryDirectory() as directory:
        length = write_shape(Path(directory), size)
        command = launchlint("model", "--format", "json", str(Path(directory, "f0.launch")))
        results = [timed(command) for _ in range(runs)]
    if results[0].status:
        raise SystemExit(f"launchlint model ended with status {results[0].status}")
    model = json.loads(results[0].output)
    model = model[0] if isinstance(model, list) else model
    return length, median(result.seconds for result in results), len(model["nodes"])


def main() -> int:
    """Measure, print, and return the exit status."""
    parser = argparse.ArgumentParser(description="Time launchlint over launch files of growing size.")
    parser.add_argument("--runs", type=int, default=5, help="runs of each (default: 5)")
    runs: int = parser.parse_args().runs
    with tempfile.TemporaryDirectory() as directory:
        write(Path(directory), "f0", [])
        idle = median(timed(launchlint("model", "--format", "json", str(Path(directory, "f0.launch")))).seconds for _ in range(runs))
    rows = []
    for name, shape, sizes in SHAPES:
        for size in sizes:
            length, seconds, nodes = measure(shape, size, runs)
            work = max(seconds - idle, 0.0)
            rows.append(
                [
                    name,
                    str(size),
                    str(nodes),
                    f"{length / 1024:,.1f}",
                    milliseconds(seconds),
                    milliseconds(work),
                    f"{work * 1e6 / (length / 1024):,.0f}",
                ]
            )
    print(f"medians of {runs} runs; a file with one node takes {milliseconds(idle)} ms, start included\n")
    print(table(["shape", "size", "nodes", "KiB evaluated", "ms", "ms without start", "µs per KiB"], rows))
    print("\nHow to read it: within a shape, 'µs per KiB' must stay level while the size grows (small sizes are noise). If it doubles when")
    print("the size doubles, something is quadratic. It may fall: a file is parsed once, and an include entered with the same args is")
    print("evaluated once.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
