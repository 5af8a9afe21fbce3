"""Launch files of ROS 2 that are programs: nothing of them is executed, imported or compiled to code that could run, whatever they hold.

Each would leave a mark if any of it ran. Once Python itself tells what launchlint does (audit events), once the kernel (strace).
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from launchlint.dialects.door import configurations
from launchlint.evaluate.ros2.launch import DEEPEST_STACK
from launchlint.evaluate.session import Session
from launchlint.workspace.packages import Packages
from tests.cli.running import clean_environment, write

PACKAGE = (
    '<package format="3"><name>demo</name><version>1.0.0</version><description>A demo.</description>'
    '<maintainer email="a@b.org">A</maintainer><license>BSD</license><export><build_type>ament_python</build_type></export></package>\n'
)
HEAD = """import os, sys, subprocess, shutil, socket, importlib, pathlib, builtins, tempfile
from launch import LaunchDescription
from launch.actions import OpaqueFunction, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node
"""
RUNS = {
    "write": "open('{mark}', 'w').write('x')",
    "append": "with open('{mark}', 'a') as stream: stream.write('x')",
    "pathlib": "pathlib.Path('{mark}').write_text('x'); pathlib.Path('{mark}').touch()",
    "mkdir": "os.makedirs('{mark}')",
    "delete": "shutil.rmtree('{victim}'); os.remove('{victim}/file')",
    "system": "os.system('touch {mark}')",
    "run": "subprocess.run(['touch', '{mark}']); subprocess.Popen('touch {mark}', shell=True)",
    "exec": "exec(\"open('{mark}', 'w')\"); eval(\"open('{mark}', 'w')\"); eval(compile(\"open('{mark}', 'w')\", 'x', 'eval'))",
    "import": "import marking; importlib.import_module('marking'); __import__('marking'); from demo.marking import mark",
    "temporary": "tempfile.mkstemp(dir='{victim}')",
    "connect": "socket.create_connection(('127.0.0.1', 9))",
    "environment": "os.environ['PATH'] = '/nowhere'; os.putenv('PATH', '/nowhere'); os.chdir('/')",
    "exit": "sys.exit(3); os._exit(3); quit()",
    "metaclass": "class Meta(type):\n        def __new__(cls, *args): open('{mark}', 'w'); return type.__new__(cls, *args)\n"
                 "    class Marking(metaclass=Meta): pass",
    "decorator": "@(lambda function: open('{mark}', 'w'))\n    def marking(): pass",
    "sysmodule": "sys.path.insert(0, '{victim}'); sys.modules['os'].system('touch {mark}'); builtins.open('{mark}', 'w')",
}  # fmt: skip
"""What each of them does, as statements with ``{mark}``, a file that is not there, and ``{victim}``, a directory with a file."""

WATCHER = """
import json, os, sys
told = []
repository, report = sys.argv[1], sys.argv[2]
writing = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
plain = tuple('''os.system os.exec os.posix_spawn os.spawn os.fork os.forkpty subprocess.Popen os.mkdir os.rename os.remove os.rmdir os.link
    os.symlink os.truncate os.chmod os.chown os.putenv os.chdir shutil.rmtree os.kill tempfile.mkstemp tempfile.mkdtemp socket.connect
    socket.bind builtins.input pty.spawn ctypes.dlopen'''.split())
def watch(event, arguments):
    if event in plain:
        told.append([event, repr(arguments)[:200]])
    elif event == 'open' and isinstance(arguments[2], int) and arguments[2] & writing and arguments[0] != os.devnull:
        told.append([event, repr(arguments)[:200]])
    elif event == 'exec' and getattr(arguments[0], 'co_filename', '').startswith(repository):
        told.append([event, arguments[0].co_filename])
    elif event == 'compile' and arguments[1] is not None and os.fsdecode(arguments[1]).startswith(repository):
        told.append([event, repr(arguments)[:200]])
    elif event == 'import' and arguments[0] in ('marking', 'demo', 'demo.marking', 'launch', 'launch_ros'):
        told.append([event, arguments[0]])
os.chdir(repository)
from launchlint.cli import main
sys.addaudithook(watch)
status = 0
for words in json.loads(sys.argv[3]):
    try:
        main(words, standalone_mode=False)
    except SystemExit as ended:
        status = ended.code
seen = list(told)
with open(report, 'w') as stream:
    json.dump(seen, stream)
