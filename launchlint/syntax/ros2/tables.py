"""The tags of ROS 2 launch files as data: what launch reads of each, in the order in which it reads it, and since which distribution.

The order matters: launch stops at the first thing that is wrong, and reads one entity to its end before it complains of what it did not
read. Source: the ``parse`` methods of launch 1.0 to 3.7 and launch_ros 0.19 to 0.28; of loops that of launch 3.8.
"""

from __future__ import annotations

from enum import Enum
from functools import lru_cache

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal, TypeAlias

DISTRIBUTIONS = ("humble", "jazzy", "kilted", "rolling")
"""Those that the tables tell apart, oldest first."""

OPEN = ("kilted", "rolling")
"""Those that had not their last features yet when the tables were read."""

BACKPORTED = ("on_exit",)
"""What later updates brought to older distributions."""

DEFAULT = "jazzy"
"""The newest distribution with long-term support."""

LATER = "later"
"""Newer than the distributions that the tables know."""


class Kind(Enum):
    """What the value of an attribute becomes."""

    TEXT = "text with substitutions"
    WORD = "text; what looks like a substitution stays as it is"
    COMMAND = "words of a command line"
    FLAG = "true or false; launch takes any other text, a substitution too, for true"
    FLAG_OR_TEXT = "true or false, or a substitution"
    INTEGER = "a whole number"
    SECONDS = "a number that is not negative"
    PERIOD = "a number, or a substitution"
    SHUTDOWN = "shutdown"


class Attribute(NamedTuple):
    """One attribute. ``since`` is the first distribution that has it, where not all have."""

    name: str
    kind: Kind = Kind.TEXT
    required: bool = False
    since: str = ""


class Conditions(NamedTuple):
    """``if`` and ``unless``, of which one may stand."""


class Children(NamedTuple):
    """Inner tags with a name of their own; in YAML, a key with a list of mappings.

    ``checked`` says when launch looks for what it did not read of them: right after each, after all of them, or never.
    """

    name: str
    reads: tuple[Read, ...]
    required: bool = False
    checked: Literal["each", "all", "never"] = "all"


class Parameters(NamedTuple):
    """The ``<param>`` children."""


class Actions(NamedTuple):
    """The children are actions, except those that were read by their name before."""


Read: TypeAlias = "Attribute | Conditions | Children | Parameters | Actions"


class Tag(NamedTuple):
    """One tag: what is read of it, in this order. ``needs`` are attributes without which the action cannot be made once all is read."""

    name: str
    reads: tuple[Read, ...]
    since: str = ""
    needs: tuple[str, ...] = ()


def _must(name: str, kind: Kind = Kind.TEXT) -> Attribute:
    return Attribute(name, kind, required=True)


_IF = Conditions()
_NAME, _VALUE = _must("name"), _must("value")
_REMAP = (_must("from"), _must("to"))
_JAZZY = "jazzy"
_KILTED = "kilted"

_PROCESS: tuple[Read, ...] = (
    Attribute("cwd"),
    Attribute("name"),
    Attribute("on_exit", Kind.SHUTDOWN, since=_JAZZY),
    Attribute("launch-prefix"),
    Attribute("output"),
    Attribute("respawn"),
    Attribute("respawn_max_retries", Kind.INTEGER, since=_JAZZY),
    Attribute("respawn_delay", Kind.SECONDS),
    Attribute("sigkill_timeout", Kind.SECONDS, since=_JAZZY),
    Attribute("sigterm_timeout", Kind.SECONDS, since=_JAZZY),
    Attribute("shell", Kind.FLAG),
    Attribute("emulate_tty", Kind.FLAG, since=_JAZZY),
    Children("env", (_NAME, _VALUE)),
)

_NODE: tuple[Read, ...] = (
    _IF,
    *_PROCESS,
    Attribute("args", Kind.COMMAND),
    Attribute("ros_args", Kind.COMMAND),
    Attribute("exec_name"),
    Attribute("pkg"),
    _must("exec"),
    Attribute("namespace"),
    Children("remap", _REMAP),
    Parameters(),
)

_COMPONENT = Children(
    "composable_node",
    (
        _must("pkg"),
        _must("plugin"),
        _NAME,
        _IF,
        Attribute("namespace"),
        Parameters(),
        Children("remap", _REMAP),
        Children("extra_arg", (_NAME, _VALUE)),
    ),
    checked="each",
)

_KEEP = Children("keep", (_NAME, _VALUE))

