"""What a dialect is: all that is done with its launch files in a way of its own, in one record."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.evaluate.assemble import Evaluation
    from launchlint.evaluate.session import Read, Session
    from launchlint.model import DialectName
    from launchlint.problem import Problem
    from launchlint.syntax.remarks import Remark
    from launchlint.syntax.tree import Document

    Pairs: TypeAlias = tuple[tuple[str, str], ...]


class Dialect(NamedTuple):
    """One dialect. The functions import what they need when they are called: a check of one dialect does not load the other.

    ``title``: what people call it (``ROS 1``). ``launcher``: the command that starts its files, and the subject of messages.

    ``parse(session, file)``: the file as it is written, read once in a session; the failed ``Read`` where it cannot be read.
    ``validate(document)``: what is wrong with it as it is written, whoever includes it, in order.
    ``evaluate(session, file, given)``: what it starts with these args. ``configurations``: the same in every configuration that matters,
    the one that is given first. Neither raises, whatever the file holds.
    ``remarks(document)``: its comments, each with what it stands before.
    ``difference(before, after, file)``: of a file in two sessions, what would be done differently, where that can be told from what it
    describes; None where only its evaluation shows it. ``reads_ahead``: a file is read to its end before anything of it is
    executed, so that a condition saves nobody from a mistake under it.
    """

    name: DialectName
    title: str
    launcher: str
    parse: Callable[[Session, str], Document | Read]
    validate: Callable[[Document], Iterator[Problem]]
    evaluate: Callable[[Session, str, Pairs], Evaluation]
    configurations: Callable[[Session, str, Pairs], Iterator[Evaluation]]
    remarks: Callable[[Document], list[Remark]]
    difference: Callable[[Session, Session, str], str] | None = None
    reads_ahead: bool = False