"""
CALLS = """execve execveat fork vfork clone clone3 open openat openat2 creat mkdir mkdirat unlink unlinkat rmdir rename renameat renameat2
    link linkat symlink symlinkat truncate chmod fchmodat connect bind kill"""
COMMANDS = [
    ["check", "--no-cache", "-v", "--select", "all", "--format", "concise", "."],
    ["check", "--no-cache", "--unsafe-fixes", "--diff", "."],
    ["model", "--format", "json", "launch/everything.launch.py"],
]


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A package with one launch file for each way, at the top, in the function and in an OpaqueFunction; and one with all of them."""
    directory = tmp_path / "repository"
    victim = directory / "victim"
    mark = tmp_path / "mark"
    ways = {name: text.replace("{mark}", str(mark)).replace("{victim}", str(victim)) for name, text in RUNS.items()}
    marking = f"mark = open({str(mark)!r}, 'w')\n"
    files = {
        ".git/HEAD": "",
        "package.xml": PACKAGE,
        "setup.py": marking + "from setuptools import setup\nsetup(name='demo')\n",
        "setup.cfg": "[install]\n",
        "demo/__init__.py": marking,
        "demo/marking.py": marking,
        "launch/marking.py": marking,
        "conftest.py": marking,
        "sitecustomize.py": marking,
        "victim/file": "",
    }
    for name, text in ways.items():
        end = "    return LaunchDescription([OpaqueFunction(function=later), Node(package='demo', executable='x')])\n"
        files[f"launch/{name}.launch.py"] = (
            f"{HEAD}if True:\n    {text}\n\n\ndef later(context):\n    {text}\n    return []\n\n\n"
            f"def generate_launch_description():\n    {text}\n{end}"
        )
    caught = "".join(f"try:\n    {text}\nexcept BaseException:\n    pass\n" for text in ways.values())
    files["launch/everything.launch.py"] = f"{HEAD}{caught}def generate_launch_description():\n    return LaunchDescription([])\n"
    files["launch/fixable.launch.py"] = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([LogInfo('hello')])\n"
    write(directory, files)
    return directory


def unmarked(repository: Path) -> bool:
    """Whether nothing has left a mark."""
    return not (repository.parent / "mark").exists() and [each.name for each in (repository / "victim").iterdir()] == ["file"]


def test_no_code_of_a_launch_file_runs(repository: Path, tmp_path: Path) -> None:
    report = tmp_path / "report.json"
    words = [sys.executable, "-B", "-c", WATCHER, str(repository), str(report), json.dumps(COMMANDS)]
    done = subprocess.run(words, env=clean_environment(tmp_path / "cache"), capture_output=True, timeout=120, check=False)
    assert (done.returncode, b"LL000" in done.stdout) == (0, False), done.stderr.decode()
    assert b"launch/everything.launch.py" in done.stdout
    assert b"LL930" in done.stdout
    assert json.loads(report.read_text(encoding="utf-8")) == []
    assert unmarked(repository)


def test_the_watcher_sees_what_it_is_there_for(repository: Path, tmp_path: Path) -> None:
    """The same watcher over what launch does with such a file."""
    report = tmp_path / "report.json"
    for name in ("write", "run", "import"):
        command = [f"import runpy; runpy.run_path({str(repository / f'launch/{name}.launch.py')!r})"]
        watcher = WATCHER.replace("from launchlint.cli import main", "def main(words, standalone_mode): exec(words[0])")
        watcher = watcher.replace("    except SystemExit as ended:\n        status = ended.code", "    except BaseException:\n        pass")
        words = [sys.executable, "-B", "-c", watcher, str(repository), str(report), json.dumps([command])]
        subprocess.run(words, env=clean_environment(tmp_path / "cache"), capture_output=True, timeout=60, check=True)
        events = {event for event, _ in json.loads(report.read_text(encoding="utf-8"))}
        assert "exec" in events


