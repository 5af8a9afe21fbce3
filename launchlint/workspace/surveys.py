"""Questions about all that lies in the workspaces: who asks hangs on the answer, not on the thousands of files that were looked through."""

from __future__ import annotations

import os
from collections.abc import Mapping

from launchlint.spelling import folded
from launchlint.workspace.looking import note, question

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.packages import Packages


@question
def hook_variables(packages: Packages, _: str) -> Mapping[str, str]:
    """As :meth:`Packages.hook_variables`."""
    from launchlint.workspace.environment_hooks import read_hooks

    hooks = read_hooks(each for place in packages.places[: len(packages.workspaces)] for each in place.everything)
    note(hooks.looked)
    return hooks.variables


@question
def listed_in(packages: Packages, name: str) -> str | None:
    """As :meth:`Packages.listed_in`."""
    return packages.once(_listed).get(folded(name))


@question
def list_naming(packages: Packages, name: str) -> str:
    """The list of sources (absolute) that names a repository called ``name``, be it here or not; empty where there is none."""
    return packages.once(_sources).get(folded(name), "")


@question
def list_like(packages: Packages, name: str) -> str:
    """As :func:`list_naming`, whatever stands between the words: ``lidar_slam`` is ``lidarslam``."""
    return packages.once(_sources_like).get(folded(name).replace("_", ""), "")


def _sources_like(packages: Packages) -> Mapping[str, str]:
    return {name.replace("_", ""): file for name, file in packages.once(_sources).items()}


def _sources(packages: Packages) -> Mapping[str, str]:
    from launchlint.workspace.source_lists import read_source_lists

    return read_source_lists(packages.workspaces)


def _listed(packages: Packages) -> Mapping[str, str]:
    here = {
        folded(part)
        for place in packages.places[: len(packages.workspaces)]
        for package in place.everything
        for part in package.directory.removeprefix(place.root).split(os.sep)
    }
    return {each: file for each, file in packages.once(_sources).items() if each not in here}


@question
def variable_in(packages: Packages, name: str) -> str | None:
    """As :meth:`Packages.variable_in`."""
    from launchlint.workspace.variables import read_variables

    return packages.survey(read_variables).known.get(name)


@question
def documented_in(packages: Packages, name: str) -> str | None:
    """As :meth:`Packages.documented_in`."""
    from launchlint.workspace.mentions import read_documents

    named = packages.survey(read_documents).known.get(name)
    fetched = packages.survey_distributions().fetched.get(name)
    return fetched if named is None else named


@question
def told_to_install(packages: Packages, _: str) -> tuple[str, ...]:
    """As :meth:`Packages.told_to_install`."""
    from launchlint.workspace.mentions import read_documents

    return packages.survey(read_documents).installing


@question
def map_saved_in(packages: Packages, name: str) -> str | None:
    """As :meth:`Packages.map_saved_in`."""
    from launchlint.workspace.mentions import read_documents

    return packages.survey(read_documents).saved.get(name)


@question
def distributions(packages: Packages, _: str) -> tuple[frozenset[str], frozenset[str], frozenset[str], frozenset[str]]:
    """As :meth:`Packages.distributions`, in its order, without what was looked at, and what is fetched."""
    found = packages.survey_distributions()
    return found.named, frozenset(), found.installs, found.templates


@question
def machine_defined_in(packages: Packages, name: str) -> str | None:
    """As :meth:`Packages.machine_defined_in`."""
    from launchlint.workspace.machines import read_machines

    return packages.survey(read_machines, packages.held).known.get(name)


@question
def launch_files(packages: Packages, name: str) -> tuple[str, ...]:
    """As :meth:`Packages.launch_files`."""
    from launchlint.workspace.launch_files import read_launch_files

    return packages.survey(read_launch_files).known.get(name, ())


@question
def container_users(packages: Packages, _: str) -> frozenset[str]:
    """As :meth:`Packages.container_users`."""
    from launchlint.workspace.container_homes import read_homes

    return packages.survey(read_homes).users


@question
def container_directories(packages: Packages, _: str) -> frozenset[str]:
    """As :meth:`Packages.container_directories`."""
    from launchlint.workspace.container_homes import read_homes

    return packages.survey(read_homes).directories


@question
def placing_scripts(packages: Packages, word: str) -> tuple[str, ...]:
    """The shell scripts of the workspaces (absolute) that copy programs to ``lib/PKG`` of an install or devel space and name ``word``."""
    from launchlint.workspace.placing_scripts import read_placing_scripts

    return packages.survey(read_placing_scripts).known.get(word, ())
