"""The environment variables that env-hooks of public packages set: wherever such a package is installed, its variables are set.

The data is ``public_variables.txt`` beside this module: facts read from the hooks of these packages, a line for each package.
"""

from __future__ import annotations

import os
from functools import cache

_FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "public_variables.txt")


@cache
def _setters() -> dict[str, tuple[str, ...]]:
    found: dict[str, list[str]] = {}
    with open(_FILE, encoding="utf-8") as file:
        for line in file:
            if not line.startswith("#"):
                package, _, variables = line.strip().partition("\t")
                for variable in variables.split(" "):
                    found.setdefault(variable, []).append(package)
    return {variable: tuple(packages) for variable, packages in found.items()}


def public_setters(variable: str) -> tuple[str, ...]:
    """The public packages that set ``variable``; none where none is known to."""
    return _setters().get(variable, ())
