"""Params of dynamic_reconfigure, from the .cfg file of a configuration: Python that is parsed and never run."""

from __future__ import annotations

import ast
import os
from functools import lru_cache

from launchlint.extract.cpp.naming import template
from launchlint.extract.cpp.values import Handle, Value, choices
from launchlint.named_tuple import NamedTuple
from launchlint.workspace import looking

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.extract.cpp.calls import Call

_TYPES = {"str_t": "str", "int_t": "int", "double_t": "double", "bool_t": "bool"}
_WITHOUT: dict[str, Any] = {"str": "", "int": 0, "double": 0.0, "bool": False}
_MOST_PARAMS = 500
_MOST_FILES = 200
_MOST_NODES = 50_000
_DEEPEST = 60


class Setting(NamedTuple):
    """One param of a configuration."""

    name: str
    type: str
    default: Any
    line: int


class Settings(NamedTuple):
    """What a .cfg file says; ``reason`` says why it may not be all."""

    name: str
    settings: tuple[Setting, ...]
    reason: str


def read_settings(path: str) -> Settings:
    """The params that a .cfg file declares; the file is never run. Never raises."""
    try:
        return _settings(looking.read_bytes(path).decode("utf-8", "replace"))
    except OSError as error:
        return Settings("", (), f"cannot be read: {error.strerror or error}")


@lru_cache(maxsize=256)
def _settings(text: str) -> Settings:
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        return Settings("", (), f"is no Python that can be parsed: {type(error).__name__}")
    reader = _Reader()
    for position, node in enumerate(ast.walk(tree)):
        if position > _MOST_NODES:
            return Settings("", (), "is too long")
        reader.see(node)
    reason = "makes params in a way that is not followed" if reader.unclear else ""
    return Settings(reader.name, tuple(sorted(reader.settings, key=lambda each: each.line)), reason)


class _Reader:
    def __init__(self) -> None:
        self.values: dict[str, Any] = {}
        self.settings: list[Setting] = []
        self.name = ""
        self.unclear = False

    def see(self, node: ast.AST) -> None:
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            value = self.value(node.value)
            if value is not None:
                self.values[node.targets[0].id] = value
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            if node.func.attr == "add":
                self._add(node)
            elif node.func.attr == "generate" and len(node.args) >= 3:
                value = self.value(node.args[2])
                self.name = value if isinstance(value, str) else self.name

    def _add(self, node: ast.Call) -> None:
        given = dict(zip(("name", "paramtype", "level", "description", "default"), node.args, strict=False))
        given.update({each.arg: each.value for each in node.keywords if each.arg})
        name = self.value(given["name"]) if "name" in given else None
        kind = given.get("paramtype")
        type_ = _TYPES.get(kind.id if isinstance(kind, ast.Name) else kind.attr if isinstance(kind, ast.Attribute) else "", "")
        if not type_:
            self.unclear = self.unclear or kind is not None
            return
        if not isinstance(name, str) or len(self.settings) >= _MOST_PARAMS:
            self.unclear = True
            return
        default = self.value(given["default"]) if "default" in given else _WITHOUT[type_]
        if type_ == "double" and isinstance(default, int) and not isinstance(default, bool):
            default = float(default)
        fits = isinstance(default, {"str": str, "int": int, "double": float, "bool": bool}[type_])
        self.settings.append(Setting(name, type_, default if fits else None, node.lineno))

    def value(self, node: ast.AST, depth: int = 0) -> Any:
        """The value of a constant expression; None where it is none."""
        if depth > _DEEPEST:
            return None
        if isinstance(node, ast.Constant):
            return node.value if isinstance(node.value, (str, int, float, bool)) else None
        if isinstance(node, ast.Name):
            return self.values.get(node.id)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
            value = self.value(node.operand, depth + 1)
            return -value if isinstance(node.op, ast.USub) and isinstance(value, (int, float)) else value
        if isinstance(node, ast.Attribute):
            return {"pi": 3.141592653589793}.get(node.attr)
        if isinstance(node, ast.BinOp):
            left, right = self.value(node.left, depth + 1), self.value(node.right, depth + 1)
            return _sum(node.op, left, right)
        return None


def _sum(operator: ast.operator, left: Any, right: Any) -> Any:
    if isinstance(left, str) and isinstance(right, str):
        return left + right if isinstance(operator, ast.Add) and len(left) + len(right) < 1000 else None
    if not isinstance(left, (int, float)) or not isinstance(right, (int, float)) or abs(left) > 1e12 or abs(right) > 1e12:
        return None
    if isinstance(operator, ast.Add):
        return left + right
    if isinstance(operator, ast.Sub):
        return left - right
    if isinstance(operator, ast.Mult):
        return left * right
    if isinstance(operator, ast.Div) and right:
        return left / right
    return None


def reconfigured(asked: Call, handle: Value) -> None:
    """Note the params of the configuration that a server is made for."""
    from launchlint.extract.fact import Fact

    machine, frame = asked.machine, asked.frame
    kind = machine.names.resolve(asked.types[0], frame).name if asked.types else ""
    package, _, config = kind.rpartition("::")
    found = _file(machine.root, frame.path, package, config.removesuffix("Config"))
    if found is None:
        machine.doubt("params", f"the params of {kind or 'a configuration'} are declared elsewhere", asked.node, frame)
        return
    path, settings = found
    shown = os.path.relpath(path, machine.root).replace(os.sep, "/")
    from launchlint.extract.cpp.naming import finished, in_namespace

    for condition, each in choices(handle):
        space = each.namespace if isinstance(each, Handle) else template(each)
        conditions = " and ".join(dict.fromkeys([*machine.conditions, *([condition] if condition else [])]))
        for setting in settings.settings:
            name = finished(in_namespace(space, setting.name))
            fact = Fact("params", name, shown, setting.line, default=setting.default, value_type=setting.type, condition=conditions)
            machine.note(fact._replace(when=machine.when))
    if settings.reason:
        machine.doubt("params", f"{os.path.basename(path)} {settings.reason}", asked.node, frame)


def _file(root: str, path: str, package: str, name: str) -> tuple[str, Settings] | None:
    """The .cfg file that generates a configuration."""
    directories: list[str] = []
    directory = os.path.dirname(os.path.join(root, path))
    for _ in range(12):
        directories += [os.path.join(directory, "cfg"), os.path.join(directory, "config"), os.path.join(directory, package, "cfg")]
        if os.path.realpath(directory) == os.path.realpath(root) or len(directory) < 2:
            break
        directory = os.path.dirname(directory)
    looked = 0
    for each in directories:
        files = [file for file in looking.names(each) if file.endswith(".cfg")]
        files.sort(key=lambda file: file != f"{name}.cfg")
        for file in files:
            looked += 1
            if looked > _MOST_FILES:
                return None
            settings = read_settings(os.path.join(each, file))
            if settings.name == name or (not settings.name and file == f"{name}.cfg"):
                return os.path.join(each, file), settings
    return None
