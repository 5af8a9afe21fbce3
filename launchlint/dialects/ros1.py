"""The dialect of roslaunch."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.dialects.record import Dialect
from launchlint.model import ROS1

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.dialects.record import Pairs
    from launchlint.evaluate.assemble import Evaluation
    from launchlint.evaluate.session import Read, Session
    from launchlint.problem import Problem
    from launchlint.syntax.remarks import Remark
    from launchlint.syntax.tree import Document


def _parse(session: Session, file: str) -> Document | Read:
    return session.document(file)


def _validate(document: Document) -> Iterator[Problem]:
    yield from document.problems
    if document.launch is not None:
        from launchlint.syntax.ros1.validate import validate

        yield from validate(document)


def _evaluate(session: Session, file: str, given: Pairs) -> Evaluation:
    from launchlint.evaluate.ros1.launch import evaluate

    return evaluate(session, file, given)


def _configurations(session: Session, file: str, given: Pairs) -> Iterator[Evaluation]:
    from launchlint.evaluate.configurations import configurations

    return configurations(session, file, given)


def _remarks(document: Document) -> list[Remark]:
    from launchlint.syntax.remarks import remarks

    return remarks(document)


DIALECT = Dialect(ROS1, "ROS 1", "roslaunch", _parse, _validate, _evaluate, _configurations, _remarks)
