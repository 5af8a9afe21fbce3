"""What a client library of ROS offers to programs: which objects, functions and members make names, and which words tell of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import Handle, Thing, Value
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call
    from launchlint.extract.cpp.machine import Machine
    from launchlint.extract.cpp.ros.models import Model


class Tables(NamedTuple):
    """One client library.

    Args:
        makers: classes whose objects are made here even where their sources are given, and what making one does.
        standins: likewise, of classes that are followed like others where their sources are given.
        methods: members of objects, by class and name.
        functions: by full name.
        of_handle: members of a node handle, or of a node.
        of_object: members that an object of the program has from a base class of ROS, beside those of the node that it is; None as an
            answer: it has no such member.
        models: what objects of other classes make, in words. ``bases``: likewise, of base classes.
        values: names of constants.
        harmless: classes that may be given a node handle and make no name with it.
        categories: members of a node handle that tell, and the category of what they make.
        bare: classes whose members tell something even where their constructor was not seen.
        words: words of functions that may have to do with names; ``silent_words`` are those of them that make no name by themselves.
        qualified: functions that make names, and whose words mean nothing without the namespace in front: ``param::get``.
        spaces: how namespaces begin whose functions may be called without them.
        owners: of words that other libraries have, too: the namespaces in front of which they count (``rclcpp::Node``, not ``YAML::Node``).
        is_handle: whether a variable of a type is a node handle, or a node.
        running: conditions that hold as long as the program runs.
        follow: follows what others call of an object that is a node, when the program has come to its end.
        each: each value of what may be a param that holds a list; UNKNOWN where it is none.
    """

    makers: Mapping[str, Callable[[Call], Value]]
    standins: Mapping[str, Callable[[Call], Value]]
    methods: Mapping[tuple[str, str], Callable[[Thing, Call], Value]]
    functions: Mapping[str, Callable[[Call], Value | None]]
    of_handle: Mapping[str, Callable[[Handle, Call], Value]]
    of_object: Callable[[Thing, Call], Value | None]
    models: Mapping[str, Model]
    bases: Mapping[str, Model]
    values: Mapping[str, Callable[[], Value]]
    harmless: frozenset[str]
    categories: Mapping[str, str]
    bare: frozenset[str]
    words: frozenset[str]
    silent_words: frozenset[str]
    qualified: tuple[str, ...]
    spaces: tuple[str, ...]
    owners: Mapping[str, frozenset[str]]
    is_handle: Callable[[Type], bool]
    running: frozenset[str]
    follow: Callable[[Machine, Thing], None]
    each: Callable[[Value], Value]

    def known(self, name: str) -> bool:
        """Whether objects of a class are known to make names, or not to."""
        return name in self.makers or name in self.standins or name in self.models


def last_words(*tables: Mapping[str, object]) -> frozenset[str]:
    """The last parts of the names of classes of ROS."""
    return frozenset(
        name.rpartition("::")[2] for table in tables for name in table if "::" in name and not name.startswith(("std::", "boost::"))
    )
