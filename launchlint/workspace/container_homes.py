"""Home directories that a workspace's own containers have: made by its Dockerfiles, or mounted by compose files and docker scripts."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from launchlint.workspace.looking import content, names, walk

_MOST_DIRECTORIES = 1_000
_MOST_FILES = 300
_LARGEST = 200_000
_HIDDEN = ".devcontainer"
_SCRIPT_ENDS = (".sh", ".bash", ".py", "Makefile", "justfile")
_IN_IMAGE = re.compile(r"(?<![\w.$/-])/home/([\w.-]+)")
_USER = re.compile(r"^[ \t]*USER[ \t]+([a-z_][\w.-]*)", re.MULTILINE)
# What stands behind the colon of a mount, or as its target; not the side of the host.
_MOUNTED = re.compile(r"(?::|(?:target|dst|destination|workdir)[= ][\"']?|workspaceFolder\"[ \t]*:[ \t]*\")/home/([\w.-]+)")
_DOCKER = re.compile(r"\b(?:docker|podman)\b", re.IGNORECASE)


class Homes(NamedTuple):
    """The ``users`` below ``/home`` of the containers, and the places that were looked at."""

    users: frozenset[str]
    looked: frozenset[str]


def read_homes(directories: Iterable[str]) -> Homes:
    """Whose home directories the containers of ``directories`` have; nothing is run. Bounded; never raises."""
    users: set[str] = set()
    looked: set[str] = set()
    left = _MOST_FILES
    for top in directories:
        for directory, listed in _places(top):
            looked.add(directory)
            for name in listed:
                image = name.startswith("Dockerfile") or name.lower().endswith(".dockerfile")
                mounts = name == "devcontainer.json" or ("compose" in name and name.endswith((".yml", ".yaml")))
                if left <= 0 or not (image or mounts or name.endswith(_SCRIPT_ENDS)):
                    continue
                left -= 1
                file = os.path.join(directory, name)
                looked.add(file)
                text = (content(file) or b"")[:_LARGEST].decode("utf-8", "replace")
                if image:
                    users.update(_IN_IMAGE.findall(text), _USER.findall(text))
                elif mounts or _DOCKER.search(text):
                    users.update(_MOUNTED.findall(text))
    return Homes(frozenset(users), frozenset(looked))


def _places(top: str) -> Iterator[tuple[str, list[str]]]:
    hidden = os.path.join(top, _HIDDEN)
    yield hidden, names(hidden)
    yield from walk(top, _MOST_DIRECTORIES)
