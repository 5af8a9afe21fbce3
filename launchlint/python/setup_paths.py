"""Where ``setup.py`` says that the modules of a package are: ``packages`` and ``package_dir``, read and never executed."""

from __future__ import annotations

import ast
import os
import posixpath

from launchlint.python.source import SourceError, parse

_MOST = 500
_DEEPEST = 20


def setup_paths(directory: str) -> dict[str, str]:
    """Dotted name of a Python package → its directory below ``directory``, as ``setup.py`` there has it; the root of all others is ``""``.

    What cannot be read without running it is left out, and so is what lies outside of ``directory``.
    Source: distutils' ``package_dir``, which ``catkin_python_setup()`` follows.
    """
    try:
        tree = parse(os.path.join(directory, "setup.py")).tree
    except SourceError:
        return {}
    said = _Said(tree)
    found = {name.strip("."): path for name, path in said.directories.items()}
    if "" not in found:
        found.update({name: name.replace(".", "/") for name in said.packages if name.partition(".")[0] not in found})
    inside = {name: posixpath.normpath(path or ".") for name, path in found.items() if "\0" not in path}
    return {name: path for name, path in inside.items() if not path.startswith(("/", "../")) and path != ".."}


class _Said:
    """What is given for ``package_dir`` and ``packages``, wherever it stands: an argument, an item of a dict, an assignment of one."""

    def __init__(self, tree: ast.Module) -> None:
        self.directories: dict[str, str] = {}
        self.packages: list[str] = []
        self._values: dict[str, ast.expr] = {}
        given: list[tuple[str, ast.expr]] = []
        for node in ast.walk(tree):
            if isinstance(node, ast.keyword) and node.arg:
                given.append((node.arg, node.value))
            elif isinstance(node, ast.Dict):
                given += [
                    (str(key.value), value) for key, value in zip(node.keys, node.values, strict=True) if isinstance(key, ast.Constant)
                ]
            elif isinstance(node, ast.Assign) and len(node.targets) == 1:
                target = node.targets[0]
                if isinstance(target, ast.Name):
                    self._values[target.id] = node.value
                elif isinstance(target, ast.Subscript) and isinstance(target.slice, ast.Constant):
                    given.append((str(target.slice.value), node.value))
        for name, value in given:
            if name == "package_dir":
                self._note_directories(value)
            elif name == "packages":
                value = self._meant(value)
                items = value.elts if isinstance(value, (ast.List, ast.Tuple)) else []
                self.packages += [text for text in map(self._text, items[:_MOST]) if text]

    def _note_directories(self, value: ast.expr) -> None:
        value = self._meant(value)
        pairs: list[tuple[str | None, ast.expr]] = []
        if isinstance(value, ast.Dict):
            pairs = [(self._text(key), each) for key, each in zip(value.keys, value.values, strict=True) if key is not None]
        elif isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and value.func.id == "dict":
            for argument in value.args[:1]:
                self._note_directories(argument)
            pairs = [(keyword.arg, keyword.value) for keyword in value.keywords]
        for name, each in pairs[:_MOST]:
            path = self._text(each)
            if name is not None and path is not None:
                self.directories[name] = path

    def _meant(self, value: ast.expr) -> ast.expr:
        """What a name stands for."""
        for _ in range(_DEEPEST):
            if not isinstance(value, ast.Name) or value.id not in self._values:
                break
            value = self._values[value.id]
        return value

    def _text(self, value: ast.expr, depth: int = 0) -> str | None:
        """The text that an expression is, None where that is not known."""
        value = self._meant(value)
        if isinstance(value, ast.Constant):
            return value.value if isinstance(value.value, str) else None
        if depth > _DEEPEST:
            return None
        if isinstance(value, ast.BinOp) and isinstance(value.op, ast.Add):
            return self._joined("", [value.left, value.right], depth)
        if isinstance(value, ast.JoinedStr):
            return self._joined("", value.values, depth)
        if isinstance(value, ast.FormattedValue) and value.conversion == -1 and value.format_spec is None:
            return self._text(value.value, depth + 1)
        if isinstance(value, ast.Call) and ast.unparse(value.func) in ("os.path.join", "path.join", "join") and not value.keywords:
            return self._joined("/", value.args, depth)
        return None

    def _joined(self, separator: str, parts: list[ast.expr], depth: int) -> str | None:
        if len(parts) > _DEEPEST:
            return None
        texts = [self._text(each, depth + 1) for each in parts]
        known = [text for text in texts if text is not None]
        found = separator.join(known)
        return found if len(known) == len(texts) and len(found) < 4096 else None
