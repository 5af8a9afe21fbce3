"""Directories that a workspace's own containers have: made by its Dockerfiles, or mounted by compose files and docker scripts."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk
from launchlint.workspace.texts import texts

_MOST_DIRECTORIES = 1_000
_MOST_FILES = 300
HIDDEN = (".devcontainer", ".docker")
"""Hidden directories in which people keep what their containers are made of."""
MOST_HIDDEN = 50
_SCRIPT_ENDS = (".sh", ".bash", ".py", "Makefile", "justfile")
_IN_IMAGE = re.compile(r"(?<![\w.$/-])/home/([\w.-]+)")
_USER = re.compile(r"^[ \t]*USER[ \t]+([a-z_][\w.-]*)", re.MULTILINE)
# What stands behind the colon of a mount, or as its target; not the side of the host.
_MOUNTED = re.compile(r"(?::|(?:target|dst|destination|workdir)[= ][\"']?|workspaceFolder\"[ \t]*:[ \t]*\")/home/([\w.-]+)")
_DIRECTORY = r"(/(?!(?:home|opt/ros|usr|etc|bin|lib|dev|proc|sys|var|run|tmp)(?:/|$|\s))\w[\w.-]*)"
"""The first directory of a path that is not one of every machine."""
_MADE = re.compile(rf"^[ \t]*(?:WORKDIR[ \t]+|RUN[ \t]+mkdir[ \t]+(?:-p[ \t]+)?){_DIRECTORY}", re.MULTILINE)
_MOUNTED_AT = re.compile(rf"(?::|(?:target|dst|destination|workdir)[= ][\"']?|workspaceFolder\"[ \t]*:[ \t]*\"){_DIRECTORY}")
_DOCKER = re.compile(r"\b(?:docker|podman)\b", re.IGNORECASE)


class Homes(NamedTuple):
    """The ``users`` below ``/home`` of the containers, other ``directories`` of theirs (``/ws``), and the places that were looked at."""

    users: frozenset[str]
    directories: frozenset[str]
    looked: frozenset[str]


def read_homes(directories: Iterable[str]) -> Homes:
    """Whose home directories the containers of ``directories`` have; nothing is run. Bounded; never raises."""
    users: set[str] = set()
    made: set[str] = set()
    looked: set[str] = set()
    for file, text in texts(_places(directories), _MOST_FILES, looked):
        name = os.path.basename(file)
        if _is_image(name):
            users.update(_IN_IMAGE.findall(text), _USER.findall(text))
            made.update(_MADE.findall(text))
        elif _mounts(name) or _DOCKER.search(text):
            users.update(_MOUNTED.findall(text))
            made.update(_MOUNTED_AT.findall(text))
    return Homes(frozenset(users), frozenset(made), frozenset(looked))


def _places(directories: Iterable[str]) -> Iterator[tuple[str, list[str]]]:
    for top in directories:
        hidden = (each for name in HIDDEN for each in walk(os.path.join(top, name), MOST_HIDDEN))
        for directory, listed in (*hidden, *walk(top, _MOST_DIRECTORIES)):
            yield directory, [name for name in listed if _is_image(name) or _mounts(name) or name.endswith(_SCRIPT_ENDS)]


def _is_image(name: str) -> bool:
    return name.startswith("Dockerfile") or name.lower().endswith(".dockerfile")


def _mounts(name: str) -> bool:
    return name == "devcontainer.json" or ("compose" in name and name.endswith((".yml", ".yaml")))
