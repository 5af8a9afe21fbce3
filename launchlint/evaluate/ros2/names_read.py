"""Which launch configurations a ROS 2 launch file can read, as it is written: whatever its conditions say."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Description, Substitution
from launchlint.syntax.ros2.loops import is_loop

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

LATER = 1 << 60
"""An offset behind everything: what is executed when the rest of the launch has been."""
OF_LAUNCH = frozenset(
    (
        "emulate_tty",
        "launch-prefix",
        "launch-prefix-filter",
        "sigterm_timeout",
        "sigkill_timeout",
        "ros_namespace",
        "ros_remaps",
        "global_params",
    )
)
"""Those that launch and launch_ros read themselves, whoever sets them."""
_OPEN = ("file-content", described.NOT_KNOWN, described.CALLED)
# Not the grammar of substitutions: for texts that could not be parsed, in which whatever looks like a read is one.
_READ = late(r"\$\(var ['\"]?([^\s()'\"$]+)")
_INCLUDED = late(r"<include\b|(?<![\w-])include['\"]?\s*:")


class Names(NamedTuple):
    """The configurations of one file, each with the last offset at which it is read (``read``) or declared as an arg (``declared``).

    ``open``: it may read others, too. ``arguments`` and ``includes`` are all of them, wherever they stand;
    ``alone``: there is nothing else. ``set`` are those that a ``<let>`` sets.
    """

    read: Mapping[str, int]
    declared: Mapping[str, int]
    arguments: tuple[described.Argument, ...]
    includes: tuple[described.Include, ...]
    open: bool
    alone: bool
    set: frozenset[str] = frozenset()

    def last(self, name: str) -> int:
        """The last offset at which the file reads or declares ``name``, -1 where it does not."""
        return max(self.read.get(name, -1), self.declared.get(name, -1))


def names_of(description: Description) -> Names:
    """What a file reads (``$(var …)``), declares and includes."""
    read: dict[str, int] = {}
    declared: dict[str, int] = {}
    arguments: list[described.Argument] = []
    includes: list[described.Include] = []
    lets: set[str] = set()
    is_open = False
    whenever = description.place.source.file.endswith(".py")  # where a program makes its actions is not when they are executed
    for each, deferred in parts_of(description.actions):
        later = deferred or whenever
        if isinstance(each, Substitution):
            name = each.arguments[0].literal if each.arguments else None
            if each.name == "var" and name is not None:
                at = LATER if later else each.place.span.start
                read[name] = max(read.get(name, -1), at)
            is_open = is_open or each.name in _OPEN or (each.name == "var" and name is None)
        elif isinstance(each, described.Condition) and each.kind in ("equals", "not-equals"):
            read.update({name: LATER for name in (each.operands[0].literal,) if name is not None})
        elif isinstance(each, described.Argument):
            declared[each.name] = max(declared.get(each.name, -1), LATER if later else each.place.span.start)
            arguments.append(each)
        elif isinstance(each, described.Include):
            includes.append(each)
        elif isinstance(each, described.ParameterFile):
            is_open = is_open or each.allow_substs is not False
        elif isinstance(each, described.Open) or _is_called(each):
            is_open = True
        elif isinstance(each, described.Let) and each.name.literal is not None:
            lets.add(each.name.literal)
    return Names(
        read,
        declared,
        tuple(arguments),
        tuple(includes),
        is_open,
        all(isinstance(each, described.Argument) for each in description.actions),
        frozenset(lets),
    )


def _is_called(each: object) -> bool:
    """Whether it is a function of a program that gives actions: what is in a loop of XML or YAML can be seen."""
    if isinstance(each, described.Opaque):
        return not is_loop(each)
    return isinstance(each, described.Handler) and not isinstance(each.actions, tuple)


def parts_of(part: tuple[Any, ...]) -> Iterator[tuple[Any, bool]]:
    """All parts of a description or text that are no places and no plain values, each with whether it is executed later."""
    waiting: list[tuple[Any, bool]] = [(part, False)]
    while waiting:
        each, later = waiting.pop()
        if isinstance(each, Place) or not isinstance(each, tuple):
            continue
        yield each, later
        later = later or isinstance(each, (described.Timer, described.Handler))
        waiting.extend((inner, later) for inner in reversed(each))


def names_of_refused(description: Description) -> Names:
    """The same for a file that launch refuses: what could not be understood is in its text only."""
    names, text = names_of(description), description.place.source.text
    return names._replace(
        read={**dict.fromkeys(_READ.findall(text), LATER), **names.read},
        open=names.open or len(_INCLUDED.findall(text)) > len(names.includes),
    )
