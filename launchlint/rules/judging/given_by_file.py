"""Inputs that a node does not need as it is started: it reads from a file what another one would publish."""

from __future__ import annotations

from launchlint.graph.connections import Endpoint, Instance
from launchlint.graph.parameters import Parameters
from launchlint.late import late
from launchlint.library.template import UNKNOWN
from launchlint.rules.judging.name_places import Owners

_WORDS = late(r"[^/:._~]+")
_SWITCHES = frozenset(("use", "load", "read"))
_FILES = frozenset(("dir", "directory", "file", "filename", "filepath", "folder", "path", "uri", "url", "yaml"))
_MOST_PARAMS = 500


class ToBeMet:
    """Whether somebody is to be at the other end of a name: it is certainly there, belongs to no action, and no file stands for it.

    It is worked out once for each end of one graph, whose nodes have these ``parameters``.
    """

    def __init__(self, owners: Owners, parameters: Parameters) -> None:
        self._owners = owners
        self._parameters = parameters
        self._known: dict[int, bool] = {}

    def __call__(self, end: Endpoint) -> bool:
        """The answer for one end of that graph, which stays alive meanwhile."""
        if id(end) not in self._known:
            given = not end.certain or end.action or is_given_by_file(end, self._owners[id(end)], self._parameters)
            self._known[id(end)] = not given
        return self._known[id(end)]


def is_given_by_file(end: Endpoint, instance: Instance, parameters: Parameters) -> bool:
    """Whether params of the node switch on a file for what it would hear: ``use_pcd_map: true`` beside a ``map_path`` for ``map``.

    The names of both have all words of that of the topic. That is a habit of names, no rule of ROS, and so it silences only.
    """
    if end.role != "subscriber":
        return False
    wanted = set(_WORDS.findall(end.declared.rpartition("/")[2].casefold()))
    switched = filed = False
    for name in parameters.below(instance.name)[:_MOST_PARAMS]:
        words = _WORDS.findall(name[len(instance.name) :].casefold())
        if not wanted or not wanted.issubset(words):
            continue
        if not switched and words[0] in _SWITCHES:
            switched = _is_on(parameters.value(name))
        elif not filed and not _FILES.isdisjoint(words):
            filed = _is_text(parameters.value(name))
    return switched and filed


def _is_on(value: object) -> bool:
    return value is True or value is UNKNOWN


def _is_text(value: object) -> bool:
    return value is UNKNOWN or (isinstance(value, str) and bool(value.strip()))
