"""What a launch file in Python does to the machine by merely being loaded: processes, files, questions, connections.

It is read off the text: what stands at the top of the file, in ``generate_launch_description`` and in what these call by name. Functions
that are only handed over (to an OpaqueFunction, to an event handler) run when launch executes the description, and do not count.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator

from launchlint.problem import Problem
from launchlint.python.walking import children, walk
from launchlint.source import Origin, Place
from launchlint.syntax.ros2.python.problems import RunsAtLoad

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.syntax.ros2.python.problems import Effect

    Routine: TypeAlias = "ast.FunctionDef | ast.AsyncFunctionDef"

_EFFECTS: dict[Effect, str] = {
    "process": """os.system os.popen os.execv os.execve os.execvp os.execl os.execlp os.spawnl os.spawnv os.fork os.kill subprocess.run
        subprocess.call subprocess.check_call subprocess.check_output subprocess.Popen subprocess.getoutput subprocess.getstatusoutput
        pexpect.spawn pexpect.run psutil.Popen""",
    "question": "input builtins.input raw_input getpass.getpass",
    "write": """os.makedirs os.mkdir os.rename os.replace os.symlink os.link os.chmod os.chown os.mkfifo shutil.copy shutil.copy2
        shutil.copyfile shutil.copytree shutil.move shutil.chown shutil.make_archive shutil.unpack_archive tempfile.NamedTemporaryFile
        tempfile.mkstemp tempfile.mkdtemp tempfile.TemporaryDirectory tempfile.TemporaryFile""",
    "delete": "os.remove os.unlink os.rmdir os.removedirs shutil.rmtree",
    "connection": """requests.get requests.post requests.put requests.head requests.request urllib.request.urlopen
        urllib.request.urlretrieve socket.socket socket.create_connection socket.gethostbyname paramiko.SSHClient rclpy.init
        rclpy.create_node serial.Serial""",
}
_BY_NAME = {name: effect for effect, names in _EFFECTS.items() for name in names.split()}
_METHODS: dict[str, Effect] = {"write_text": "write", "write_bytes": "write"}
_OF_PATHS: dict[str, Effect] = {"mkdir": "write", "touch": "write", "unlink": "delete", "rmdir": "delete", "symlink_to": "write"}
_ENTRY = "generate_launch_description"
_MOST_ROUTINES = 500


def runs_at_load(tree: ast.Module, place: Callable[[ast.AST], Place]) -> Iterator[Problem]:
    """What is done at load, in the order of the text."""
    names = _imported(tree)
    routines: dict[str, list[Routine]] = {}
    for node in walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            routines.setdefault(node.name, []).append(node)
        elif isinstance(node, ast.ClassDef):
            made = [each for each in node.body if isinstance(each, ast.FunctionDef) and each.name == "__init__"]
            routines.setdefault(node.name, []).extend(made)
    waiting: list[tuple[str, list[ast.stmt]]] = [("", tree.body)]
    waiting += [(_ENTRY, each.body) for each in routines.get(_ENTRY, ())]
    seen = {_ENTRY, *_OF_PATHS, *_METHODS}
    found: dict[tuple[int, int], Problem] = {}
    for _, body in waiting:  # grows on the way
        for call in _calls(body):
            name = _full(call.func, names)
            effect = _effect(call, name)
            if effect is not None:
                key = (call.lineno, call.col_offset)
                found[key] = RunsAtLoad(origin=Origin(place(call.func)), what=name, effect=effect)
            word = name.rpartition(".")[2]
            if word in routines and word not in seen and len(seen) < _MOST_ROUTINES:
                seen.add(word)
                waiting += [(word, each.body) for each in routines[word]]
    yield from (found[key] for key in sorted(found))


def _imported(tree: ast.Module) -> dict[str, str]:
    """Names that imports bring, with the full ones."""
    found: dict[str, str] = {}
    for node in walk(tree):
        if isinstance(node, ast.Import):
            found.update({alias.asname: alias.name for alias in node.names if alias.asname})
        elif isinstance(node, ast.ImportFrom) and not node.level:
            found.update({alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names})
    return found


def _calls(body: list[ast.stmt]) -> Iterator[ast.Call]:
    """The calls in statements, without those in functions and classes that are only defined there, and in what only a script does."""
    waiting: list[ast.AST] = list(reversed(body))
    while waiting:
        node = waiting.pop()
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)) or (isinstance(node, ast.If) and _is_script(node.test)):
            continue
        if isinstance(node, ast.Call):
            yield node
        waiting += reversed(children(node))


def _is_script(test: ast.expr) -> bool:
    return isinstance(test, ast.Compare) and isinstance(test.left, ast.Name) and test.left.id == "__name__"


def _full(function: ast.expr, names: dict[str, str]) -> str:
    """The full name of what is called; of a method of something that is made there, only its own, behind a dot."""
    words: list[str] = []
    while isinstance(function, ast.Attribute):
        words.append(function.attr)
        function = function.value
    if isinstance(function, ast.Name):
        words.append(names.get(function.id, function.id))
    else:
        words.append("")
    return ".".join(reversed(words))


def _effect(call: ast.Call, name: str) -> Effect | None:
    effect = _BY_NAME.get(name)
    if effect is not None:
        return effect
    word = name.rpartition(".")[2]
    if name in ("open", "io.open", "codecs.open") or (word == "open" and isinstance(call.func, ast.Attribute)):
        given = [*call.args[0 if name.startswith(".") or ("." in name and not name.startswith(("io.", "codecs."))) else 1 :]][:1]
        given += [each.value for each in call.keywords if each.arg == "mode"]
        modes = [each.value for each in given if isinstance(each, ast.Constant) and isinstance(each.value, str)]
        return "write" if any(len(mode) <= 4 and set(mode) & set("wax+") for mode in modes) else None
    if isinstance(call.func, ast.Attribute):
        if word in _METHODS:
            return _METHODS[word]
        # mkdir() and unlink() of whatever else is no matter; of a path that is made there it is.
        if word in _OF_PATHS and "Path(" in ast.unparse(call.func.value):
            return _OF_PATHS[word]
    return None
