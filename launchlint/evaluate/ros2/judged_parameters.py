"""What is wrong with the params and remaps of a node that launch starts without a word: rcl has the last one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from launchlint.evaluate.ros2.parameter_problems import (
    LaterValueLost,
    ListBecomesText,
    ParameterDies,
    ParametersFileDies,
    RemapDies,
    SetParameterDies,
    TextRetyped,
)
from launchlint.evaluate.ros2.parameters import LETTERS, source_of
from launchlint.evaluate.ros2.rcl_files import content_of, table_of
from launchlint.evaluate.ros2.started import written
from launchlint.evaluate.session import WRITTEN
from launchlint.model import Unknown
from launchlint.rcl import parameter_rule, remap
from launchlint.rcl.parameter_value import scalar
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import Key, Parameter, Table
from launchlint.source import Origin, Place, Span
from launchlint.yaml.tree import STR, yaml_1_1

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.parameters import GlobalParameter, Passed, Performs
    from launchlint.evaluate.ros2.started import Started
    from launchlint.model import Remap
    from launchlint.problem import Problem

_LONGEST = 60
_LONGEST_KEPT = 1_000
"""A value that may be a path, which is shown from the directory that is checked."""


def judged(passed: Sequence[Passed], remaps: Iterable[Remap], begun: Started, node: str, asks: Performs) -> Iterator[Problem]:
    """All that can be told of one node: what it was given, and what became of it; ``node`` is what people call it."""
    for each in remaps:
        yield from _remap(each, node)
    for given in passed:
        if given.given is not None:
            yield from _set_parameter(given.given, given)
        elif (given.file or given.of or "").startswith(WRITTEN):
            pass  # nobody can mend what a launch writes
        elif given.file is not None and not given.unknown:
            yield from _file(given, node, asks)
        elif given.text is not None and given.of is not None and not given.unknown:
            yield from _content(given, given.of, given.text, node, asks)
        elif given.content is not None and begun.refused is not None:
            refused = _refused(given, asks)
            if refused is not None:
                yield ParameterDies(origin=given.origin, reason=refused.reason, node=node)
                continue
        for text in given.texts:
            found = scalar(text.value).type
            if text.meant and found != "str" and yaml_1_1()(text.value) == STR:
                origin = Origin(text.place, given.origin.step)
                yield TextRetyped(origin=origin, name=text.name, value=text.value, type=found, command_line=False)
    if begun.command_line is not None and begun.full_name is not None:
        yield from _lost(begun.command_line.parameters, begun.full_name, begun, passed)


def _remap(each: Remap, node: str) -> Iterator[Problem]:
    refused = remap.parse(f"{each.source}:={each.target}")
    if isinstance(refused, Refused):
        yield RemapDies(
            origin=each.origin,
            source=each.source,
            target=each.target,
            side="to" if refused.span.start >= len(each.source) + 2 else "from",
            reason=refused.reason,
            node=node,
        )


def _set_parameter(given: GlobalParameter, passed: Passed) -> Iterator[Problem]:
    if passed.unknown or passed.rule is None or isinstance(given.name, Unknown):
        return
    refused = parameter_rule.add(passed.rule, Table())
    if refused is not None:
        yield SetParameterDies(
            origin=given.origin, name=given.name, value=given.text[:_LONGEST], empty=not given.text, reason=refused.reason
        )
    elif isinstance(given.value, tuple):
        yield ListBecomesText(origin=given.origin, name=given.name, text=given.text[:_LONGEST])
    elif isinstance(given.value, str) and (given.meant or given.value in LETTERS):
        found = scalar(given.value).type
        if found != "str":
            yield TextRetyped(origin=given.origin, name=given.name, value=given.value, type=found, command_line=True)


def _file(given: Passed, node: str, asks: Performs) -> Iterator[Problem]:
    assert given.file is not None
    table = table_of(given.file, asks)
    if isinstance(table, Refused) and table.source is not None:
        yield ParametersFileDies(
            origin=Origin(Place(table.source, table.span), given.origin.step),
            related=((given.origin.place, "the file is given to the node here"),),
            file=table.source.path,
            reason=table.reason,
            node=node,
            instead=table.instead,
        )


def _content(given: Passed, file: str, text: str, node: str, asks: Performs) -> Iterator[Problem]:
    """A file with the substitutions in it performed: its lines are those of the file, as long as no value has several."""
    refused = content_of(file, text, asks).alone
    if not isinstance(refused, Refused):
        return
    source = source_of(file, asks.session.read(file).data or b"", asks)
    place = given.origin.place
    if text.count("\n") == source.text.count("\n"):
        line = text.count("\n", 0, refused.span.start)
        start = source.line_starts[line]
        shown = source.line(line + 1)
        place = Place(source, Span(start + len(shown) - len(shown.lstrip()), start + len(shown)))
    yield ParametersFileDies(
        origin=Origin(place, given.origin.step),
        related=((given.origin.place, "the file is given to the node here"),),
        file=source.path,
        reason=refused.reason,
        node=node,
        instead=refused.instead,
    )


def _refused(given: Passed, asks: Performs) -> Refused | None:
    """Why rcl refuses what launch writes for one ``<param>``, if it does."""
    read = written(given, asks).alone
    return read if isinstance(read, Refused) else None


def _lost(table: Table, full_name: str, begun: Started, passed: Sequence[Passed]) -> Iterator[Problem]:
    """Values that do not count although they were read after those that do, or stand in the same file under the node's own name."""
    keys = [key for key in table.reaching(full_name) if key.parameters]
    if len(keys) < 2:
        return
    kept: dict[str, tuple[Key, Parameter]] = {parameter.name: (key, parameter) for key in keys for parameter in key.parameters}
    for key in keys:
        for parameter in key.parameters:
            winner, winning = kept[parameter.name]
            if winner is key or parameter.value == winning.value or parameter.written.source is None:
                continue
            later = table.order(key, parameter) > table.order(winner, winning)
            exact = parameter.written.source is winning.written.source and "*" in winner.name and "*" not in key.name
            if not later and not exact:
                continue
            yield LaterValueLost(
                origin=_origin(parameter, begun, passed),
                related=((_origin(winning, begun, passed).place, "this counts"),),
                name=parameter.name,
                node=full_name,
                lost=str(parameter.value.data)[:_LONGEST_KEPT],
                kept=str(winning.value.data)[:_LONGEST_KEPT],
                lost_key=key.name,
                kept_key=winner.name,
                later=later,
            )


def _origin(parameter: Parameter, begun: Started, passed: Sequence[Passed]) -> Origin:
    """Where a param was set: in a file of somebody's, or by an element of a launch file."""
    written = parameter.written
    for source, given in begun.contents:
        if source is written.source:
            return given.origin
    if written.source is None:
        rules = (each.origin for each in passed if each.given is not None and each.given.name == parameter.name)
        return next(rules, passed[0].origin)
    giving = (each.origin.step for each in passed if each.file == written.source.file)
    return Origin(Place(written.source, written.value), next(giving, None))
