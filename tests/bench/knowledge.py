"""How much of real launch files the bundled library knows: ``python -m tests.bench.knowledge CORPUS [--missing N]``.

``CORPUS`` holds one directory per repository, of ROS 1 or of ROS 2. Each ``<node>`` and ``<test>`` element, and each node that a launch
file in Python makes, is one instance, counted once, as it is evaluated in its own file (else in the files that include it) with default
args. Printed: instances by what is known, how many of them
are known completely (nothing is open but params), and the programs most often unknown.
"""

from __future__ import annotations

import argparse
import os
from collections import Counter

from launchlint.check.entry import EntryChecker
from launchlint.check.options import EntryRequest, Options
from launchlint.dialects.door import evaluate
from launchlint.graph.connect import connect
from launchlint.graph.topology import place_text
from launchlint.workspace.discovery import discover

RANK = {"unknown": 0, "template": 1, "known": 2}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("corpus")
    parser.add_argument("--missing", type=int, default=40, metavar="N", help="list the N programs most often unknown")
    options = parser.parse_args()
    counts: Counter[str] = Counter()
    missing: Counter[str] = Counter()
    reasons: Counter[str] = Counter()
    completely = 0
    for name in sorted(os.listdir(options.corpus)):
        repository = os.path.join(options.corpus, name)
        if not os.path.isdir(repository):
            continue
        checker = EntryChecker(Options(frozenset(), (repository,), True, {}, repository))
        best: dict[str, tuple[int, bool, str, str, str]] = {}
        for file in discover([repository]):
            checker.session.begin_entry()
            launch = evaluate(checker.session, EntryRequest(file, file).at, ()).launch
            for instance in connect(launch, checker.library).instances:
                place = place_text(instance.node.origin.place)
                complete = instance.knowledge != "unknown" and not set(instance.open) - {"params"} and not instance.doubts
                found = (RANK[instance.knowledge], complete, instance.knowledge, instance.program, instance.reason)
                best[place] = max(found, best.get(place, found))
        for _, complete, knowledge, program, reason in best.values():
            counts[knowledge] += 1
            completely += complete
            if knowledge == "unknown":
                missing[program] += 1
                reasons["no library knows it" if reason.startswith("no library") else reason] += 1
    total = sum(counts.values())
    print(f"{total} node instances")
    for knowledge in ("known", "template", "unknown"):
        print(f"  {knowledge:9} {counts[knowledge]:6} {100 * counts[knowledge] / max(total, 1):6.1f} %")
    print(f"  complete  {completely:6} {100 * completely / max(total, 1):6.1f} %")
    for reason, count in reasons.most_common():
        print(f"    {count:6} {reason}")
    for program, count in missing.most_common(options.missing):
        print(f"  {count:5} {program}")


if __name__ == "__main__":
    main()
