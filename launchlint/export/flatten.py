"""One file that needs no other launch file, and the proof that it means the same."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator

from launchlint.evaluate.configurations import configurations
from launchlint.evaluate.ros1.file import Exhausted
from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.export.expression import VARIABLES, NotCovered, variables_read
from launchlint.export.frame import Plan
from launchlint.export.tree import Out, Piece, render
from launchlint.export.walk import Walk
from launchlint.export.written import CannotExport, Fixed
from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.fix.meaning import Meaning, difference, meaning
from launchlint.model import Launch
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.parts import Parts
from launchlint.syntax.ros1.substitutions import parse

MOST_ATTEMPTS = 60
MOST_NODES = 20_000
MOST_VARIABLES = 8
"""Environment variables whose other values take part in the proof."""

Pairs = tuple[tuple[str, str], ...]


class Exported(NamedTuple):
    """``data`` is the file; ``fixed`` says what holds the values of this configuration, or of this machine, and why."""

    data: bytes
    fixed: tuple[str, ...]


def flatten(session: Session, file: str, given: Pairs, style: Style, *, args_kept: bool) -> Exported:
    """The launch file ``file``, started with ``given``, as one file; with ``args_kept`` its own args can still be given.

    What it means has been compared with the original in this configuration, with other values of the environment variables it reads, and
    with ``args_kept`` in every configuration. Raises CannotExport; the file must be one that roslaunch loads.
    """
    launch = evaluate(session, file, given).launch
    if not launch.complete or len(launch.nodes) + len(launch.tests) > MOST_NODES:
        raise CannotExport(f"it starts more than {MOST_NODES:,} nodes, or includes more than can be followed")
    reasons: dict[str, str] = {}
    isolated, once = frozenset[str](), frozenset[str]()
    for _ in range(MOST_ATTEMPTS):
        plan = Plan(session, file, kept=args_kept, fixed=frozenset(reasons), isolated=isolated)
        plan.once = once
        if args_kept:
            plan.names.update(each.name for each in launch.declared if each.origin.step is None and not each.passed and each.value is None)
        try:
            pieces = Walk(plan, dict(launch.arguments)).export(file)
            clashing = _clashing(plan)
            if clashing != isolated:
                isolated, once = clashing, frozenset(name for name, count in plan.made.items() if count == 1)
                continue
            fixed = _fixed(plan, launch, pieces, reasons)
            text = render([_origin(launch), *(f"Fixed: {each}" for each in fixed)], pieces, style.indent)
            data = formatted(text.encode("utf-8"), session.shown(file), style).data
            proof = _Proof(session, file, given, data, args_kept=args_kept)
            found = proof.disproved(frozenset(reasons), _variables(pieces))
        except Fixed as stuck:
            if not stuck.sources - reasons.keys():
                raise CannotExport(stuck.reason) from None
            reasons.update(dict.fromkeys(stuck.sources, stuck.reason))
            continue
        except Exhausted:
            raise CannotExport("it includes more than can be written into one file") from None
        if found is None:
            return Exported(data, tuple(fixed))
        sources, reason = found
        if not sources - reasons.keys():
            raise CannotExport(f"the exported file would not mean the same: {reason}")
        reasons.update(dict.fromkeys(sources, f"otherwise {reason}"))
    raise CannotExport("too much in it depends on each other")


def _clashing(plan: Plan) -> frozenset[str]:
    """The IDs of ``$(anon)`` that stand for more than one name."""
    count = Counter(plan.ids.values())
    return frozenset(name for name in count if count[name] > 1)


def _strings(pieces: list[Piece]) -> Iterator[str]:
    """Every value and every YAML text in the exported file."""
    waiting = list(pieces)
    while waiting:
        piece = waiting.pop()
        if isinstance(piece, Out):
            waiting += piece.children
            yield from piece.attributes.values()
            yield piece.text


def _variables(pieces: list[Piece]) -> frozenset[str]:
    """The environment variables that the exported file asks for."""
    return frozenset(name for text in _strings(pieces) for name in _variables_of(parse(text)))


def _variables_of(parts: Parts) -> Iterable[str]:
    if parts.expression is None:
        return (part.words[1].text for part in parts.substitutions() if part.command in VARIABLES and len(part.words) > 1)
    try:
        return variables_read(parts.expression.code)
    except NotCovered:
        return ()


def _fixed(plan: Plan, launch: Launch, pieces: list[Piece], reasons: dict[str, str]) -> list[str]:
    """What could have stayed open, with its value and why it did not; and directories that are those of this machine."""
    values = {each.name: each.default for each in launch.declared if each.origin.step is None and not each.passed}
    lines = []
    for source, reason in sorted(reasons.items()):
        name = source.removeprefix("$")
        if source.startswith("$"):
            value = plan.session.variable(name)
            lines.append(f"the environment variable {name}, {'not set' if value is None else repr(value)} here, since {reason}")
        else:
            lines.append(f"the arg {name}, {launch.arguments.get(name, values.get(name))!r} here, since {reason}")
    for directory, file in sorted(plan.local.items()):
        if any(directory in text for text in _strings(pieces)):
            lines.append(f"the directory of {file}, {directory!r} here, since it lies in no package")
    return lines


def _origin(launch: Launch) -> str:
    words = " ".join(f"{name}:={value}" for name, value in launch.given)
    return f"Flattened by launchlint from {os.path.basename(launch.entry.path)}{f', started with {words}' if words else ''}."


# -- the proof -----------------------------------------------------------------------------------------------------


class _Proof:
    """The file and the exported one, to be started side by side."""

    def __init__(self, session: Session, file: str, given: Pairs, data: bytes, *, args_kept: bool) -> None:
        self.session = session
        self.exported = session.with_text(file, data)
        self.file = file
        self.given = given
        self.args_kept = args_kept

    def disproved(self, fixed: frozenset[str], variables: frozenset[str]) -> tuple[frozenset[str], str] | None:
        """What must not stay open, and the difference that shows it; None where the exported file means the same.

        ``fixed`` are args that cannot be given any more, ``variables`` those of the environment that the exported file reads.
        """
        found = self._difference(self.session, self.exported, ())
        if found:
            return frozenset(), found
        for pairs in self._other_configurations(fixed) if self.args_kept else ():
            found = self._difference(self.session, self.exported, pairs)
            if found:
                return frozenset(name for name, _ in pairs), f"with {' '.join(f'{name}:={value}' for name, value in pairs)} {found}"
        for name in sorted(variables)[:MOST_VARIABLES]:
            for value in ("true", "false", f"value_of_{name}"):
                found = self._difference(self._in(self.session, name, value), self._in(self.exported, name, value), ())
                if found:
                    return frozenset((f"${name}",)), f"with {name}={value} in the environment {found}"
        return None

    def _difference(self, session: Session, exported: Session, pairs: Pairs) -> str:
        both = tuple({**dict(self.given), **dict(pairs)}.items())
        before = evaluate(session, self.file, both).launch
        if before.refused is not None and (pairs or session is not self.session):
            return ""
        return _differs(before, evaluate(exported, self.file, pairs).launch)

    @staticmethod
    def _in(session: Session, name: str, value: str) -> Session:
        return Session(session.packages, {**session.environment, name: value}, session.root, session.overlay)

    def _other_configurations(self, fixed: frozenset[str]) -> Iterator[Pairs]:
        """All configurations of both files, each as the pairs that differ from what is exported."""
        done: set[Pairs] = {()}
        for source, base in ((self.session, self.given), (self.exported, ())):
            for evaluation in configurations(source, self.file, base):
                pairs = tuple(sorted(evaluation.launch.given[len(base) :]))
                if pairs not in done and not any(name in fixed for name, _ in pairs):
                    done.add(pairs)
                    yield pairs


def _differs(before: Launch, after: Launch) -> str:
    """What differs first, apart from args and the numbers of anonymous names; empty where nothing does."""
    old, new = _comparable(before), _comparable(after)
    if old == new or _renumbered(old) == _renumbered(new):
        return ""
    return difference(old, new)


def _comparable(launch: Launch) -> Meaning:
    return meaning(launch)._replace(arguments=(), left_open=())


def _renumbered(found: Meaning) -> str:
    """All of a meaning as text, with the names that ``$(anon)`` makes up numbered in the order in which they stand there."""
    numbers: dict[str, int] = {}
    return re.sub(r"_anon(\d+)", lambda match: f"_anon#{numbers.setdefault(match[1], len(numbers) + 1)}", repr(found))
