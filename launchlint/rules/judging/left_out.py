"""Why a package that a launch file uses may be missing from the ``package.xml`` on purpose, or without harm."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable

from launchlint.late import late
from launchlint.rules.judging.kept_projects import kept_whole
from launchlint.rules.judging.metapackages import members
from launchlint.rules.judging.projects import (
    is_beside_own,
    is_copy,
    is_from_elsewhere,
    is_generated,
    is_renamed,
    is_signed,
    is_well_known,
)
from launchlint.syntax.tree import Document
from launchlint.workspace.looking import is_file, walk
from launchlint.workspace.mentions import install_lines, says_install
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.put_aside import put_aside
from launchlint.workspace.registered_tests import TEST_END

BASE = "ros_base"
SETUP_ASSISTANT = ".setup_assistant"
_BENCH = late(r"(?:^|[/_.-])(?:tests?|bench\w*|debug|examples?|demos?|play\w*|replay|(?:ros)?bags?)(?:[/_.-]|[A-Z\d]|$)")
_TRIAL = late(r"(?:^|[/_.-])(?:tests?|debug|examples?|demos?|tryout|bench\w*)(?:[/_.-]|[A-Z\d]|$)")
_LAUNCH_ENDS = (".launch", ".launch.xml", TEST_END)
_MOST_DIRECTORIES = 100
_TESTS = late(r"(?:^|/)tests?/")
_LEFT_OUT = late(
    r"\b(?:left|leav(?:e|es|ing)|keep|kept) out\b|\b(?:omit(?:s|ted)?|excluded?|optional(?:ly)?)\b"
    r"|\b(?:not|n't|never)\s+(?:be\s+)?(?:declared?|listed?|includ(?:e|ed)|add(?:ed)?|released|available|required|needed)\b",
    re.IGNORECASE,
)
"""In a comment beside dependencies: that one of them is missing on purpose."""


def why_left_out(name: str, document: Document, home: Package, packages: Packages) -> str:
    """Why it is no matter that ``home`` does not declare ``name`` for this launch file, for people; empty where it is one."""
    path = document.source.path
    if put_aside(path):
        return f"{path}, which uses {name}, seems to have been put aside"
    comments = [line for comment in document.comments for line in install_lines(comment.text)]
    if says_install(name, comments) or says_install(name, packages.told_to_install()):
        return f"people are told to install {name} where they need it, so that it seems to be left out on purpose"
    if home.manifest is not None and _says_left_out(name, home.manifest.comments):
        return f"a comment of package.xml says that {name} is left out"
    if name in _base():
        if home.name not in public_names():
            return f"{name} is part of {BASE}, the smallest installation, and {home.name} is none of the released packages"
        if _BENCH.search(path) is not None:
            return f"{name} is part of every installation of {BASE}, and it is used to try something out only"
    if is_generated(home):
        return f"the setup assistant of CHAMP wrote {home.name}, and would again"
    renamed = is_renamed(home, packages)
    if renamed:
        return f"{home.name} is a copy of the public package {renamed}, and that is where to declare {name}"
    if is_beside_own(home, packages):
        return f"{home.name} is by people who made none of the packages here that are left as a template: it seems to be a copy"
    if is_copy(home, packages) or is_from_elsewhere(home, packages):
        return f"{home.name} is a copy of a public package, and that is where to declare {name}"
    project = kept_whole(home, packages)
    if project:
        whole = posixpath.basename(project)
        return f"{home.name} is part of another project, {whole}, which is kept here as a whole: that is where to declare {name}"
    if is_well_known(home, packages):
        return f"{home.name} is one of the packages that people copy, made by others: where it is from is where to declare {name}"
    if is_signed(home, packages):
        return f"{home.name} has a licence, of people who made none of the packages here that have none: it seems to be a copy"
    return ""


def is_trial(file: str, home: Package) -> bool:
    """Whether a person starts the launch file of package ``home`` to try something out; machines run tests.

    MoveIt's ``demo.launch`` is what people start, and so is what most launch files of a package are called.
    """
    inside = posixpath.relpath(posixpath.abspath(file), home.directory)
    if not _tries(inside) or _TRIAL.search(home.name) or is_file(posixpath.join(home.directory, SETUP_ASSISTANT)):
        return False
    listed = [
        posixpath.relpath(posixpath.join(directory, name), home.directory)
        for directory, names in walk(home.directory, _MOST_DIRECTORIES)
        for name in names
        if name.endswith(_LAUNCH_ENDS)
    ]
    return 2 * sum(map(_tries, listed)) <= len(listed)


def _says_left_out(name: str, comments: Iterable[str]) -> bool:
    """Whether one of the comments names the package and says that something is not declared on purpose."""
    named = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    return any(_LEFT_OUT.search(comment) is not None and named.search(comment) is not None for comment in comments)


def _tries(inside: str) -> bool:
    return not inside.endswith(TEST_END) and _TESTS.search(inside) is None and _TRIAL.search(inside) is not None


def _base() -> frozenset[str]:
    """What ``ros_base`` brings along, over all its metapackages."""
    found: set[str] = set()
    waiting = [BASE]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += members(name)
    return frozenset(found)