_TAGS = (
    Tag(
        "arg",
        (
            _IF,
            _must("name", Kind.WORD),
            Attribute("default"),
            Attribute("description", Kind.WORD),
            Children("choice", (_must("value", Kind.WORD),), checked="never"),
        ),
    ),
    Tag("let", (_NAME, _VALUE, _IF)),
    Tag("include", (_IF, _must("file"), Children("arg", (_NAME, _VALUE)))),
    Tag("group", (_IF, Attribute("scoped", Kind.FLAG), Attribute("forwarding", Kind.FLAG), _KEEP, Actions())),
    Tag("executable", (_IF, _must("cmd", Kind.COMMAND), *_PROCESS)),
    Tag("node", _NODE),
    Tag("node_container", (*_NODE, _COMPONENT), needs=("name", "namespace")),
    Tag("load_composable_node", (_IF, _must("target"), _COMPONENT._replace(required=True))),
    Tag("push_ros_namespace", (_IF, _must("namespace"))),
    Tag("push-ros-namespace", (_IF, _must("namespace"))),
    Tag("set_remap", (_IF, *_REMAP)),
    Tag("set_parameter", (_IF, _NAME, _VALUE)),
    Tag("set_parameters_from_file", (_IF, _must("filename"))),
    Tag("set_use_sim_time", (_IF, _VALUE)),
    Tag("set_env", (_IF, _NAME, _VALUE)),
    Tag("unset_env", (_IF, _NAME)),
    Tag("append_env", (_IF, _NAME, _VALUE, Attribute("prepend", Kind.FLAG_OR_TEXT), Attribute("separator"))),
    Tag("reset_env", (_IF,)),
    Tag("reset", (_IF, _KEEP)),
    Tag("set_ros_log_dir", (_IF, _must("new_log_dir")), since=_JAZZY),
    Tag("log", (_IF, _must("message"))),
    Tag("shutdown", (_IF, Attribute("reason"))),
    Tag("timer", (_IF, _must("period", Kind.PERIOD), Actions(), Attribute("cancel_on_shutdown", Kind.FLAG_OR_TEXT))),
    Tag("ros_timer", (_IF, _must("period", Kind.PERIOD), Actions())),
    Tag("for", (_IF, _must("name", Kind.WORD), Actions(), _must("len")), since=_KILTED),
    Tag("for_each", (_IF, Actions(), _must("values")), since=_KILTED),
    *(Tag(name, (), since=LATER) for name in ("lifecycle_node", "log_debug", "log_info", "log_warning", "log_error")),
)

TAGS = {tag.name: tag for tag in _TAGS}
"""Every action."""

PARAMETER = ("name", "value", "type", "from", "allow_substs")
"""The attributes of ``<param>``; launch reads ``from``, ``allow_substs`` and ``name`` before the rest."""

PARAMETER_TYPES = ("str", "bool", "int", "float", "list_of_str", "list_of_bool", "list_of_float", "list_of_int", "yaml")
"""What ``type`` of a ``<param>`` takes."""


class Arity(NamedTuple):
    """How many words a substitution takes after its name; ``most`` holds for distributions from ``since`` on, before that ``before``.

    ``broken``: the front ends cannot make it (launch has it for Python only).
    """

    fewest: int
    most: int
    since: str = ""
    before: int | None = None
    broken: bool = False


_NONE, _ONE, _TWO, _ONE_OR_TWO = Arity(0, 0), Arity(1, 1), Arity(2, 2), Arity(1, 2)
_SECOND_SINCE_JAZZY = Arity(1, 2, _JAZZY, before=1)
_UNKNOWN = Arity(0, 1_000_000, LATER)

SUBSTITUTIONS = {
    "var": _ONE_OR_TWO,
    "env": _ONE_OR_TWO,
    "find-pkg-share": _ONE,
    "find-pkg-prefix": _ONE,
    "exec-in-pkg": _TWO,
    "find-exec": _ONE,
    "param": _SECOND_SINCE_JAZZY,
    "command": _ONE_OR_TWO,
    "eval": _SECOND_SINCE_JAZZY,
    "dirname": _NONE,
    "filename": _NONE,
    "log_dir": _NONE,
    "anon": _ONE,
    "not": _ONE,
    "and": _TWO,
    "or": _TWO,
    "if": Arity(2, 3, _JAZZY),
    "equals": Arity(2, 2, _JAZZY),
    "not-equals": Arity(2, 2, _JAZZY),
    "file-content": Arity(1, 1, _JAZZY),
    "launch_log_dir": Arity(0, 0, _JAZZY),
    "any": Arity(0, 1_000_000, _JAZZY, broken=True),
    "all": Arity(0, 1_000_000, _JAZZY, broken=True),
    "for-var": Arity(1, 2, _KILTED),
    "index": Arity(1, 2, _KILTED),
    "string-join": _UNKNOWN,
    "path-join": _UNKNOWN,
}
"""The substitutions by name."""


class Distribution:
    """One distribution's view of the tables."""

    __slots__ = ("digits_are_flags", "name", "substitutions", "tags")

    def __init__(self, name: str) -> None:
        self.name = name if name in DISTRIBUTIONS else DEFAULT
        self.tags = {each.name: self._of(each) for each in _TAGS if self.has(each.since)}
        self.substitutions = {name: arity for name, arity in SUBSTITUTIONS.items() if arity.before is not None or self.has(arity.since)}
        self.digits_are_flags = self.has(_JAZZY)
        """Whether 1 and 0 stand for true and false where a flag is wanted."""

    def has(self, since: str) -> bool:
        """Whether this one has what came with ``since``."""
        return not since or (since != LATER and DISTRIBUTIONS.index(since) <= DISTRIBUTIONS.index(self.name))

    def lacks_for_sure(self, name: str, since: str) -> bool:
        """Whether no update of it can have brought ``name``, which came with ``since``."""
        return name not in BACKPORTED and not (since == LATER and self.name in OPEN)

    def most(self, arity: Arity) -> int:
        """The most words that a substitution takes."""
        return arity.most if arity.before is None or self.has(arity.since) else arity.before

    def _of(self, tag: Tag) -> Tag:
        return tag._replace(reads=tuple(each for each in tag.reads if not isinstance(each, Attribute) or self.has(each.since)))


@lru_cache(maxsize=8)
def distribution(name: str) -> Distribution:
    """The tables as the distribution of this name has them; those of the default one for a name that nobody knows."""
    return Distribution(name)
