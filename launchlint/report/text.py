"""Findings for people: the source lines with what is wrong in them, what roslaunch says, and what to do."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Location, Severity
from launchlint.order import ordered
from launchlint.plural import counted
from launchlint.report.escape import line_start, shell_word, visible
from launchlint.report.run import Run
from launchlint.report.snippet import snippet
from launchlint.sight import Sight

_RESET = "\x1b[0m"
_BOLD = "\x1b[1m"
_FAINT = "\x1b[2m"
_COLORS = {Severity.ERROR: "\x1b[1;31m", Severity.WARNING: "\x1b[1;33m", Severity.INFO: "\x1b[1;34m"}

_NUMBER = 5
_LONGEST_CHAIN = 8
_MOST_RELATED = 5
_MOST_REASONS = 3
_MOST_UNSEEN = 100


def render(findings: Sequence[Finding], run: Run) -> str:
    """All findings in full, and a last line that sums up; infos, and why nodes are not known, only where ``run.verbose``."""
    shown = [finding for finding in ordered(findings) if run.verbose or finding.severity > Severity.INFO]
    blocks = ["\n".join(_block(finding, run)) + "\n" for finding in shown]
    if run.verbose and run.sight.distros:
        blocks.append("".join(f"read for ROS 2 {name.capitalize()}, after {visible(file)}\n" for name, file in run.sight.distros))
    if run.verbose and run.sight.unseen:
        blocks.append("\n".join(_unseen(run.sight)) + "\n")
    if run.verbose and any(each.state != "resolved" for each in run.sight.followed):
        blocks.append("\n".join(_followed(run.sight)) + "\n")
    return "\n".join([*blocks, summary(findings, run) + "\n"])


def summary(findings: Sequence[Finding], run: Run) -> str:
    """The last line: how many findings of each severity in how many launch files, and how many of these do not load."""
    if not run.files_checked and not findings:
        return "no launch files to check"
    count = {severity: sum(finding.severity == severity for finding in findings) for severity in Severity}
    told = [Severity.ERROR, Severity.WARNING, Severity.INFO] if run.verbose else [Severity.ERROR, Severity.WARNING]
    parts = ", ".join(counted(count[severity], severity.word) for severity in told if count[severity])
    hidden = (
        ""
        if run.verbose or not count[Severity.INFO]
        else f" ({counted(count[Severity.INFO], 'info')} hidden, -v shows {'it' if count[Severity.INFO] == 1 else 'them'})"
    )
    sight = f"; {run.sight.brief}" if run.sight.known < run.sight.nodes or (run.verbose and run.sight.nodes) else ""
    return f"{parts or 'no problems'} in {counted(run.files_checked, 'launch file')}{hidden}{_loading(run)}{sight}"


def _unseen(sight: Sight) -> Iterator[str]:
    """Why it is not known what some nodes do."""
    yield "it is not known what these do:"
    for program, reason, nodes in sight.unseen[:_MOST_UNSEEN]:
        yield f"  {visible(program)} ({counted(nodes, 'node')}): {visible(reason)}"
    if len(sight.unseen) > _MOST_UNSEEN:
        yield f"  and {counted(len(sight.unseen) - _MOST_UNSEEN, 'more program')}"


def _followed(sight: Sight) -> Iterator[str]:
    """Of which launch files in Python not all can be told without running them, and why."""
    resolved = sum(each.state == "resolved" for each in sight.followed)
    yield f"of {counted(len(sight.followed), 'launch file')} in Python {resolved} can be told as a whole without running; the others:"
    for path, state, reasons in sight.followed:
        if state != "resolved":
            why = "; ".join(f"line {line}: {visible(reason)}" for line, reason in reasons[:_MOST_REASONS])
            more = f"; and {counted(len(reasons) - _MOST_REASONS, 'more reason')}" if len(reasons) > _MOST_REASONS else ""
            yield f"  {visible(path)} ({'not at all' if state == 'not' else 'in part'}): {why}{more}"


def _loading(run: Run) -> str:
    """What becomes of the entry files; the empty string where all of them load."""
    words = [verdict.word for _, verdict in run.verdicts]
    refused, untold = words.count("refused"), words.count("cannot be told")
    elsewhere = sum(bool(verdict.elsewhere) for _, verdict in run.verdicts)
    if not refused and not untold and not elsewhere:
        return ""
    if len(words) == 1:
        return f"; {visible(run.verdicts[0][1].brief)}"
    loads = len(words) - refused - untold
    told = [f"{loads} {'loads' if loads == 1 else 'load'}"]
    told += [f"{refused} {'is' if refused == 1 else 'are'} refused by {_launchers(run)}"] if refused else []
    told += [f"{untold} cannot be told"] if untold else []
    told += [f"{elsewhere} of these {'is' if elsewhere == 1 else 'are'} refused with other args"] if elsewhere else []
    return f"; of {len(words)} entry files {', '.join(told)}"


def _launchers(run: Run) -> str:
    """Who refuses entry files of the run."""
    return " or ".join(sorted({verdict.launcher for _, verdict in run.verdicts if verdict.word == "refused"}))


def statistics(findings: Sequence[Finding]) -> str:
    """A table of how often each rule found something, the most frequent first; the empty string where nothing was found."""
    count: dict[tuple[str, str, str], int] = {}
    for finding in findings:
        key = (visible(finding.rule), visible(finding.name), finding.severity.word)
        count[key] = count.get(key, 0) + 1
    rows = sorted(count.items(), key=lambda row: (-row[1], row[0]))
    names = max((len(name) for (_, name, _), _ in rows), default=0)
    digits = max((len(str(number)) for _, number in rows), default=0)
    return "".join(f"{number:{digits}}  {rule}  {name:{names}}  {word}\n" for (rule, name, word), number in rows)


def _block(finding: Finding, run: Run) -> Iterator[str]:
    paint = _Paint(run.color)
    yield _headline(finding, paint)
    color = _COLORS[finding.severity]
    shown = finding.related[:_MOST_RELATED]
    digits = max(_NUMBER, *(len(str(location.line)) for location in (finding.location, *(related.location for related in shown))))
    yield from _excerpt(finding.location, finding.label, run, color, digits)
    path = finding.location.path
    for related in shown:
        if related.location.path != path:
            path = related.location.path
            yield paint(_FAINT, f"{' ' * (digits - 1)}--> {visible(path)}:{related.location.line}:{related.location.column}")
        yield from _excerpt(related.location, related.label, run, "\x1b[1;36m", digits)
    if len(finding.related) > len(shown):
        more = counted(len(finding.related) - len(shown), "more place")
        yield f"{' ' * (digits - 2)}{paint(_FAINT, '=')} and {more}"
    for line in _remarks(finding):
        yield f"{' ' * (digits - 2)}{paint(_FAINT, '=')} {line}"


def _headline(finding: Finding, paint: _Paint) -> str:
    at = finding.location
    place = f"{line_start(at.path)}:{at.line}:{at.column}:"
    severity = paint(_COLORS[finding.severity], finding.severity.word)
    return f"{paint(_BOLD, place)} {severity} {paint(_BOLD, visible(finding.rule))} {visible(finding.name)}: {visible(finding.message)}"


def _excerpt(location: Location, label: str, run: Run, color: str, digits: int) -> Iterator[str]:
    """The source line and the line with carets and label; the label stands before the carets where there is room, else after them."""
    paint = _Paint(run.color)
    excerpt = snippet(location, run.width - digits - 3)
    words = visible(label)
    if location.end_line > location.line:
        words = f"{words} (to line {location.end_line})".lstrip()
    if excerpt is None:
        if words:
            yield f"{paint(_FAINT, f'{location.line:{digits}} |')} {paint(color, words)}"
        return
    yield f"{paint(_FAINT, f'{location.line:{digits}} |')} {excerpt.line}"
    carets = "^" * excerpt.carets
    fits = label.isascii() and len(words) + 1 <= excerpt.indent
    under = f"{words} {carets}" if words and fits else f"{carets} {words}".rstrip()
    indent = excerpt.indent - (len(words) + 1 if words and fits else 0)
    yield f"{paint(_FAINT, ' ' * digits + ' |')} {' ' * indent}{paint(color, under)}"


def _remarks(finding: Finding) -> Iterator[str]:
    """What stands below the source lines: includes, notes, the command that shows it, what to do."""
    steps = finding.chain[::-1]
    for step in steps[:_LONGEST_CHAIN]:
        yield f"included from {visible(step.path)}:{step.line}:{step.column}"
    if len(steps) > _LONGEST_CHAIN:
        yield f"included through {len(steps) - _LONGEST_CHAIN} more files"
    if finding.entries > 1:
        yield f"reached from {finding.entries} launch files"
    for note in finding.notes:
        yield visible(note)
    if finding.entry:
        yield f"show it: {command(finding)}"
    if finding.fix is not None:
        yield f"fix: {visible(finding.fix.message)} ({'--fix' if finding.fix.safe else '--unsafe-fixes'})"
    # A crash of launchlint itself has no page.
    explain = "" if finding.name == "internal-error" else f"[explain {visible(finding.rule)}]"
    if finding.help or explain:
        yield (f"help: {visible(finding.help)}      {explain}" if finding.help else explain).rstrip()


def command(finding: Finding) -> str:
    """The command that shows ``finding``, quoted for the shell; the empty string where no entry file is known."""
    if not finding.entry:
        return ""
    entry = f"./{finding.entry}" if finding.entry.startswith("-") else finding.entry
    return " ".join([finding.launcher, shell_word(entry), *(shell_word(f"{name}:={value}") for name, value in finding.arguments)])


class _Paint:
    """Puts an ANSI style around a text, or does nothing."""

    __slots__ = ("color",)

    def __init__(self, color: bool) -> None:
        self.color = color

    def __call__(self, style: str, text: str) -> str:
        return f"{style}{text}{_RESET}" if self.color and text else text
