"""Which keys of parameter files are meant for a node and do not reach it, and what a composable node makes of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from launchlint.evaluate.ros2.parameter_problems import ComponentKeyIgnored, NamedForUnnamed, NumberStaysText, ParametersForNobody
from launchlint.evaluate.ros2.rcl_files import table_of
from launchlint.evaluate.session import WRITTEN
from launchlint.named_tuple import NamedTuple
from launchlint.rcl.parameter_value import scalar
from launchlint.rcl.table import Key, Table, reaches
from launchlint.source import Origin, Place
from launchlint.spelling import closest
from launchlint.yaml.tree import STR, yaml_1_1

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.parameters import Passed, Performs
    from launchlint.problem import Problem

_MOST_KEYS = 8
_MOST_LOOKED_AT = 200
"""Keys of one file, and problems of one file for one node: more than any real file has."""


class Receiver(NamedTuple):
    """A node with what it is given; ``full_name`` None: it has the name of its ``program``, in the ``namespace``.

    ``host``: other nodes are loaded into it. ``composable``: it is one of these. ``anonymous``: its name is made up for each start.
    """

    full_name: str | None
    host: bool
    passed: tuple[Passed, ...]
    composable: bool = False
    anonymous: bool = False
    program: str = ""
    namespace: str = "/"


def for_nobody(receivers: Sequence[Receiver], asks: Performs) -> Iterator[Problem]:
    """Keys of files that are meant for a node and reach no node that is started; files in which nothing is for the node."""
    named = {each.full_name for each in receivers if each.full_name is not None}
    last_names = {name.rpartition("/")[2] for name in named}
    nameless = {given.file for each in receivers if each.full_name is None for given in each.passed}
    users: dict[str | None, set[str]] = {}
    for each in receivers:
        for given in each.passed:
            users.setdefault(given.file, set()).add(each.program or each.full_name or "")
    shared = frozenset(file for file, programs in users.items() if len(programs) > 1)
    reaching: dict[str, bool] = {}

    def reaches_any(key: str) -> bool:
        if key not in reaching:
            reaching[key] = any(reaches(key, name) for name in named)
        return reaching[key]

    for receiver in receivers:
        if receiver.full_name is None or receiver.anonymous:
            yield from _unnamed(receiver, reaches_any, asks, shared)
            continue
        for given in receiver.passed:
            if given.file is None or given.file.startswith(WRITTEN) or given.unknown or given.file in nameless or given.given is not None:
                continue
            table = table_of(given.file, asks)
            if isinstance(table, Table) and table.keys and not _of_costmaps(table):
                for problem in _of_file(table, given, receiver.full_name, last_names, reaches_any):
                    if receiver.composable:
                        problem = problem.without_wildcards()
                    if given.file in shared:
                        problem = problem.among_others()
                    # What a container is given counts for all nodes in it, those that somebody else loads as well.
                    if problem.near == "namespace" or not receiver.host:
                        yield problem


def _of_costmaps(table: Table) -> bool:
    """Whether all keys of a file are those of costmaps of nav2: nodes in the process of a server, each in a namespace with its own name
    (the constructor of ``nav2_costmap_2d::Costmap2DROS``).
    """
    names = [key.name.strip("/").split("/") for key in table.keys.values() if key.parameters]
    return bool(names) and all(len(parts) > 1 and parts[-1] == parts[-2] for parts in names)


def _unnamed(receiver: Receiver, reaches_any: _Reaches, asks: Performs, shared: frozenset[str | None]) -> Iterator[Problem]:
    """Files in which all that may be for a node stands under a name that it is not given."""
    namespace = receiver.namespace.rstrip("/")
    for given in receiver.passed:
        table = (
            None
            if given.file is None or given.file.startswith(WRITTEN) or given.unknown or given.given is not None
            else table_of(given.file, asks)
        )
        if not isinstance(table, Table) or _of_costmaps(table):
            continue
        keys = [key.name for key in table.keys.values() if key.parameters][:_MOST_LOOKED_AT]
        if not keys or any("*" in key for key in keys) or any(reaches_any(key) for key in keys):
            continue  # it may be for all, or is one file for several nodes
        fits = any(f"/{key.lstrip('/')}".rpartition("/")[0] == namespace for key in keys)
        yield NamedForUnnamed(
            origin=given.origin,
            file=given.file or "",
            program=receiver.program,
            keys=tuple(keys[:_MOST_KEYS]),
            namespace=namespace or "/",
            anonymous=receiver.anonymous,
            certain=not fits,
            shared=given.file in shared,
        )


def _of_file(table: Table, given: Passed, node: str, last_names: Iterable[str], reaches_any: _Reaches) -> Iterator[ParametersForNobody]:
    keys = [key for key in table.keys.values() if key.parameters][:_MOST_LOOKED_AT]
    name = node.rpartition("/")[2]
    reached = any(reaches(key.name, node) for key in keys)
    elsewhere = [key for key in keys if key.name.rpartition("/")[2] == name and not reaches_any(key.name)]
    if elsewhere:
        if any("*" not in key.name and reaches(key.name, node) for key in keys):
            return  # it has a key of its own: the others are for the nodes of that name of other robots
        for key in elsewhere:
            yield _nobody(key, given, node, "namespace", reached, keys)
        return
    if reached or not keys:
        return
    others = {key.name.rpartition("/")[2]: key for key in keys if "*" not in key.name and key.name.rpartition("/")[2] not in last_names}
    near = closest(name, others)
    if near is not None and not reaches_any(others[near].name):
        yield _nobody(others[near], given, node, "spelling", False, keys)
    elif not any(reaches_any(key.name) for key in keys):  # else it is one file for several nodes
        yield _nobody(None, given, node, "", False, keys)


def _nobody(key: Key | None, given: Passed, node: str, near: _Near, reached: bool, keys: Sequence[Key]) -> ParametersForNobody:
    here = (given.origin.place, f"{node} is given the file here")
    source, span = (None, None) if key is None else key.written
    known = source is not None and span is not None
    return ParametersForNobody(
        origin=Origin(Place(source, span), given.origin.step) if source is not None and span is not None else given.origin,
        related=(here,) if known else (),
        file=given.file or "",
        node=node,
        key="" if key is None else key.name,
        near=near,
        reached=reached,
        keys=tuple(each.name for each in keys[:_MOST_KEYS]),
    )


def judged_component(passed: Iterable[Passed], full_name: str, asks: Performs) -> Iterator[Problem]:
    """What a composable node does not get as it is meant: keys with wildcards, and numbers that YAML takes for texts."""
    own = full_name.lstrip("/")
    for given in passed:
        for text in given.texts:
            if not text.meant and _is_number(text.value):
                yield NumberStaysText(origin=Origin(text.place, given.origin.step), name=text.name, value=text.value, in_file=False)
        if given.file is None or given.file.startswith(WRITTEN) or given.unknown:
            continue
        table = table_of(given.file, asks)
        if not isinstance(table, Table):
            continue
        for key in list(table.keys.values())[:_MOST_LOOKED_AT]:
            source, span = key.written
            counts = key.name.lstrip("/") in ("**", own)
            if source is None:
                continue
            here = (given.origin.place, "the file is given to the node here")
            if not counts and "*" in key.name and reaches(key.name, full_name):
                origin = Origin(Place(source, span), given.origin.step)
                yield ComponentKeyIgnored(origin=origin, related=(here,), file=given.file, key=key.name, node=full_name)
            for parameter in key.parameters if counts else ():
                start, end = parameter.written.value
                written = source.text[start:end]
                if parameter.value.type == "double" and _is_number(written):
                    origin = Origin(Place(source, parameter.written.value), given.origin.step)
                    yield NumberStaysText(origin=origin, related=(here,), name=parameter.name, value=written, in_file=True)


def _is_number(text: str) -> bool:
    """Whether rcl reads a text as a number, and YAML as a text."""
    return scalar(text).type in ("int", "double") and yaml_1_1()(text) == STR


if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Literal, TypeAlias

    _Reaches: TypeAlias = Callable[[str], bool]
    _Near: TypeAlias = Literal["namespace", "spelling", ""]
