"""Mistakes in remaps: how many of them does a check tell?

``python -m tests.bench.remaps CORPUS [--library FILE]… [--sources DIRECTORY] [--files 300] [--seed N] [--missed N] [--untouched]``.
``CORPUS`` holds one directory per repository. In each of so many launch files that load, a ``<remap>`` that acts on known nodes is
misspelt (a letter of ``from`` or ``to``), deleted, or misplaced (it stands in another node, or ``to`` lies in another namespace): one
mistake of each kind, where that can be made; which remap and how is drawn with a fixed seed. Told is what brings a warning or error of
a rule about remaps and connections that the untouched file has not; in the last line an info counts, too.

What counts, in one column each; the first holds those of the next two together, the last all:

- *two loose ends*: two nodes of the launch, each with its name known, talked to each other by a name and do so no more, and both ends are
  left with nobody, and one of them at least with nobody who could be there.
- *one loose end*: the same, but one of the two still has somebody else: another node hears the same source, or says the same. That one
  end alone is what a file looks like, too, whose other half is started elsewhere: a camera's second reader that waits for ``image``.
- *others in doubt*: the same as one of these, but wherever an end is left there is another node of which not all names are known, and
  which could have this one: it speaks the type, or has a name that is known only in part. That nobody is there is not known then.
- *all still meet somebody*: two nodes are parted, but every end that was has another partner: it hears another source of the same type.
  Nothing in the launch file tells that from what was meant.
- *other end not here*: nobody in the launch is parted. The name that changes had its partner outside of the launch, in a node that is
  not known, or nowhere; or the mistake only brings nodes together.

Not counted is a change after which everybody has the partners that he had: another remap is drawn then, and how many such there were is
printed. Nothing else is taken from the count: what nobody could tell stays in the last column.

With ``--missed`` those that are not told are listed, with ``--untouched`` what is said of the files as they are; with ``--sources`` the
sources of the repositories are read too, and what is read is kept in that directory. The exit status is 1 where nothing can be seeded
or nothing is told: then the bench itself is broken.
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
from launchlint.evaluate.ros1.launch import evaluate
from launchlint.finding import Finding, Severity
from launchlint.graph.connections import OFFERS, ConnectionGraph, Endpoint
from launchlint.rules.registry import RULES
from launchlint.source import Span
from launchlint.syntax.tree import Document, Element
from launchlint.workspace.discovery import discover

ABOUT = ("LL60", "LL61")
WAYS = ("misspelt from", "misspelt to", "deleted", "wrong node", "wrong namespace")
HINTED = "all, with infos"
"""The line in which what an info says counts, too."""
TRIES = 20
LETTERS = "abcdefghijklmnopqrstuvwxyz"
EFFECTS = ("two loose ends", "one loose end", "others in doubt", "all still meet somebody", "other end not here")
BOTH_KNOWN = EFFECTS[:2]
"""What the first column is: both ends known, whoever else is there."""
End = tuple[str, str, str]
"""A node, its role and the name in its code."""
Talk = dict[End, frozenset[End]]


class Seed(NamedTuple):
    """One mistake: the text of the file with it."""

    file: str
    way: str
    was: str
    text: str


class Outcome(NamedTuple):
    """What became of it: its effect (one of EFFECTS), the new findings above info, and infos; ``all_known``: all nodes of the launch."""

    seed: Seed
    all_known: bool
    effect: str
    told: tuple[Finding, ...]
    hinted: tuple[Finding, ...]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("corpus")
    parser.add_argument("--library", action="append", default=[])
    parser.add_argument("--sources", metavar="DIRECTORY", help="read the sources of the repositories, and keep what is read there")
    parser.add_argument("--files", type=int, default=300)
    parser.add_argument("--seed", type=int, default=12)
    parser.add_argument("--missed", type=int, default=0, metavar="N", help="list the first N that are not told")
    parser.add_argument("--untouched", action="store_true", help="list what is said of the files as they are")
    options = parser.parse_args()
    chance = random.Random(options.seed)
    outcomes: list[Outcome] = []
    untouched: dict[str, tuple[Finding, ...]] = {}
    idle: Counter[str] = Counter()
    pools = [_files(options.corpus, name, tuple(options.library), options.sources) for name in sorted(os.listdir(options.corpus))]
    files = [pair for pool in pools for pair in pool]
    chance.shuffle(files)
    for checker, file in files:
        if len(untouched) == options.files:
            break
        for found, known in _outcomes(checker, file, chance, idle):
            outcomes.append(found)
            untouched[file] = known
    print(table(outcomes))
    print("drawn anew since nobody's partners changed:", ", ".join(f"{way} {idle[way]}" for way in WAYS))
    _print_untouched(untouched, listed=options.untouched)
    missed = [each for each in outcomes if not each.told]
    for each in missed[: options.missed]:
        print(f"  not told ({each.effect}): {each.seed.way}: {each.seed.file}: {each.seed.was}")
        for finding in each.hinted:
            print(f"      {finding.rule} info: {finding.message}")
    if not outcomes or not any(each.told for each in outcomes):
        sys.exit("nothing was told: the bench or the rules are broken")


def table(outcomes: list[Outcome]) -> str:
    """One line for each kind of mistake, and one for all: told of those with each effect, and of all."""
    known = sum(each.all_known for each in outcomes)
    files = {each.seed.file for each in outcomes}
    lines = [
        f"{len(outcomes)} mistakes in {len(files)} launch files; {known} where all nodes are known",
        f"{'':16}" + "".join(f"{title:>25}" for title in ("both ends known", *EFFECTS, "over all")),
    ]
    for way in (*WAYS, "all nodes known", "all", HINTED):
        rows = [each for each in outcomes if way in (each.seed.way, "all", HINTED) or (way == "all nodes known" and each.all_known)]
        cells = []
        columns = (BOTH_KNOWN, *((effect,) for effect in EFFECTS), EFFECTS)
        for part in ([each for each in rows if each.effect in effects] for effects in columns):
            told = sum(bool(each.told or (way == HINTED and each.hinted)) for each in part)
            cells.append(f"{told:5} of {len(part):4} {100 * told / max(len(part), 1):5.1f} %")
        lines.append(f"{way:16}" + "".join(f"{cell:>25}" for cell in cells))
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


def _files(corpus: str, name: str, libraries: tuple[str, ...], sources: str | None) -> list[tuple[EntryChecker, str]]:
    repository = os.path.join(corpus, name)
    if not os.path.isdir(repository):
        return []
    rules = frozenset(rule.id for rule in RULES if rule.id.startswith(ABOUT))
    kept = {"extract": sources is not None, "sources_cache": sources}
    checker = EntryChecker(Options(rules, (repository,), True, {}, repository, library=libraries)._replace(**kept))
    return [(checker, file) for file in discover([repository])]


def _outcomes(checker: EntryChecker, file: str, chance: random.Random, idle: Counter[str]) -> Iterator[tuple[Outcome, tuple[Finding, ...]]]:
    """One mistake of each kind in ``file``, where one can be made that changes who talks to whom, and what is said of the file as it is.

    ``idle`` counts, by kind, those that change nothing and are drawn anew.
    """
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
                idle[way] += seed is not None
                continue
            new = list(_new(_told(mutated, request), known))
            told = tuple(each for each in new if each.severity > Severity.INFO)
            yield (
                Outcome(
                    seed,
                    all_known,
                    effect(before, after, {} if after_graph is None else doubted(after_graph[0])),
                    told,
                    tuple(each for each in new if each.severity <= Severity.INFO),
                ),
                known,
            )
            break


def talk(graph: ConnectionGraph) -> Talk:
    """For each name in a node's code, and each place on the graph it leads to, who is at the other end."""
    found: Talk = {}
    for channel in graph.channels.values():
        for endpoint in (*channel.offers, *channel.uses):
            if endpoint.certain and not endpoint.is_plumbing:
                others = channel.uses if endpoint.role in OFFERS else channel.offers
                found[_end(endpoint)] = frozenset(_end(each) for each in others if each.certain and each.node != endpoint.node)
    return found


