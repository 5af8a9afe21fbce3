"""Why a package that a launch file uses may be missing from the ``package.xml`` on purpose, or without harm."""

from __future__ import annotations

from launchlint.late import late
from launchlint.rules.packages.metapackages import members
from launchlint.syntax.tree import Document
from launchlint.workspace.mentions import install_lines, says_install
from launchlint.workspace.packages import Package, Packages
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.put_aside import put_aside

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.manifest import Manifest

BASE = "ros_base"
_BENCH = late(r"(?:^|[/_.-])(?:tests?|bench\w*|debug|examples?|demos?|play\w*|replay|(?:ros)?bags?)(?:[/_.-]|[A-Z\d]|$)")
_ADDRESS = late(r"<(?:maintainer|author)\b[^>]*\bemail\s*=\s*[\"']([^\"']+)[\"']")


def why_left_out(name: str, document: Document, home: Package, packages: Packages) -> str:
    """Why it is no matter that ``home`` does not declare ``name`` for this launch file, for people; empty where it is one."""
    path = document.source.path
    if put_aside(path):
        return f"{path}, which uses {name}, seems to have been put aside"
    comments = [line for comment in document.comments for line in install_lines(comment.text)]
    if says_install(name, comments) or says_install(name, packages.documents().installing):
        return f"people are told to install {name} where they need it, so that it seems to be left out on purpose"
    if _BENCH.search(path) is not None and name in _base():
        return f"{name} is part of every installation of {BASE}, and it is used to try something out only"
    if is_copy(home, packages):
        return f"{home.name} is a copy of a public package, and that is where to declare {name}"
    return ""


def is_copy(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is a public package in a workspace of others: most packages there are not public, and none has its people."""
    if home.name not in public_names() or home.manifest is None:
        return False
    people = _people(home.manifest)
    if not people:
        return False
    own = public = 0
    for place in packages.places[: len(packages.workspaces)]:
        for each in place.everything:
            if each.manifest is None:
                continue
            if each.name in public_names():
                public += 1
            elif not people.isdisjoint(_people(each.manifest)):
                return False
            else:
                own += 1
    return own >= public


def _people(manifest: Manifest) -> frozenset[str]:
    return frozenset(address.lower() for address in _ADDRESS.findall(manifest.source.text))


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
