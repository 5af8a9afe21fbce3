"""Libraries around launch whose source is not in the workspace: models of them, which are followed in its place.

A model is a program in ``models/``, written for launchlint from what the library does, and read like a module of the workspace; no part of
it is ever run. What the library does otherwise from version to version, a model says by the functions of :data:`SAID`.
"""

from __future__ import annotations

import os
from collections.abc import Sequence

from launchlint.python.values import MISSING, Quiet, Value
from launchlint.source import Place

DIRECTORY = os.path.join(os.path.dirname(os.path.abspath(__file__)), "models", "")
SAID = "launchlint_models"
"""The module that models import: ``unknown(why)`` is a value that nobody knows, ``may_fail()`` may raise an exception, and
``distribution()`` is the name of the distribution that is meant."""

_MODELS = {
    "launch_param_builder": ("", "launch_param_builder", "utils"),
    "moveit_configs_utils": ("", "moveit_configs_builder"),
    "moveit_configs_utils.launch_utils": ("",),
    "moveit_configs_utils.launches": ("",),
    "moveit_configs_utils.substitutions": ("", "xacro"),
}
"""Models, each with the modules of the library that it stands for: itself, and others below it."""
_FILES = {f"{name}.{module}" if module else name: f"{name}.model" for name, modules in _MODELS.items() for module in modules}


def model_of(name: str) -> str | None:
    """The file of the model that stands for a module of this name (dotted); None where there is none."""
    file = _FILES.get(name)
    return None if file is None else DIRECTORY + file


def call(name: str, positional: Sequence[Value], place: Place, distro: str) -> tuple[Value, bool]:
    """What a function of :data:`SAID` gives, MISSING for all others; and whether it may raise an exception."""
    if name == f"{SAID}.unknown" and positional and isinstance(positional[0], str):
        return Quiet(positional[0], place), False
    if name == f"{SAID}.may_fail":
        return None, True
    return (distro if name == f"{SAID}.distribution" else MISSING), False
