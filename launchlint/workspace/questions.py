"""What packages were asked, as results hold it beside the paths that they hang on: a question has an answer, as a path has a state.

A question is asked of packages that are found in one way, and is about a name or a path: ``?rospack get arm``. Its answer is another one
where somebody who asks could see that a package is another one: its place, its kind; what else its manifest says is noted by who reads it.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable

from launchlint.workspace.looking import QUESTION, unnoted
from launchlint.workspace.repository import repository_root

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.package import Package
    from launchlint.workspace.packages import Packages

_ROS2 = {"ROS_VERSION": "2"}


def answer(packages: Packages, asked: str) -> str:
    """The state of the answer to a question: a digest in hexadecimal; empty to what is no question."""
    from hashlib import sha1

    way, _, more = asked.removeprefix(QUESTION).partition(" ")
    kind, _, about = more.partition(" ")
    those = packages.colcon if way == packages.colcon.way.name else packages
    if way != those.way.name:
        return ""
    with unnoted():
        if ":" in kind:
            function = _function(kind)
            return "" if function is None else those.answer_state(function, about)
        if kind not in _ANSWERS:
            return ""
        found = _ANSWERS[kind](those, about)
    return sha1(found.encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()


def _function(kind: str) -> Callable[[Packages, str], object] | None:
    """The question that is called so, ``module:function``; None where it is none of launchlint's."""
    from importlib import import_module

    module, _, name = kind.partition(":")
    if not module.startswith("launchlint.") or not all(map(str.isidentifier, (*module.split("."), name))):
        return None
    try:
        function = getattr(import_module(module), name, None)
    except ImportError:
        return None
    return function if getattr(function, "is_question", False) else None


def _described(package: Package | None) -> str:
    if package is None:
        return ""
    kinds = package.kind, package.under(_ROS2).kind  # the first one may find that the manifest is broken
    told = [list(map(str, (each[:4], each.is_ament, sorted(each.ros_versions), each.build_types, each.plugins))) for each in kinds]
    return repr((package.name, package.directory, package.manifest_path, package.broken, package.is_metapackage, told))


def _all_of(packages: Iterable[Package]) -> str:
    return "\n".join(map(_described, packages))


def _get(packages: Packages, name: str) -> str:
    return _all_of(packages.copies(name))


def _of(packages: Packages, directory: str) -> str:
    return _described(packages.package_of(directory))


def _all(packages: Packages, _: str) -> str:
    return "\n".join(f"{place.root}\n{_all_of(place.everything)}" for place in packages.places)


def _names(packages: Packages, _: str) -> str:
    return "\n".join(packages.names())


def _duplicates(packages: Packages, _: str) -> str:
    return "\n".join(map(_all_of, packages.duplicates().values()))


def _hidden(packages: Packages, name: str) -> str:
    return repr(packages.hidden(name))


def _is_hidden(packages: Packages, directory: str) -> str:
    return repr(packages.is_hidden(directory))


def _resource(packages: Packages, about: str) -> str:
    directory, _, path = about.partition("\0")
    return packages.resolve_resource(directory, path)


def _repository(_: Packages, directory: str) -> str:
    root = repository_root(directory)
    return repr((root, os.path.exists(os.path.join(root, ".git"))))


_ANSWERS: dict[str, Callable[[Packages, str], str]] = {
    "get": _get,
    "of": _of,
    "all": _all,
    "names": _names,
    "duplicates": _duplicates,
    "hidden": _hidden,
    "is-hidden": _is_hidden,
    "resource": _resource,
    "repository": _repository,
}
