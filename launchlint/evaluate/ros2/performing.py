"""Texts to strings, at the moment at which an action is executed (launch.utilities.perform_substitutions)."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from launchlint.evaluate.ros2.context import Context, Setting, Value
from launchlint.late import late
from launchlint.model import StandIn, Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import Origin, Place, Source
from launchlint.syntax.ros2.description import Substitution, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn

    from launchlint.evaluate.session import Session
    from launchlint.syntax.ros2.live import LiveContext

_SEVERAL = late(r"\*{2,}")
_TRUE = re.compile(r"yes|Yes|YES|true|True|TRUE|on|On|ON")
_FALSE = re.compile(r"no|No|NO|false|False|FALSE|off|Off|OFF")


class Failure(Exception):
    """launch stops here, for this reason."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.problem = problem


SHARE = "find-pkg-share"
"""What stands for the directory that a package is installed to: here for that of its sources, which may be laid out otherwise."""

Perform = Callable[["Performer", Substitution], Value]
"""What is put in place of one substitution. Raises Failure."""


class Rules(NamedTuple):
    """What a distribution does differently when substitutions are performed.

    ``digits_are_boolean``: ``1`` and ``0`` are truth values wherever launch asks for one; ``modules``: those that ``$(eval …)`` knows by
    name.     ``loads_by_condition``: the conditions of what ``<load_composable_node>`` loads count. ``tags_count``: rcl looks at
    tags such as ``!!str`` in parameter files.
    """

    distro: str
    digits_are_boolean: bool
    modules: tuple[str, ...]
    loads_by_condition: bool
    tags_count: bool


_RECENT = Rules("", True, ("math",), True, True)
_RULES = {"humble": Rules("humble", False, (), False, False)}


def rules_of(distro: str) -> Rules:
    """The rules of a distribution; those that are not known do as the newest one does."""
    return _RULES.get(distro, _RECENT._replace(distro=distro))


class Performer:
    """Performs the texts of one evaluation in its context.

    ``steer`` and ``outside`` collect what the texts performed since they were emptied depend on: configurations that can be given another
    value, and whether an environment variable is read. ``where`` makes an origin of a place, ``spend`` counts characters, ``notice`` takes
    what is worth knowing and keeps nothing from going on. ``table`` says what is put in place of each substitution.
    ``containers`` are the full names of those that were executed, each with its place.
    ``compared`` collects what launch configurations that can be given from outside are compared with, each with its name. ``way`` leads to
    the file that is executed; ``live`` gives programs the context at the moment, where there is a launch.
    ``foreign`` collects what files read that was set outside of them: file and name, with place and setting.
    """

    __slots__ = (
        "anonymous",
        "compared",
        "containers",
        "context",
        "entry",
        "foreign",
        "live",
        "notice",
        "outside",
        "rules",
        "session",
        "spend",
        "steer",
        "table",
        "way",
        "where",
    )

    def __init__(
        self,
        session: Session,
        context: Context,
        entry: str,
        rules: Rules,
        where: Callable[[Place], Origin],
        spend: Callable[[int, Place], None],
        notice: Callable[[Problem], None],
        table: Mapping[str, Perform],
    ) -> None:
        self.session = session
        self.context = context
        self.entry = entry
        self.rules = rules
        self.where = where
        self.spend = spend
        self.notice = notice
        self.table = table
        self.anonymous = 0
        self.compared: list[tuple[str, tuple[str, ...]]] = []
        self.containers: list[tuple[tuple[str, int], Value]] = []
        self.steer: set[str] = set()
        self.outside = False
        self.live: Callable[[Place], LiveContext] | None = None
        self.way: tuple[int, ...] = ()
        self.foreign: list[tuple[tuple[int, ...], str, Origin, Setting]] = []

    def perform(self, text: Text) -> Value:
        """The string that a text stands for now. Raises Failure where launch stops."""
        pieces = text.pieces
        if len(pieces) == 1:
            piece = pieces[0]
            value: Value = piece if isinstance(piece, str) else self.substitute(piece)
            if isinstance(value, str) and len(value) > 100:
                self.spend(len(value), text.place)
            return value
        if not pieces:
            return ""
        whole = joined([piece if isinstance(piece, str) else self.substitute(piece) for piece in pieces], text.place, self.spend)
        first = pieces[0]
        if isinstance(whole, str) and isinstance(first, Substitution) and first.name == SHARE:
            return self.session.placed(whole)
        return whole

    def substitute(self, substitution: Substitution) -> Value:
        """What is put in place of one substitution. Raises Failure."""
        perform = self.table.get(substitution.name)
        if perform is None:  # what it is called has been told when the file was read
            return Unknown(substitution.written, f"{substitution.name} is not a substitution")
        return perform(self, substitution)

    @property
    def digits_are_boolean(self) -> bool:
        """Whether ``1`` and ``0`` are truth values wherever launch asks for one."""
        return self.rules.digits_are_boolean

    @property
    def tags_count(self) -> bool:
        """Whether rcl looks at tags in parameter files."""
        return self.rules.tags_count

    def perform_content(self, source: Source) -> Value:
        """A file with all substitutions in it performed. Raises Failure."""
        kept = self.session.loaded
        name = f"text {source.file}"
        if name not in kept:
            kept[name] = self._parsed(source)
        text, problem = kept[name]
        if problem is not None:
            raise Failure(problem.but(origin=self.where(problem.place)))
        value: Value = self.perform(text)
        return value

    def _parsed(self, source: Source) -> tuple[Text, Problem | None]:
        """The pieces of a file, and the first reason why launch refuses it, if it does."""
        from launchlint.syntax.ros2.substitutions import parse
        from launchlint.syntax.ros2.tables import Distribution
        from launchlint.syntax.ros2.written import InText

        problems: list[Problem] = []
        text = parse(InText(source), Distribution(self.rules.distro), problems)
        return text, problems[0] if problems else None

    def fail(self, problem: Problem) -> NoReturn:
        """Stop, as launch does: raises Failure."""
        raise Failure(problem)

    def boolean(self, text: str) -> bool | None:
        """What YAML takes a string for where launch wants a truth value; None where it is none (launch.utilities.type_utils)."""
        text = text.strip() if text not in ("1", "0") else {"1": "true", "0": "false"}[text] if self.rules.digits_are_boolean else text
        return True if _TRUE.fullmatch(text) else False if _FALSE.fullmatch(text) else None


def joined(values: list[Value], place: Place, spend: Callable[[int, Place], None]) -> Value:
    """Values in a row as one; unknown where one of them is."""
    unknown: Unknown | None = None
    for value in values:
        if not isinstance(value, str):
            unknown = unknown or value
    texts = [value if isinstance(value, str) else value.text for value in values]
    text = "".join(texts)
    if len(text) > 100:
        spend(len(text), place)
    if unknown is None:
        return text
    if all(isinstance(value, (str, StandIn)) for value in values):
        return StandIn(
            text, unknown.reason, _SEVERAL.sub("*", "".join(value if isinstance(value, str) else value.pattern for value in values))
        )
    pattern = "".join(value if isinstance(value, str) else value.pattern for value in values)
    return Unknown(text, unknown.reason, _SEVERAL.sub("*", pattern))
