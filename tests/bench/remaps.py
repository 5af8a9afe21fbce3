"""Mistakes in remaps: how many of them does a check tell?

``python -m tests.bench.remaps CORPUS [--library FILE]… [--files 300] [--seed N] [--missed N] [--untouched]``. ``CORPUS`` holds one
directory per repository. In each of so many launch files that load, a ``<remap>`` that acts on known nodes is misspelt (a letter of
``from`` or ``to``), deleted, or misplaced (it stands in another node, or ``to`` lies in another namespace): one mistake of each kind, where
that can be made; which remap and how is drawn with a fixed seed. Told is what brings a warning or error of a rule about remaps and
connections that the untouched file has not.

Printed: the share told where both ends are known (the mistake parts two nodes of the launch that talked to each other), and over all; with
``--missed`` those that are not told, with ``--untouched`` what is said of the files as they are. The exit status is 1 where nothing can be
seeded or nothing is told: then the bench itself is broken.
"""

from __future__ import annotations

import argparse
import os
import random
import sys
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from launchlint.check.entry import EntryChecker
from launchlint.check.options import EntryRequest, Options
from launchlint.evaluate.launch import evaluate
from launchlint.finding import Finding, Severity
from launchlint.graph.connections import OFFERS, ConnectionGraph, Endpoint
from launchlint.rules.registry import RULES
from launchlint.source import Span
from launchlint.syntax.tree import Document, Element
from launchlint.workspace.discovery import discover

ABOUT = ("LL60", "LL61")
WAYS = ("misspelt from", "misspelt to", "deleted", "wrong node", "wrong namespace")
TRIES = 20
LETTERS = "abcdefghijklmnopqrstuvwxyz"
Talk = dict[tuple[str, str, str], frozenset[str]]


class Seed(NamedTuple):
    """One mistake: the text of the file with it."""

    file: str
    way: str
    was: str
    text: str


class Outcome(NamedTuple):
    """What became of it: the new findings above info, and the infos; ``both`` ends are known, ``all_known``: all of the launch."""

    seed: Seed
    all_known: bool
    both: bool
    told: tuple[Finding, ...]
    hinted: tuple[Finding, ...]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("corpus")
    parser.add_argument("--library", action="append", default=[])
    parser.add_argument("--files", type=int, default=300)
    parser.add_argument("--seed", type=int, default=12)
    parser.add_argument("--missed", type=int, default=0, metavar="N", help="list the first N that are not told")
    parser.add_argument("--untouched", action="store_true", help="list what is said of the files as they are")
    options = parser.parse_args()
    chance = random.Random(options.seed)
    outcomes: list[Outcome] = []
    untouched: dict[str, tuple[Finding, ...]] = {}
    pools = [_files(options.corpus, name, tuple(options.library)) for name in sorted(os.listdir(options.corpus))]
    files = [pair for pool in pools for pair in pool]
    chance.shuffle(files)
    for checker, file in files:
        if len(untouched) == options.files:
            break
        for found, known in _outcomes(checker, file, chance):
            outcomes.append(found)
            untouched[file] = known
    print(table(outcomes))
    _print_untouched(untouched, listed=options.untouched)
    missed = [each for each in outcomes if not each.told]
    for each in missed[: options.missed]:
        print(f"  not told{' (both ends known)' if each.both else ''}: {each.seed.way}: {each.seed.file}: {each.seed.was}")
        for finding in each.hinted:
            print(f"      {finding.rule} info: {finding.message}")
    if not outcomes or not any(each.told for each in outcomes):
        sys.exit("nothing was told: the bench or the rules are broken")


def table(outcomes: list[Outcome]) -> str:
    """One line for each kind of mistake, and one for all: told of those with both ends known, told of all."""
    known = sum(each.all_known for each in outcomes)
    files = {each.seed.file for each in outcomes}
    lines = [
        f"{len(outcomes)} mistakes in {len(files)} launch files; {known} where all nodes are known",
        f"{'':18}{'both ends known':>22}{'over all':>22}",
    ]
    for way in (*WAYS, "all nodes known", "all"):
        rows = [each for each in outcomes if way in (each.seed.way, "all") or (way == "all nodes known" and each.all_known)]
        cells = []
        for part in ([each for each in rows if each.both], rows):
            told = sum(bool(each.told) for each in part)
            cells.append(f"{told:5} of {len(part):4} {100 * told / max(len(part), 1):6.1f} %")
        lines.append(f"{way:18}{cells[0]:>22}{cells[1]:>22}")
    return "\n".join(lines)


def _print_untouched(untouched: dict[str, tuple[Finding, ...]], *, listed: bool) -> None:
    counts = Counter((each.rule, each.severity.name.lower()) for found in untouched.values() for each in found)
    print(
        "the files as they are:", ", ".join(f"{rule} {severity} {count}" for (rule, severity), count in sorted(counts.items())) or "nothing"
    )
    for file, found in sorted(untouched.items()) if listed else ():
        for each in found:
            if each.severity > Severity.INFO:
                print(f"  {file}: {each.rule} {each.severity.name.lower()}: {each.message}")


def _files(corpus: str, name: str, libraries: tuple[str, ...]) -> list[tuple[EntryChecker, str]]:
    repository = os.path.join(corpus, name)
    if not os.path.isdir(repository):
        return []
    rules = frozenset(rule.id for rule in RULES if rule.id.startswith(ABOUT))
    checker = EntryChecker(Options(rules, (repository,), True, {}, repository, library=libraries))
    return [(checker, file) for file in discover([repository])]


