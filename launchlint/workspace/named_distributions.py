"""Which distributions of ROS 2 a repository says it is for: in its README, images, workflows, development containers, source lists, and
the scripts beside them.

Nothing is run. The files at the top of the repository count, and those in the few directories where images and workflows are kept; where
they name none, those of its packages.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence

from launchlint.workspace.looking import names, note, question
from launchlint.workspace.source_lists import is_source_list
from launchlint.workspace.texts import parts

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.packages import Packages

_MOST_FILES = 120
_MOST_PACKAGES = 60
_WORKFLOWS = os.path.join(".github", "workflows")
_PLACES = ("docker", "Docker", ".docker", ".devcontainer", "devcontainer", "ci", ".ci", ".circleci")
_STARTS = ("readme", "dockerfile", "containerfile", "docker-compose", "compose", "devcontainer")
_SCRIPTS = (".sh", ".bash")
_ENDS = (".dockerfile", ".yml", ".yaml", ".env", *_SCRIPTS)
_CI = (".gitlab-ci.yml", ".travis.yml", "azure-pipelines.yml", "pixi.toml")


def named_distributions(roots: Iterable[str], packages: Iterable[str]) -> Mapping[str, str]:
    """The distributions that the repositories at ``roots`` name, each with the first file (absolute) that does.

    ``packages`` are the directories of their packages. Bounded; never raises. What it hangs on is noted for the cache.
    """
    found = _read(each for root in roots for each in _places(root))
    return found or _read(
        (directory, [name for name in names(directory) if _at_top(name)]) for directory in list(packages)[:_MOST_PACKAGES]
    )


@question
def named_in(packages: Packages, _: str) -> Mapping[str, str]:
    """The same of what is checked, and of the packages that can be seen from there."""
    return named_distributions(packages.workspaces, [each.directory for place in packages.places for each in place.everything])


def _read(places: Iterable[tuple[str, Sequence[str]]]) -> dict[str, str]:
    found: dict[str, str] = {}
    looked: set[str] = set()
    for file, listed in parts(places, _MOST_FILES, looked, "distributions"):
        for name in listed:
            found.setdefault(name, file)
    note(looked)
    return found


def _places(root: str) -> Iterator[tuple[str, list[str]]]:
    """Directories with the files of each that say what the repository is for."""
    listed = names(root)
    yield root, [name for name in listed if _at_top(name) or name.endswith(_SCRIPTS)]
    for place in (_WORKFLOWS, *(name for name in _PLACES if name in listed)):
        directory = os.path.join(root, place)
        inside = names(directory)
        yield directory, [name for name in inside if _at_top(name) or name.lower().endswith(_ENDS) or name == "devcontainer.json"]
        for name in inside:
            if "." not in name and place != _WORKFLOWS:
                below = os.path.join(directory, name)
                yield below, [each for each in names(below) if _at_top(each)]


def _at_top(name: str) -> bool:
    return name.lower().startswith(_STARTS) or name.lower().endswith(_ENDS[0]) or name in _CI or is_source_list(name)
