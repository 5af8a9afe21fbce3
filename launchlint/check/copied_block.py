"""A block of a launch file that stands in it twice: its args, its nodes and what is set in these are one mistake, and not three."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from launchlint.check.known import Known
from launchlint.finding import Finding
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.joined import joined, led_by

PREFIX = "block "
_ARG, _NODE, _PARAM = "LL203", "LL301", "LL504"
_MOST_NAMED = 3
_EACH = "remove one of each two, or give it a name of its own"


class _Twice(NamedTuple):
    """What a finding says stands twice in one file: where it does, and of which node it is (empty: of none)."""

    finding: Finding
    first: int
    second: int
    node: str = ""

    @property
    def cause(self) -> str:
        """The cause that its finding has by itself."""
        return _cause(self.finding)

    def is_node(self, name: str) -> bool:
        """Whether it is the node ``name`` that stands twice."""
        return self.finding.rule == _NODE and self.node == name

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
    causes: dict[tuple[str, str], str] = {}
    for path, several in files.items():
        for block in _blocks(several):
            causes.update(((path, each.cause), f"{PREFIX}{path} {block[0].first}") for each in block)
    for finding in told:
        cause = causes.get((finding.location.path, _cause(finding)))
        yield finding if cause is None else finding._replace(cause=cause)


def _blocks(several: list[_Twice]) -> Iterator[list[_Twice]]:
    """What of one file stands twice in one block: two or more findings of different causes, in the order of the file."""
    several.sort(key=lambda each: (each.first, each.second))
    block: list[_Twice] = []
    for each in several:
        if each.finding.rule == _PARAM and not any(other.is_node(each.node) and other.crosses(each) for other in several):
            continue
        if block and not any(each.crosses(other) for other in block):
            if len({other.cause for other in block}) > 1:
                yield block
            block = []
        block.append(each)
    if len({other.cause for other in block}) > 1:
        yield block


def told_together(findings: Sequence[Finding]) -> Finding:
    """One for a block: the args that are declared twice, or else the nodes of one name each, by their names."""
    args = [each for each in findings if each.rule == _ARG]
    told = led_by(findings, _ARG, _NODE)
    nodes = list(dict.fromkeys(each.about[0] for each in findings if each.rule == _NODE and each.about))
    named = ", ".join(nodes[:_MOST_NAMED]) + (f" and {len(nodes) - _MOST_NAMED} more" if len(nodes) > _MOST_NAMED else "")
    if args and nodes:
        from launchlint.rules.args.arg_redeclared import together

        said = together(args) if len(args) > 1 else joined(args)
        message = f"{said.message}; the block stands here twice, with the node{'s' * (len(nodes) > 1)} {named}"
        return told._replace(message=message, fix=None)
    if len(nodes) < 2:
        return told
    alike = len({each.help for each in findings if each.rule == _NODE}) == 1
    message = f"{len(nodes)} names are given to two nodes each: {named}"
    return told._replace(message=message) if alike else told._replace(message=message, help=_EACH, fix=None)


def _twice(finding: Finding) -> _Twice | None:
    """What ``finding`` says of one file; ``None`` where it is none of these rules, or about two files."""
    if finding.rule not in (_ARG, _NODE, _PARAM) or not finding.related:
        return None
    here, other = finding.location, finding.related[0].location
    if here.path != other.path:
        return None
    if finding.rule == _PARAM:  # told where the value stands that counts for nothing, which is the first
        return _Twice(finding, here.start, other.start, finding.about[0])
    return _Twice(finding, other.start, here.start, finding.about[0] if finding.about else "")


def _cause(finding: Finding) -> str:
    return finding.cause or repr(finding.key)
