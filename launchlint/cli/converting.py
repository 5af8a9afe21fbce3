"""``launchlint export --to``: a launch file in another language of ROS 2."""

from __future__ import annotations

import sys

from launchlint.cli.entries import tell
from launchlint.errors import UsageError
from launchlint.project.asked import EntryOptions

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from launchlint.check.entry import EntryChecker
    from launchlint.check.options import EntryRequest
    from launchlint.export.ros2.converting import Converted
    from launchlint.fix.format.style import Style
    from launchlint.source import Place


def convert(
    entry: EntryOptions, overlay: Mapping[str, bytes], request: EntryRequest, language: str, from_: str | None, to: str
) -> Converted | None:
    """What is to be written for the file of ``request``; None where it cannot be, which has been told on standard error."""
    from launchlint.check.entry import EntryChecker
    from launchlint.export.written import CannotExport
    from launchlint.fix.format.style import Style
    from launchlint.rules.registry import RULES

    about_reading = frozenset(rule.id for rule in RULES if rule.view == "problem")
    checker = EntryChecker(entry.options(everything=True)._replace(rules=about_reading, default_only=True), overlay)
    file = request.at
    style = Style(entry.configuration.line_width, entry.configuration.indent, entry.configuration.sort_attributes)
    try:
        if _of_ros1(checker, request, from_, to):
            return _translated(checker, request, style, language)
        return _converted(checker, request, style, language)
    except CannotExport as error:
        tell(f"{file} is not converted, and nothing is written: {error.reason}")
        return None


def _of_ros1(checker: EntryChecker, request: EntryRequest, from_: str | None, to: str) -> bool:
    from launchlint.dialects.door import dialect_of
    from launchlint.model import ROS1

    if from_ is not None:
        return from_ == ROS1
    of_ros1 = dialect_of(checker.session_for(request), request.at).name == ROS1
    if of_ros1 and to != "ros2":
        raise UsageError(f"{request.at} is a launch file of ROS 1; say --from ros1 to have it translated")
    return of_ros1


def _converted(checker: EntryChecker, request: EntryRequest, style: Style, language: str) -> Converted | None:
    """As :func:`convert`, of a file of ROS 2. Raises CannotExport."""
    from launchlint.evaluate.session import Read
    from launchlint.export.ros2.converting import convert as converted

    session = checker.session_for(request)
    reading = session.reading(request.at)
    if isinstance(reading, Read) or reading.refusal is not None:
        _tell_refusal(checker, request)
        return None
    result = converted(session, request.at, request.arguments, style, language)
    for line in (*told(result.lost, "not carried over: "), *told(result.remarks, "look at this: ")):
        tell(line)
    return result


def _translated(checker: EntryChecker, request: EntryRequest, style: Style, language: str) -> Converted | None:
    """As :func:`convert`, of a file of ROS 1. Raises CannotExport."""
    from launchlint.evaluate.session import Read
    from launchlint.export.from_ros1.converting import convert as converted

    session = checker.session_for(request)
    document = session.document(request.at)
    if isinstance(document, Read) or document.launch is None:
        _tell_refusal(checker, request, "roslaunch")
        return None
    result = converted(session, request.at, request.arguments, style, language)
    for line in (*told(result.lost, "not carried over: "), *told(result.remarks, "look at this: ")):
        tell(line)
    return result


def told(said: Iterable[tuple[Place, str]], before: str) -> Iterator[str]:
    """A line for each, with its place."""
    for place, words in said:
        start = place.source.position(place.span.start)
        yield f"{place.source.path}:{start.line}:{start.column}: {before}{words}"


def _tell_refusal(checker: EntryChecker, request: EntryRequest, launcher: str = "ros2 launch") -> None:
    """Why the front end does not read the file."""
    from launchlint import __version__
    from launchlint.finding import Severity
    from launchlint.report.formats import emit
    from launchlint.report.run import Run
    from launchlint.report.text import render

    _, error = checker.model(request)
    result = checker.check(request)
    found = {each.key: each for each in (*(guarded.finding for file in result.files for guarded in file.findings), *result.findings)}
    errors = [each for each in found.values() if each.severity is Severity.ERROR]
    if errors:
        emit(render(errors, Run(__version__, files_checked=1, verbose=True, root=checker.session.root)), sys.stderr)
    why = "" if errors or error is None else f" ({error[0]}): {error[1]}"
    tell(f"{request.at} is not converted, since {launcher} cannot read it{why}")
