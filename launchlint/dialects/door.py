"""The door: which dialect a launch file is in, and what it starts in that."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.dialects.record import Dialect
from launchlint.dialects.ros1 import DIALECT as ROS1_DIALECT

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.dialects.record import Pairs
    from launchlint.evaluate.assemble import Evaluation
    from launchlint.evaluate.session import Session
    from launchlint.model import DialectName


def named(name: DialectName) -> Dialect:
    """The dialect of this name."""
    return ROS1_DIALECT


def dialect_of(session: Session, file: str) -> Dialect:
    """The dialect of an entry file."""
    return ROS1_DIALECT


def evaluate(session: Session, file: str, given: Pairs = ()) -> Evaluation:
    """What its launcher would start for an entry file with the args ``given``. Never raises for anything the file holds."""
    return dialect_of(session, file).evaluate(session, file, given)


def configurations(session: Session, file: str, given: Pairs = ()) -> Iterator[Evaluation]:
    """As :func:`evaluate`, in every configuration that matters: first as given, then what shows something new."""
    return dialect_of(session, file).configurations(session, file, given)
