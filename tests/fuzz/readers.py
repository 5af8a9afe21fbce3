"""Damaged inputs for everything that reads what stands in a repository: no exception but the announced ones, no hang, bounded memory.

``python -m tests.fuzz.readers [READER ...] [--count N] [--seed N] [--jobs N]``: ``N`` inputs for each reader (default: all), each made from
one that is well formed, and told by the reader's name and its number, so that it can be made again. Printed are, for each reader, the
inputs, how many it refused, and what went wrong: an exception that is not announced, more than two seconds of processor, or more than a
gibibyte of memory. Exit status 1 where anything did.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import resource
import shlex
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from random import Random
from typing import NamedTuple

from launchlint import baseline, suppression
from launchlint.dialects.door import evaluate
from launchlint.errors import LaunchlintError
from launchlint.evaluate.expression.compiled import compiled
from launchlint.evaluate.expression.errors import ExpressionError, UnknownValue
from launchlint.evaluate.ros2.typed import LAUNCH, TypeFault, convert
from launchlint.evaluate.session import Session
from launchlint.extract.cpp import cpp_program
from launchlint.extract.definitions import defined_names
from launchlint.extract.described_params import read as described_params
from launchlint.extract.python.modules import PackageModules
from launchlint.extract.python.program import python_program
from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.graph.urdf import joints
from launchlint.library.inspection import inspect
from launchlint.python.source import SourceError
from launchlint.rcl import arguments, parameter_files
from launchlint.source import Place, Source, Span
from launchlint.syntax.parse import parse
from launchlint.syntax.remarks import remarks
from launchlint.syntax.ros1.substitutions import parse as parse_substitutions
from launchlint.syntax.ros2 import substitutions
from launchlint.syntax.ros2.tables import distribution
from launchlint.syntax.ros2.written import Written
from launchlint.workspace import configuration
from launchlint.workspace.ament.scripts import read_setup_cfg
from launchlint.workspace.ament.setup_py import read_setup
from launchlint.workspace.cmake_facts import read_cmake
from launchlint.workspace.manifest import identify, parse_manifest
from launchlint.workspace.nodelets import plugin_classes
from launchlint.workspace.packages import Packages
from launchlint.workspace.text_parts import PARTS
from launchlint.yaml import values
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond
from tests.fuzz.mutation import mutated

ROOT = Path(__file__).parents[2]
SECONDS = 2.0
MOST_KILOBYTES = 1 << 20
AT_ONCE = 500
REFUSALS = (LaunchlintError, SourceError, YamlError, YamlBeyond, ExpressionError, UnknownValue, TypeFault)
PARAMETER_FILE = "/**:\n  ros__parameters: {a: 2, c: [x, y]}\n"
VARIABLES = {"HOME": "/home/user", "USER": "user"}


class Reader(NamedTuple):
    """``read`` reads an input that lies at a path, under ``name``; ``files`` are patterns of well-formed ones, ``texts`` further ones."""

    read: Callable[[bytes, Path], object]
    files: tuple[str, ...] = ()
    texts: tuple[str, ...] = ()
    name: str = "a.txt"


def _text(data: bytes) -> str:
    return data.decode("utf-8", "replace")


def _session(path: Path) -> Session:
    return Session(Packages([str(path.parent)], VARIABLES, explicit=True), VARIABLES, str(path.parent))


def _ros1(data: bytes, path: Path) -> None:
    document = parse(data, path.name)
    suppression.read(document.source, remarks(document))


def _evaluated(data: bytes, path: Path) -> None:
    evaluate(_session(path).with_text(str(path), data), str(path))


def _formatted(data: bytes, path: Path) -> None:
    once = formatted(data, path.name, Style())
    if once.problem is None and not once.refusal:
        assert formatted(once.data, path.name, Style()).data == once.data, "what is formatted is formatted again"


def _substitutions1(data: bytes, path: Path) -> None:
    text = _text(data)
    parts = parse_substitutions(text)
    assert parts.text == text


def _substitutions2(data: bytes, path: Path) -> None:
    text = _text(data)
    substitutions.parse(Written(text, Place(Source("value", text), Span(0, len(text)))), distribution("jazzy"), [])


def _typed(data: bytes, path: Path) -> None:
    convert(_text(data), None)


def _arguments(data: bytes, path: Path) -> None:
    try:
        words = shlex.split(_text(data))
    except ValueError:
        return
    arguments.parse(words, lambda name, table: parameter_files.add(Source(name, PARAMETER_FILE), table))


def _manifest(data: bytes, path: Path) -> None:
    identify(data)
    with suppress(ValueError):  # it says that it raises that
        parse_manifest(data, str(path))


def _cmake(data: bytes, path: Path) -> None:
    for ament in (False, True):
        read_cmake(str(path.parent), lambda: ["CMakeLists.txt", "src/a.cpp", "launch/a.launch"], ament=ament)
    defined_names(_text(data))


def _setup(data: bytes, path: Path) -> None:
    read_setup(str(path.parent))


def _parts(data: bytes, path: Path) -> None:
    text = _text(data)
    for part in PARTS.values():
        part(text)


def _cpp(data: bytes, path: Path) -> None:
    cpp_program([str(path)], [], str(path.parent), None)


def _python(data: bytes, path: Path) -> None:
    python_program(str(path), str(path.parent), str(path.parent), PackageModules({str(path.parent): "p"}))


FIXTURES = "tests/rules/fixtures/*/*"
LAUNCH_FILES = (f"{FIXTURES}/**/*.launch", "examples/turtles/*/launch/*.launch", "tests/graph/live_ws/talk/launch/*.launch")
LAUNCH_FILES2 = (f"{FIXTURES}/**/*.launch.xml", "tests/conformance/ros2/originals/**/*.launch.xml")
IN_YAML = (f"{FIXTURES}/**/*.launch.yaml", "tests/conformance/ros2/originals/**/*.launch.yaml")
IN_PYTHON = (f"{FIXTURES}/**/*.launch.py", "examples/ferry/*/launch/*.py")
PARAMETERS = (f"{FIXTURES}/**/*.yaml", "tests/conformance/ros2/originals/**/*.yaml")
EXPRESSIONS = (
    "1 + arg('a')", "'%s' % env('HOME')", "[a for a in 'b'] if not x else {1: (2,)}", "str(2 ** 3)[1:] in 'x'", "not true and 0x1F",
    "max(1, 2.0) - len('abc') // 2", "'a'.upper() == \"A\" or lambda: 1",
)  # fmt: skip
SUBSTITUTIONS = (
    "$(find a)/b $(arg c)", "$(eval 1 + 1)", "$(env HOME)$(optenv A b c)", "x $(anon a) $(dirname) $arg",
    "$(find-pkg-share a)/$(var 'b c')", "$(eval '$(var a) == \\'b\\'')", "$(if $(var a) b c)", "$(command 'ls -l' warn)",
)  # fmt: skip
COMMAND_LINES = (
    "--ros-args -r a:=b -r node:__ns:=/c --params-file x.yaml -p a.b:='[1, 2]' --", "a b --ros-args -r __node:=x -r rosservice://a:=b",
    "--ros-args -e /enclave --log-level n:=debug --disable-rosout-logs -r **/a/*:=/\\2/\\1",
)  # fmt: skip
ORIGINALS = "tests/fuzz/originals"

READERS: dict[str, Reader] = {
    "ros1": Reader(_ros1, LAUNCH_FILES, name="a.launch"),
    "ros1-evaluated": Reader(_evaluated, LAUNCH_FILES, name="a.launch"),
    "ros1-formatted": Reader(_formatted, LAUNCH_FILES, name="a.launch"),
    "ros2-xml": Reader(_evaluated, LAUNCH_FILES2, name="a.launch.xml"),
    "ros2-yaml": Reader(_evaluated, IN_YAML, name="a.launch.yaml"),
    "ros2-python": Reader(_evaluated, IN_PYTHON, name="a.launch.py"),
    "ros2-yaml-formatted": Reader(_formatted, IN_YAML, name="a.launch.yaml"),
    "substitutions-ros1": Reader(_substitutions1, texts=SUBSTITUTIONS),
    "substitutions-ros2": Reader(_substitutions2, texts=SUBSTITUTIONS),
    "expressions": Reader(lambda data, path: compiled(_text(data)), texts=EXPRESSIONS),
    "yaml-values": Reader(lambda data, path: values.load(_text(data), LAUNCH), PARAMETERS),
    "typed-values": Reader(_typed, texts=("[1, 2.5, a]", "{a: 1}", "0x1F", "'1'", "2024-01-01", "[true, no]", "1_000")),
    "rcl-parameter-files": Reader(lambda data, path: parameter_files.read(Source("a.yaml", _text(data))), PARAMETERS),
    "rcl-arguments": Reader(_arguments, texts=COMMAND_LINES),
    "manifests": Reader(_manifest, ("examples/*/*/package.xml", "tests/**/package.xml"), name="package.xml"),
    "cmake": Reader(_cmake, ("examples/*/*/CMakeLists.txt", "tests/**/CMakeLists.txt"), name="CMakeLists.txt"),
    "setup.py": Reader(_setup, ("examples/*/*/setup.py", f"{ORIGINALS}/setup.txt"), name="setup.py"),
    "setup.cfg": Reader(lambda data, path: read_setup_cfg(str(path)), (f"{ORIGINALS}/setup.cfg",), name="setup.cfg"),
    "plugins": Reader(lambda data, path: plugin_classes(str(path)), (f"{ORIGINALS}/plugins_*.xml",), name="plugins.xml"),
    "urdf": Reader(lambda data, path: joints(_text(data)), (f"{ORIGINALS}/*.urdf", "tests/graph/live_ws/talk/launch/robot.urdf")),
    "text-parts": Reader(_parts, (*IN_PYTHON, *LAUNCH_FILES, "examples/*/README.md")),
    "configuration": Reader(lambda data, path: configuration.load(str(path)), (f"{ORIGINALS}/launchlint.yaml",), name=".launchlint.yaml"),
    "baseline": Reader(lambda data, path: baseline.load(str(path)), ("tests/snapshots/baseline.json",), name="baseline.json"),
    "library": Reader(lambda data, path: inspect(data, path.name), ("launchlint/library/bundled/*_tutorials.json",), name="a.json"),
    "described-params": Reader(lambda data, path: described_params(str(path)), (f"{ORIGINALS}/described.yaml",), name="a.yaml"),
    "c++": Reader(_cpp, (f"{ORIGINALS}/r*cpp.cpp.txt",), name="a.cpp"),
    "python": Reader(_python, (f"{ORIGINALS}/r*py.txt",), name="a.py"),
}


def originals(reader: Reader) -> list[bytes]:
    """What the inputs of a reader are made from, always the same."""
    found = [path.read_bytes() for pattern in reader.files for path in sorted(ROOT.glob(pattern))]
    return [data for data in (*found, *(text.encode() for text in reader.texts)) if 0 < len(data) < 4000]


class Part(NamedTuple):
    """What came of some inputs: how many were refused, the slowest in seconds of processor, the memory in KiB, and what went wrong."""

    name: str
    done: int
    refused: int
    slowest: float
    memory: int
    wrong: tuple[str, ...]


def part(task: tuple[str, int, int]) -> Part:
    """Read the inputs of one reader from a number on."""
    name, first, count = task
    reader = READERS[name]
    made_from = originals(reader)
    refused, slowest = 0, 0.0
    wrong: list[str] = []
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as directory:
        path = Path(directory).resolve() / reader.name
        for number in range(first, first + count):
            data = mutated(Random(f"{name} {number}"), made_from)
            path.write_bytes(data)
            begin = time.process_time()
            try:
                reader.read(data, path)
            except REFUSALS:
                refused += 1
            except Exception:
                wrong.append(f"{name} {number}: {traceback.format_exc(limit=-3)}")
            seconds = time.process_time() - begin
            slowest = max(slowest, seconds)
            if seconds > SECONDS:
                wrong.append(f"{name} {number}: {seconds:.1f} s")
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    if memory > MOST_KILOBYTES:
        wrong.append(f"{name} {first}–{first + count - 1}: {memory} KiB")
    return Part(name, count, refused, slowest, memory, tuple(wrong))


def tasks(names: list[str], seed: int, count: int) -> Iterator[tuple[str, int, int]]:
    """All readers in turn, some inputs at a time."""
    for first in range(seed, seed + count, AT_ONCE):
        for name in names:
            yield name, first, min(AT_ONCE, seed + count - first)


def main() -> int:
    """See the module."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("reader", nargs="*", choices=[*READERS, []], default=[])
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    names = options.reader or list(READERS)
    done: Counter[str] = Counter()
    refused: Counter[str] = Counter()
    slowest = dict.fromkeys(names, 0.0)
    memory, wrong = 0, 0
    with multiprocessing.Pool(options.jobs, maxtasksperchild=200) as pool:
        for each in pool.imap_unordered(part, tasks(names, options.seed, options.count)):
            done[each.name] += each.done
            refused[each.name] += each.refused
            slowest[each.name] = max(slowest[each.name], each.slowest)
            memory = max(memory, each.memory)
            wrong += len(each.wrong)
            for line in each.wrong:
                print(line, flush=True)
    for name in names:
        print(f"{name:22} {done[name]:>9,} inputs, {refused[name]:>9,} refused, slowest {slowest[name]:.2f} s")
    print(f"{done.total():,} inputs, {wrong} wrong, at most {memory // 1024} MiB")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
