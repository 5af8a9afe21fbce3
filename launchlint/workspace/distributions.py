"""What the texts of a workspace (README, workflows, images, scripts) say of ROS distributions, of installing, and of what they fetch.

Nothing is run.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import names, walk
from launchlint.workspace.texts import texts

_MOST_DIRECTORIES = 400
_MOST_FILES = 600
_WORKFLOWS = os.path.join(".github", "workflows")
_ENDS = (".yml", ".yaml", ".sh", ".bash", ".rosinstall", ".repos", ".dockerfile", ".workspace")
_CMAKE = "CMakeLists.txt"
# What catkin_create_pkg wrote: links to the documents of the distribution of its day; since Noetic (catkin_pkg 0.4.16) CMake 3.0.2.
# Their CMakeLists.txt in src/ is a link into the distribution that built the workspace (a file that names it where links were lost).
_LINKED = re.compile(
    r"(?:docs\.ros\.org|ros\.org/doc)/(groovy|hydro|indigo|jade|kinetic|lunar|melodic|noetic)/"
    r"|\A\s*/opt/ros/(groovy|hydro|indigo|jade|kinetic|lunar|melodic|noetic)/share/catkin/"
)
_NEW_TEMPLATE = re.compile(r"^[ \t]*cmake_minimum_required\s*\(\s*VERSION\s+3\.(?:0\.2|[1-9])", re.MULTILINE | re.IGNORECASE)
_NAMED = re.compile(r"(?<![A-Za-z])(fuerte|groovy|hydro|indigo|jade|kinetic|lunar|melodic|noetic)(?![A-Za-z])", re.IGNORECASE)

_UBUNTU = {"14.04": "indigo", "16.04": "kinetic", "18.04": "melodic", "20.04": "noetic"}
"""The one distribution of ROS 1 that was built for good for each Ubuntu that outlived it (REP 3)."""
_ON_UBUNTU = re.compile(r"\bubuntu[ :_-]{1,2}(1[468]\.04|20\.04)\b", re.IGNORECASE)


# Not what builds ROS itself, with the catkin that lies among its sources.
_INSTALLS = re.compile(
    r"(?<!catkin/bin/)\bcatkin_make(?:_isolated)?\b[^\n#]{0,400}\binstall\b|\bcatkin[ \t]+config\b[^\n#]{0,400}[ \t]--install\b"
    r"|\bindustrial_ci\b|\bbloom-(?:release|generate)\b|\bdpkg-buildpackage\b"
)
_COLCON = re.compile(r"\bcolcon[ \t]+build\b")
_ROS_2 = re.compile(r"(?<![A-Za-z])(?:ardent|bouncy|crystal|dashing|eloquent|foxy|galactic|humble|iron|jazzy|kilted|rolling)(?![A-Za-z])")


# A line that brings other sources here: `git clone …/arm_tools.git`, `mv arm/arm_tools .`, `ln -s …`, `wget …/arm_tools.zip`.
_FETCHES = re.compile(r"\b(?:git|clone|svn|hg|wstool|vcs|mv|ln|cp|wget|curl|unzip|tar)\b")
_FETCHED = re.compile(r"(?<![\w-])([A-Za-z]\w*_\w*)(?![\w-])")
_SHORTEST = 6


class Distributions(NamedTuple):
    """The distributions of ROS 1 that are named (small letters), or else those of the Ubuntus that are, and the places that were looked at.

    ``installs``: the directories of the files with a step that installs what is built (catkin builds a devel space without one).
    ``templates``: the distributions of the templates from which the ``CMakeLists.txt`` of the packages were made; it is but a hint.
    ``fetched``: names in lines that bring other sources here, each with the first file (absolute) that does.
    """

    named: frozenset[str]
    looked: frozenset[str]
    installs: frozenset[str] = frozenset()
    templates: frozenset[str] = frozenset()
    fetched: Mapping[str, str] = MappingProxyType({})

    @property
    def meant(self) -> frozenset[str]:
        """The distributions that are named; where none is, those of the templates."""
        return self.named or self.templates

    def are_older_than(self, distribution: str) -> bool:
        """Whether only distributions before this one are meant. They are named in the order of the alphabet."""
        return bool(self.meant) and max(self.meant) < distribution.lower()


def read_distributions(directories: Iterable[str], packages: Iterable[str] = ()) -> Distributions:
    """The distributions that files below ``directories`` name, and those in the directories of ``packages``. Bounded; never raises."""
    looked: set[str] = set()
    found: set[str] = set()
    systems: set[str] = set()
    templates: set[str] = set()
    installs: set[str] = set()
    fetched: dict[str, str] = {}
    for file, text in texts(_places(directories, packages), _MOST_FILES, looked):
        if file.endswith(_CMAKE):
            templates.update(match[1] or match[2] for match in _LINKED.finditer(text))
            templates.update(["noetic"] if _NEW_TEMPLATE.search(text) else [])
            continue
        found.update(name.lower() for name in _NAMED.findall(text))
        systems.update(_UBUNTU[version] for version in _ON_UBUNTU.findall(text))
        if _INSTALLS.search(text) or (_COLCON.search(text) and not _ROS_2.search(text)):
            installs.add(os.path.dirname(file))
        for line in text.split("\n") if _FETCHES.search(text) else ():
            if "_" in line and not line.lstrip(" \t").startswith("#") and _FETCHES.search(line):
                for name in _FETCHED.findall(line):
                    if len(name) >= _SHORTEST:
                        fetched.setdefault(name, file)
    return Distributions(
        frozenset(found or systems), frozenset(looked), frozenset(installs), frozenset(templates), MappingProxyType(fetched)
    )


def _places(directories: Iterable[str], packages: Iterable[str]) -> Iterator[tuple[str, list[str]]]:
    seen: set[str] = set()
    for top in directories:
        workflows = os.path.join(top, _WORKFLOWS)
        for directory, listed in ((workflows, names(workflows)), (top, names(top)), *walk(top, _MOST_DIRECTORIES)):
            seen.add(directory)
            yield directory, [name for name in listed if _is_wanted(name)]
    for directory in packages:  # what a workspace with too many directories has left
        if directory not in seen:
            yield directory, [name for name in names(directory) if _is_wanted(name)]


def _is_wanted(name: str) -> bool:
    return name.lower().startswith(("readme", "dockerfile")) or name.lower().endswith(_ENDS) or name == _CMAKE
