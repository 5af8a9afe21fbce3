"""What reading sources costs, in lines a second and against a fixed yardstick; and how much memory it takes.

``python -m tests.bench.extraction_speed DIRECTORY... [--runs N]``. Each directory is read by ``launchlint extract`` in one process, by
turns with the yardstick: parsing each of its C++ and Python files once, and nothing else. Seconds are of the processor. Lines are those of
all sources and headers of the directory, many of which no program needs.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path
from statistics import median

from tests.bench.timing import launchlint

CPP = (".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".hh", ".hxx")
LARGEST = 1 << 20
YARDSTICK = """
import ast, sys, warnings
import tree_sitter, tree_sitter_cpp
parser = tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language()))
warnings.simplefilter("ignore")
for path in sys.stdin.read().splitlines():
    data = open(path, "rb").read()
    if path.endswith(".py"):
        try:
            ast.parse(data)
        except (SyntaxError, ValueError):
            pass
    else:
        parser.parse(data)
"""


def sources(directory: Path) -> list[Path]:
    """The C++ and Python files of a directory that are small enough to be read."""
    found = (path for path in sorted(directory.rglob("*")) if path.suffix in (*CPP, ".py") and path.is_file())
    return [path for path in found if path.stat().st_size <= LARGEST]


def cost(command: list[str], given: str = "") -> tuple[float, int]:
    """Processor seconds of a command with its children, and its peak memory in MiB."""
    with tempfile.TemporaryFile("w+") as entered, open(os.devnull, "w", encoding="utf-8") as nowhere:
        entered.write(given)
        entered.seek(0)
        child = os.posix_spawn(
            command[0],
            command,
            os.environ,
            file_actions=[
                (os.POSIX_SPAWN_DUP2, entered.fileno(), 0),
                (os.POSIX_SPAWN_DUP2, nowhere.fileno(), 1),
                (os.POSIX_SPAWN_DUP2, nowhere.fileno(), 2),
            ],
        )
        _, _, used = os.wait4(child, 0)
    return used.ru_utime + used.ru_stime, used.ru_maxrss >> 10


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directories", type=Path, nargs="+")
    parser.add_argument("--runs", type=int, default=3)
    given = parser.parse_args()
    all_lines, all_seconds = 0, 0.0
    print(f"{'':44} {'lines':>9} {'seconds':>8} {'lines/s':>8} {'x parsing':>9} {'MiB':>5}")
    for directory in given.directories:
        files = sources(directory)
        lines = sum(path.read_bytes().count(b"\n") for path in files)
        listed = "\n".join(map(str, files))
        with tempfile.TemporaryDirectory() as made:
            command = launchlint("extract", "-q", "--jobs", "1", str(directory), "-o", os.path.join(made, "library.json"))
            turns = [(cost(command), cost([sys.executable, "-c", YARDSTICK], listed)) for _ in range(given.runs)]
        seconds = median(read for (read, _), _ in turns)
        ratio = median(read / parsed for (read, _), (parsed, _) in turns)
        memory = max(peak for (_, peak), _ in turns)
        print(f"{directory.name:44} {lines:9,} {seconds:8.2f} {lines / seconds:8,.0f} {ratio:9.1f} {memory:5}")
        all_lines, all_seconds = all_lines + lines, all_seconds + seconds
    print(f"{'total':44} {all_lines:9,} {all_seconds:8.2f} {all_lines / all_seconds:8,.0f}")


if __name__ == "__main__":
    main()
