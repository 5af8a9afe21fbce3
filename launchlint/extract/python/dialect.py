"""What differs between programs of rospy and of rclpy, as tables: the machinery that follows them is the same."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from launchlint.extract.python.arguments import Call
from launchlint.named_tuple import NamedTuple
from launchlint.python.values import Handle, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.python.models import Model

Handler = Callable[[Call], Value]
Method = Callable[[Handle, Call], Value]


class Dialect(NamedTuple):
    """The client library of one middleware, with the packages around it.

    Args:
        handlers: what is recognised when it is called, by its full name.
        methods: of the objects that recognised calls make: (kind, name of the method).
        making: the last words of calls that make or ask for names.
        modules: modules that matter when they are given to code that is not known.
        never_followed: packages that stay outside even where their source is at hand.
        talking: packages that tell that a program has to do with ROS.
        silent: packages that make no names but those that are recognised.
        calls_back: how full names begin of what calls the functions that it is given when there is a message.
        canonical: one name for what modules give out under several.
        type_of: the type that a message, service or action class stands for; empty where it is not known.
        spelled: the name that a value makes in a category, as the library format spells it.
        model_of: what is known of calling something outside as a table.
    """

    handlers: Mapping[str, Handler]
    methods: Mapping[tuple[str, str], Method]
    making: frozenset[str]
    modules: frozenset[str]
    never_followed: frozenset[str]
    talking: frozenset[str]
    silent: frozenset[str]
    calls_back: tuple[str, ...]
    canonical: Callable[[str], str]
    type_of: Callable[[Value], str]
    spelled: Callable[[Value, str], str]
    model_of: Callable[[str], Model | None]