def _end(endpoint: Endpoint) -> End:
    return endpoint.node, endpoint.role, endpoint.declared


def doubted(graph: ConnectionGraph) -> dict[End, bool]:
    """Of each end with nobody at the other one, whether somebody of whom not all is known could be there."""
    found: dict[End, bool] = {}
    for channel in graph.channels.values():
        for endpoint in (*channel.offers, *channel.uses):
            offers = endpoint.role in OFFERS
            if not (channel.uses if offers else channel.offers):
                possible = (graph.may_use if offers else graph.may_offer)(channel.kind, channel.name, endpoint.type)
                found[_end(endpoint)] = any(each.node != endpoint.node for each in possible)
    return found


def effect(before: Talk, after: Talk, doubts: dict[End, bool]) -> str:
    """What a mistake does, one of EFFECTS; ``doubts`` as :func:`doubted` says."""
    parted = [(end, other) for end, others in before.items() for other in others - after.get(end, frozenset())]
    left = {end for pair in parted for end in pair if end in after and not after[end]}
    if left:
        if all(doubts.get(end, False) for end in left):
            return EFFECTS[2]
        return EFFECTS[0] if any(end in left and other in left for end, other in parted) else EFFECTS[1]
    return EFFECTS[3] if parted else EFFECTS[4]


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