@pytest.mark.strace
def test_the_kernel_sees_no_process_and_no_writing(repository: Path, tmp_path: Path) -> None:
    for number, words in enumerate(COMMANDS):
        log = tmp_path / f"strace{number}.log"
        command = [
            "strace",
            "-f",
            "-qq",
            "-o",
            str(log),
            "-e",
            f"trace={','.join(CALLS.split())}",
            sys.executable,
            "-B",
            "-m",
            "launchlint",
            *words,
        ]
        environment = clean_environment(tmp_path / "cache")
        ran = subprocess.run(command, cwd=repository, env=environment, capture_output=True, timeout=300, check=False)
        assert b"launch/" in ran.stdout, ran.stderr.decode()
        lines = [line.partition(" ")[2].strip() for line in log.read_text(encoding="utf-8", errors="replace").splitlines()]
        done = [line for line in lines if re.match(r"\w+\(", line) and not re.search(r" = -1 E\w+", line)]
        assert sum(line.startswith("execve") for line in done) == 1
        others = [line for line in done if not line.startswith(("execve(", "open(", "openat(", "openat2("))]
        assert [line for line in others if not _is_thread(line)] == []
        opened = [line for line in done if line.startswith("open") and re.search(r"O_(?:WRONLY|RDWR|CREAT|TRUNC|APPEND)", line)]
        assert [line for line in opened if '"/dev/null"' not in line] == []
    assert unmarked(repository)


def _is_thread(line: str) -> bool:
    return line.startswith(("clone", "clone3")) and "CLONE_THREAD" in line


NAMES = st.sampled_from(["a", "b", "ld", "context", "args", "LaunchConfiguration", "Node", "os", "x"])
TEXTS = st.sampled_from(["''", "'a'", "'a/b.yaml'", "'true'", "f'{a}x{b!r:>5}'", "b'a'", "'%s' % a", "'{}'.format(b)"])
ATOMS = st.one_of(NAMES, TEXTS, st.sampled_from(["None", "True", "0", "-1", "2.5", "10 ** 9", "...", "1j", "[]", "{}", "()", "set()"]))


