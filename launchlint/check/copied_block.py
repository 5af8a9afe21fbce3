"""A block of a launch file that stands in it twice: its args, its nodes and what is set in these are one mistake, and not three."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from launchlint.check.known import Known
from launchlint.finding import Finding
from launchlint.rules.judging.joined import joined, led_by

PREFIX = "block "
_ARG, _NODE, _PARAM = "LL203", "LL301", "LL504"
_NAMED = "two nodes are named "
_MOST_NAMED = 3


class _Twice(NamedTuple):
    """What a finding says stands twice in one file: where it does, and of which node it is (empty: of none)."""

    finding: Finding
    first: int
    second: int
    node: str = ""

    def crosses(self, other: _Twice) -> bool:
        """Whether both firsts stand before both seconds: then one block was copied behind itself."""
        return max(self.first, other.first) < min(self.second, other.second)


def judged_by_block(findings: Iterable[Finding], _: Known) -> Iterator[Finding]:
    """``findings``, those about one copied block with one cause."""
    told = list(findings)
    files: dict[str, list[_Twice]] = {}
    for finding in told:
        twice = _twice(finding)
        if twice is not None:
            files.setdefault(finding.location.path, []).append(twice)
    causes: dict[int, str] = {}
    for path, several in files.items():
        nodes = [each for each in several if each.finding.rule == _NODE]
        args = [each for each in several if each.finding.rule == _ARG]
        for node in nodes:
            same = [arg for arg in args if arg.crosses(node)]
            same += [param for param in several if param.finding.rule == _PARAM and param.node == node.node and param.crosses(node)]
            if any(each.finding.rule == _ARG for each in same):  # args of one file have one cause already
                causes.update((id(each.finding), PREFIX + path) for each in (node, *same, *args))
            elif same:
                cause = causes.get(id(node.finding)) or f"{PREFIX}{path} {node.finding.cause or node.node}"
                causes.update((id(each.finding), cause) for each in (node, *same))
                if node.finding.cause:
                    alike = (each for each in nodes if each.finding.cause == node.finding.cause)
                    causes.update((id(each.finding), cause) for each in alike if id(each.finding) not in causes)
    for finding in told:
        cause = causes.get(id(finding))
        yield finding if cause is None else finding._replace(cause=cause)


def told_together(findings: Sequence[Finding]) -> Finding:
    """One for a block: the args that are declared twice, else the nodes of one name; how many nodes stand there twice."""
    args = [each for each in findings if each.rule == _ARG]
    told = led_by(findings, _ARG, _NODE)
    nodes = list(dict.fromkeys(each.message.removeprefix(_NAMED) for each in findings if each.message.startswith(_NAMED)))
    if not args or not nodes:
        return told
    from launchlint.rules.args.arg_redeclared import together

    named = ", ".join(nodes[:_MOST_NAMED]) + (f" and {len(nodes) - _MOST_NAMED} more" if len(nodes) > _MOST_NAMED else "")
    said = together(args) if len(args) > 1 else joined(args)
    return told._replace(message=f"{said.message}; the block stands here twice, with the node{'s' * (len(nodes) > 1)} {named}")


def _twice(finding: Finding) -> _Twice | None:
    """What ``finding`` says of one file; ``None`` where it is none of these rules, or about two files."""
    if finding.rule not in (_ARG, _NODE, _PARAM) or not finding.related:
        return None
    here, other = finding.location, finding.related[0].location
    if here.path != other.path:
        return None
    if finding.rule == _PARAM:  # told where the value stands that counts for nothing, which is the first
        return _Twice(finding, here.start, other.start, finding.message.partition(" is set to ")[0].rpartition("/")[0])
    return _Twice(finding, other.start, here.start, finding.message.removeprefix(_NAMED))
