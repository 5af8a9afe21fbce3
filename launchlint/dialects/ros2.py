"""The dialect of ``ros2 launch``: launch files in XML, YAML and Python."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.dialects.record import Dialect
from launchlint.model import ROS2
from launchlint.workspace.discovery import is_program

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.dialects.record import Pairs
    from launchlint.evaluate.assemble import Evaluation
    from launchlint.evaluate.session import Read, Session
    from launchlint.problem import Problem
    from launchlint.syntax.remarks import Remark
    from launchlint.syntax.ros2.reading import Reading
    from launchlint.syntax.tree import Document


def _parse(session: Session, file: str) -> Document | Read:
    from launchlint.evaluate.session import Read

    reading = session.reading(file)
    return reading if isinstance(reading, Read) else session.once(reading, _document)


def _document(reading: Reading) -> Document:
    """The file as a tree, with what is wrong with it; of YAML there is no tree, only the text."""
    from launchlint.syntax.tree import Document

    document = Document(reading.source) if reading.document is None else reading.document
    return document.telling(reading.problems, reading.description)


def _validate(document: Document) -> Iterator[Problem]:
    yield from document.problems


def _evaluate(session: Session, file: str, given: Pairs) -> Evaluation:
    from launchlint.evaluate.ros2.launch import evaluate

    return _with_documents(session, evaluate(session, file, given))


def _configurations(session: Session, file: str, given: Pairs) -> Iterator[Evaluation]:
    from launchlint.evaluate.configurations import configurations
    from launchlint.evaluate.ros2.arg_flow import ros2_launch

    return (_with_documents(session, each) for each in configurations(session, file, given, ros2_launch()))


def _with_documents(session: Session, evaluation: Evaluation) -> Evaluation:
    """The same with every file that was read, those in YAML too."""
    from launchlint.evaluate.session import Read

    read = (session.reading(file) for file in dict.fromkeys(evaluation.launch.files))
    documents = (session.once(each, _document) for each in read if not isinstance(each, Read))
    return evaluation._replace(documents={each.source.path: each for each in documents})


def _remarks(document: Document) -> list[Remark]:
    if document.root is not None:
        from launchlint.syntax.remarks import remarks

        return remarks(document)
    if is_program(document.source.file, document.source.text.encode("utf-8", "replace")):
        from launchlint.syntax.ros2.python.remarks import remarks as python_remarks

        return python_remarks(document.source)
    from launchlint.syntax.yaml_remarks import remarks as yaml_remarks

    return yaml_remarks(document.source)


def _difference(before: Session, after: Session, file: str) -> str:
    from launchlint.evaluate.session import Read
    from launchlint.syntax.ros2.same import difference

    old, new = before.reading(file), after.reading(file)
    if isinstance(old, Read) or isinstance(new, Read):
        return "it cannot be read"
    return difference(old, new)


DIALECT = Dialect(ROS2, "ROS 2", "ros2 launch", _parse, _validate, _evaluate, _configurations, _remarks, _difference, reads_ahead=True)