def _outcomes(checker: EntryChecker, file: str, chance: random.Random) -> Iterator[tuple[Outcome, tuple[Finding, ...]]]:
    """One mistake of each kind in ``file``, where one can be made that changes who talks to whom, and what is said of the file as it is."""
    request = EntryRequest(file, file)
    found = _graph(checker, request)
    if found is None:
        return
    graph, document = found
    acting: dict[int, list[Endpoint]] = {}
    for endpoint in (each for instance in graph.instances for each in instance.endpoints):
        for applied in endpoint.applied:
            remap = applied.rule.remap
            if remap is not None and remap.origin.place.source.path == document.source.path:
                acting.setdefault(remap.origin.place.span.start, []).append(endpoint)
    elements = [each for each in document.elements if each.start_span.start in acting and {"from", "to"} <= each.attributes.keys()]
    before = talk(graph)
    known = _told(checker, request) if elements else ()
    all_known = graph.launch.complete and not any(instance.is_unknown for instance in graph.instances)
    for way in WAYS if elements else ():
        for _ in range(TRIES):
            seed = _seeded(file, document, chance.choice(elements), way, chance)
            mutated = None if seed is None else checker.holding({file: seed.text.encode()})
            after_graph = None if mutated is None else _graph(mutated, request)
            after = before if after_graph is None else talk(after_graph[0])
            if seed is None or mutated is None or after == before:
                continue
            parted = any(before[key] - after.get(key, frozenset()) for key in before)
            new = list(_new(_told(mutated, request), known))
            told = tuple(each for each in new if each.severity > Severity.INFO)
            yield Outcome(seed, all_known, parted, told, tuple(each for each in new if each.severity <= Severity.INFO)), known
            break


def talk(graph: ConnectionGraph) -> Talk:
    """For each name in a node's code, and each place on the graph it leads to, the nodes at the other end."""
    found: Talk = {}
    for channel in graph.channels.values():
        for endpoint in (*channel.offers, *channel.uses):
            if endpoint.certain and not endpoint.is_plumbing:
                others = channel.uses if endpoint.role in OFFERS else channel.offers
                partners = frozenset(each.node for each in others if each.certain and each.node != endpoint.node)
                found[endpoint.node, endpoint.role, endpoint.declared] = partners
    return found


def _graph(checker: EntryChecker, request: EntryRequest) -> tuple[ConnectionGraph, Document] | None:
    """The graph of a file that loads, with default args, and its text; None where it does not."""
    checker.session.begin_entry()
    evaluation = evaluate(checker.session, request.at, ())
    launch = evaluation.launch
    if launch.refused is not None:
        return None
    graph = checker.connected(evaluation)
    return graph, evaluation.documents[launch.entry.path]


def _seeded(file: str, document: Document, element: Element, way: str, chance: random.Random) -> Seed | None:
    text = document.source.text
    was = text[element.span.start : element.span.end]
    if way.startswith("misspelt"):
        changed = _set(text, element, way.split()[1], lambda value: _misspelt(value, chance))
    elif way == "wrong namespace":
        changed = _set(text, element, "to", lambda value: _elsewhere(value, chance))
    else:
        without = text[: element.span.start] + text[element.span.end :]
        changed = without if way == "deleted" else _moved(document, element, chance)
    return None if changed is None or changed == text else Seed(file, way, was, changed)


def _set(text: str, element: Element, attribute: str, change: object) -> str | None:
    at = element.attributes[attribute]
    value = change(at.value) if at.raw == at.value and "$(" not in at.value else None  # type: ignore[operator]
    return None if value is None else text[: at.value_span.start] + value + text[at.value_span.end :]


def _misspelt(name: str, chance: random.Random) -> str | None:
    """One letter of the last part left out, put in twice, replaced, or two of them exchanged."""
    head, slash, last = name.rpartition("/")
    if len(last) < 4:
        return None
    at = chance.randrange(1, len(last) - 1)
    ways = (
        last[:at] + last[at + 1 :],
        last[:at] + last[at] + last[at:],
        last[:at] + chance.choice(LETTERS) + last[at + 1 :],
        last[:at] + last[at + 1] + last[at] + last[at + 2 :],
    )
    return head + slash + chance.choice(ways)


def _elsewhere(name: str, chance: random.Random) -> str | None:
    """The name in another namespace: one more around it, one fewer, or global where it was relative."""
    root = "/" if name.startswith("/") else ""
    parts = name.lstrip("/").split("/")
    ways = [f"{root}other/{name.lstrip('/')}"]
    if len(parts) > 1:
        ways.append(root + "/".join(parts[1:]))
    if not root and not name.startswith("~"):
        ways.append(f"/{name}")
    return None if name.startswith("~") else chance.choice(ways)


def _moved(document: Document, element: Element, chance: random.Random) -> str | None:
    """The remap in another ``<node>`` of the file."""
    text = document.source.text
    nodes = [each for each in document.elements if each.tag == "node" and each is not element.parent]
    if not nodes:
        return None
    node, was = chance.choice(nodes), text[element.span.start : element.span.end]
    pieces = [(element.span, "")]
    start = node.start_span
    if node.self_closed:
        opened = text[start.start : start.end].removesuffix("/>").rstrip()
        pieces.append((start, f"{opened}>{was}</{node.tag}>"))
    else:
        pieces.append((Span(start.end, start.end), was))
    for span, new in sorted(pieces, key=lambda piece: piece[0].start, reverse=True):
        text = text[: span.start] + new + text[span.end :]
    return text


def _told(checker: EntryChecker, request: EntryRequest) -> tuple[Finding, ...]:
    return checker.check(request).findings


def _new(found: tuple[Finding, ...], known: tuple[Finding, ...]) -> Iterator[Finding]:
    left = Counter((each.rule, each.severity, each.message) for each in known)
    for each in found:
        key = (each.rule, each.severity, each.message)
        if left[key]:
            left[key] -= 1
        else:
            yield each


if __name__ == "__main__":
    main()
