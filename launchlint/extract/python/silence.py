"""Programs that have nothing to do with ROS, told by what they import: they need not be followed."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator

from launchlint.extract.python.foreign import has_no_ros
from launchlint.python.modules import ModuleFinder
from launchlint.python.source import Source, SourceError

MOST_MODULES = 60


def says_nothing(program: Source, beside: str, package: str, finder: ModuleFinder) -> bool:
    """Whether all that a program imports, whatever that imports in turn included, has nothing to do with ROS.

    Where that cannot be told from the imports alone it is False: one of a module that is not known, one that is relative or worked out.
    """
    pending: list[tuple[str, Source]] = [("", program)]
    seen: set[str] = set()
    while pending:
        inside, source = pending.pop()
        if source.makes_code or len(seen) > MOST_MODULES:
            return False
        for name, required in _imported(source.imports):
            top = name.partition(".")[0]
            if not required and finder.find(name, beside, package) is None:
                continue  # no module, but something in one
            if finder.find(top, beside, package) is None:
                if not has_no_ros(name) or (inside and finder.find(f"{inside}.{top}", beside, package) is not None):
                    return False
                continue
            parts = name.split(".")
            for end in range(1, len(parts) + 1):
                full = ".".join(parts[:end])
                path = finder.find(full, beside, package)
                if path is None:
                    return False
                if full in seen or path.endswith(os.sep):
                    continue
                seen.add(full)
                try:
                    pending.append((full if path.endswith("__init__.py") else full.rpartition(".")[0], finder.parse(path)))
                except SourceError:
                    return False
    return True


def _imported(nodes: tuple[ast.Import | ast.ImportFrom, ...]) -> Iterator[tuple[str, bool]]:
    """Names of modules, and whether each must be one; what ``from x import y`` names may be."""
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from ((alias.name, True) for alias in node.names)
        elif node.level or not node.module:
            yield "", True
        else:
            yield node.module, True
            yield from ((f"{node.module}.{alias.name}", False) for alias in node.names if alias.name != "*")