def _larger(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    pairs = st.tuples(inner, inner)
    return st.one_of(
        pairs.map(lambda two: f"({two[0]} + {two[1]})"),
        st.tuples(inner, st.sampled_from("+ - * / // % ** == < in and or is".split()), inner).map(lambda each: f"({' '.join(each)})"),
        st.lists(inner, max_size=3).map(lambda items: f"[{', '.join(items)}]"),
        st.lists(inner, max_size=3).map(lambda items: f"({''.join(f'{each}, ' for each in items)})"),
        st.lists(pairs, max_size=2).map(lambda items: f"{{{', '.join(f'{key}: {value}' for key, value in items)}}}"),
        pairs.map(lambda two: f"[{two[0]} for x in {two[1]} if x]"),
        pairs.map(lambda two: f"{{x: {two[0]} for x in {two[1]}}}"),
        st.tuples(inner, inner, inner).map(lambda three: f"({three[0]} if {three[1]} else {three[2]})"),
        inner.map(lambda each: f"(lambda *y, **z: {each})"),
        pairs.map(lambda two: f"{two[0]}[{two[1]}]"),
        inner.map(lambda each: f"{each}[1:]"),
        st.tuples(inner, st.sampled_from(["items()", "join(a)", "perform(context)", "append(b)", "split()", "x", "format(*a)"])).map(
            ".".join
        ),
        st.tuples(
            st.sampled_from(
                """str int len list dict tuple set sorted zip range enumerate map os.path.join os.environ.get LaunchConfiguration Node f
                PathJoinSubstitution IfCondition LaunchDescription DeclareLaunchArgument GroupAction OpaqueFunction TimerAction
                IncludeLaunchDescription PythonExpression""".split()
            ),
            st.lists(inner, max_size=2),
            st.lists(st.tuples(st.sampled_from(CALLED_WITH), inner), max_size=2, unique_by=lambda pair: pair[0]),
        ).map(lambda call: f"{call[0]}({', '.join([*call[1], *(f'{name}={value}' for name, value in call[2])])})"),
        inner.map(lambda each: f"Node(package='demo', executable='x', parameters=[{each}], arguments={each}, condition={each})"),
    )


CALLED_WITH = """package executable name namespace parameters remappings arguments condition actions period default_value choices function
    msg launch_arguments cmd output on_exit respawn foo""".split()
EXPRESSIONS = st.recursive(ATOMS, _larger, max_leaves=8)


def _statements(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    block = st.lists(inner, min_size=1, max_size=3).map("\n".join).map(lambda text: "\n".join(f"    {line}" for line in text.split("\n")))
    return st.one_of(
        st.tuples(EXPRESSIONS, block, block).map(lambda each: f"if {each[0]}:\n{each[1]}\nelse:\n{each[2]}"),
        st.tuples(EXPRESSIONS, block).map(lambda each: f"for x in {each[0]}:\n{each[1]}"),
        st.tuples(EXPRESSIONS, block).map(lambda each: f"while {each[0]}:\n{each[1]}\n    break"),
        st.tuples(block, block).map(lambda each: f"try:\n{each[0]}\nexcept Exception as error:\n{each[1]}\nfinally:\n    pass"),
        st.tuples(EXPRESSIONS, block).map(lambda each: f"with {each[0]} as x:\n{each[1]}"),
        block.map(lambda each: f"def f(a=None, *b, **context):\n{each}\n    return f"),
        block.map(lambda each: f"class f(Node):\n    y = 1\n    def __init__(self, a=1):\n        self.a = a\n{each}"),
        st.tuples(EXPRESSIONS, block).map(
            lambda each: f"match {each[0]}:\n    case [a, *b]:\n        pass\n    case _:\n        pass\n{each[1]}"[:900]
        ),
    )


SIMPLE = st.one_of(
    EXPRESSIONS,
    EXPRESSIONS.map(lambda each: f"a = {each}"),
    EXPRESSIONS.map(lambda each: f"a, *b = {each}"),
    EXPRESSIONS.map(lambda each: f"b += {each}"),
    EXPRESSIONS.map(lambda each: f"ld.add_action({each})"),
    EXPRESSIONS.map(lambda each: f"return {each}"),
    st.sampled_from(["pass", "del a", "global b", "raise ValueError(a)", "assert a, b", "import os as a", "f()", "x: int = 5", "yield a"]),
)
STATEMENTS = st.recursive(SIMPLE, _statements, max_leaves=6)


@pytest.fixture(scope="module")
def deep_stack() -> Iterator[None]:
    """The evaluation raises the limit of recursion; Hypothesis wants to know it before."""
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(max(limit, DEEPEST_STACK))
    yield
    sys.setrecursionlimit(limit)


@pytest.mark.usefixtures("deep_stack")
@given(body=st.lists(STATEMENTS, min_size=1, max_size=5), top=st.lists(STATEMENTS, max_size=2), returned=EXPRESSIONS)
@settings(max_examples=1500)
def test_any_program_is_followed_to_an_end(
    body: list[str], top: list[str], returned: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    directory = tmp_path_factory.getbasetemp() / "generated"
    if not directory.exists():
        write(directory, {"package.xml": PACKAGE, "a/b.yaml": "{}\n"})
    inner = "\n".join(f"    {line}" for statement in body for line in statement.split("\n"))
    above = "\n".join(each for each in top if "return" not in each and "yield" not in each)
    text = (
        f"{HEAD}from launch.actions import *\nfrom launch.conditions import *\nfrom launch.substitutions import *\n{above}\n"
        f"def generate_launch_description():\n    ld = LaunchDescription()\n    a = b = x = context = args = None\n{inner}\n"
        f"    return LaunchDescription([{returned}, OpaqueFunction(function=f)])\ndef f(*a, **b):\n    context = x = a\n"
        + "\n".join(line for line in inner.splitlines() if "global" not in line)
        + "\n"
    )
    file = str(directory / "x.launch.py")
    session = Session(Packages((str(directory),), {}, explicit=True), {}, str(directory), {file: text.encode()}, "jazzy")
    start = time.process_time()
    for evaluation in configurations(session, file):
        assert evaluation.launch.entry.path == "x.launch.py"
    assert time.process_time() - start < 20


def test_loops_that_some_way_may_leave_in_any_round(tmp_path: Path) -> None:
    """Each round has one way more out of it than the one before: beyond a few, the rest of the rounds is not known."""
    write(tmp_path, {"package.xml": PACKAGE})
    loop = "    for a{} in range(4000):\n        if os.path.exists(str(a{})):\n            break\n        values.append(a{})\n"
    loops = "".join(loop.replace("{}", str(number)) for number in range(4))
    made = "LaunchDescription([LogInfo(msg=str(len(values)))])"
    text = f"{HEAD}def generate_launch_description():\n    values = []\n{loops}    return {made}\n"
    file = str(tmp_path / "x.launch.py")
    session = Session(Packages((str(tmp_path),), {}, explicit=True), {}, str(tmp_path), {file: text.encode()}, "jazzy")
    start = time.process_time()
    assert [evaluation.launch.refused for evaluation in configurations(session, file)] == [None]
    assert time.process_time() - start < 20
