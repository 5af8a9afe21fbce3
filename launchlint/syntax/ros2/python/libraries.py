"""Classes of libraries around launch, with what their constructors take: what is known of them by name, whatever version is installed.

A line is a class: its full name with its arguments in order, all of them by position or name; ``x=`` need not be given.
Source: the constructors in ``nav2_common.launch``.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from launchlint.problem import Problem
from launchlint.python.values import MORE, Handle, Map, Unknown, Value
from launchlint.source import Origin, Place
from launchlint.syntax.ros2.python.problems import NotASubstitution

_CLASSES = """
nav2_common.launch.LaunchConfigAsBool name
nav2_common.launch.HasNodeParams source_file node_name
nav2_common.launch.ReplaceString source_file replacements condition=
nav2_common.launch.RewrittenYaml source_file param_rewrites root_key= key_rewrites= value_rewrites= convert_types= out_dir=
"""

FOLLOWED_NOT = ("nav2_common.launch", "yaml", "xacro")
"""Modules that are known so well that they are not followed, wherever they are."""


@lru_cache(maxsize=1)
def _signatures() -> dict[str, tuple[str, ...]]:
    return {name: tuple(words) for name, *words in (line.split() for line in _CLASSES.strip().splitlines())}


def _canonical(name: str) -> str:
    """Classes can be imported from the module that defines them, too: ``nav2_common.launch.rewritten_yaml.RewrittenYaml``."""
    parts = name.split(".")
    return ".".join((*parts[:2], parts[3])) if len(parts) == 4 and parts[2].islower() else name


def is_of_library(name: str) -> bool:
    """Whether a class of a full name is known here."""
    return _canonical(name) in _signatures()


def wrong_rewrites(value: Value, place: Place) -> Iterator[Problem]:
    """Values that are written into a file and are no texts: None, as of a variable of the environment that is not set."""
    if not isinstance(value, Handle):
        return
    for role in ("param_rewrites", "key_rewrites", "value_rewrites", "replacements"):
        given = value.state.get(role)
        if isinstance(given, Map) and any(each is None for each in given.entries.values()):
            yield NotASubstitution(
                origin=Origin(place), refused=True, callee=value.kind, argument=role, found="None", item=True, written="", declared=""
            )


def made(name: str, positional: list[Value], keywords: dict[str, Value], place: Place) -> Value:
    """An object of a class that is known here; unknown where it is made otherwise than that class takes it."""
    arguments = _signatures()[_canonical(name)]
    names = [each.removesuffix("=") for each in arguments]
    given = {**dict(zip(names, positional, strict=False)), **keywords}
    lacking = [each for each in arguments if not each.endswith("=") and each not in given]
    if MORE in keywords or lacking or len(positional) > len(names) or given.keys() - set(names):
        return Unknown(f"{name} is not made with the arguments that are known of it", place)
    return Handle(_canonical(name).rpartition(".")[2], {**given, "place": place, "places": {}})
