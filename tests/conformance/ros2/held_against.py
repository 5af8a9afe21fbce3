"""Random workspaces: what the real front ends make of them, held against launchlint's model; differences are made small.

``python -m tests.conformance.ros2.held_against [--count N] [--seed N] [--show N] [--keep DIRECTORY]``; :mod:`.front_end` says what must be
there.
"""

from __future__ import annotations

import argparse
import collections
import json
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.report.launched import as_object
from launchlint.workspace.packages import Packages
from tests.conformance.ros2.front_end import WHY_NOT, Answer, FrontEnd, Question, front_end
from tests.conformance.ros2.random_workspace import Workspace, random_workspace

MOST_TRIES = 80
"""How often a difference is tried to be made smaller."""
AT_ONCE = 25
"""How many smaller workspaces are asked at once."""


def own_answer(real: FrontEnd, corpus: Path, directory: Path, workspace: Workspace) -> Answer:
    """What launchlint makes of a workspace that is written to ``directory``."""
    return launched(corpus, directory, workspace.entry, workspace.arguments, real.environment(), real.distro)


def launched(root: Path, directory: Path, entry: str, given: Mapping[str, str], variables: Mapping[str, str], distro: str) -> Answer:
    """What launchlint says is launched by a file in ``directory``, which has all packages; paths are shown from ``root`` on."""
    session = Session(Packages([str(directory)], variables, explicit=True), variables, str(root), distro=distro)
    file = str(directory / entry)
    launch = evaluate(session, file, tuple(given.items())).launch
    error = None if launch.refused is None else ("", launch.refused.kind)
    answer: Answer = json.loads(json.dumps(as_object(launch, file, error)))
    return answer


def differences(real: FrontEnd, workspaces: Sequence[Workspace]) -> list[tuple[str, Answer]]:
    """For each workspace the first difference, in words, and what the front end answered."""
    with tempfile.TemporaryDirectory() as name:
        corpus = Path(name).resolve()
        for number, each in enumerate(workspaces):
            each.write(corpus / f"w{number:05}")
        questions = [Question(f"w{number:05}/{each.entry}", each.arguments) for number, each in enumerate(workspaces)]
        answers = real.answers(corpus, questions)
        found = []
        for number, (each, answer) in enumerate(zip(workspaces, answers, strict=True)):
            own = own_answer(real, corpus, corpus / f"w{number:05}", each)
            judged = answer["verdict"] in ("ok", "error")
            found.append((real.difference(corpus, answer, own) if judged else "", answer))
    return found


def kind_of(difference: str) -> str:
    """What a difference is about, without the values: two of one kind have one cause, most likely."""
    return difference.split(": ROS ")[0].split("; launchlint:")[0].translate({ord(digit): None for digit in "0123456789"})[:60]


def shrunk(real: FrontEnd, workspace: Workspace, difference: str) -> tuple[Workspace, str, Answer]:
    """A workspace with as little as possible in which both sides still differ in the same way."""
    answer: Answer = {}
    start = 0
    for _ in range(MOST_TRIES):
        smaller = workspace.smaller()
        smaller = smaller[start:] + smaller[:start]
        for first in range(0, len(smaller), AT_ONCE):
            tried = smaller[first : first + AT_ONCE]
            judged = differences(real, tried)
            hit = next((n for n, (found, _) in enumerate(judged) if found and kind_of(found) == kind_of(difference)), None)
            if hit is not None:
                workspace, (difference, answer) = tried[hit], judged[hit]
                start = (start + first + hit) % len(smaller)
                break
        else:
            break
    return workspace, difference, answer


def run(real: FrontEnd, count: int, seed: int, show: int) -> Iterator[str]:
    """Tries ``count`` workspaces; yields what is to be printed."""
    verdicts: collections.Counter[str] = collections.Counter()
    kinds: dict[str, tuple[Workspace, str, int]] = {}
    different = 0
    for start in range(seed, seed + count, 250):
        workspaces = [random_workspace(number) for number in range(start, min(start + 250, seed + count))]
        for number, (each, (found, answer)) in enumerate(zip(workspaces, differences(real, workspaces), strict=True), start):
            verdicts[answer["verdict"]] += 1
            if found:
                different += 1
                kinds.setdefault(kind_of(found), (each, found, number))
    yield f"{count} workspaces, {dict(verdicts)}; {different} differ, in {len(kinds)} ways"
    yield from sorted(f"{number}: {found[:300]}" for _, found, number in kinds.values())
    for each, found, _ in list(kinds.values())[:show]:
        small, why, _ = shrunk(real, each, found)
        yield f"\n== {why}"
        with tempfile.TemporaryDirectory() as name:
            small.write(Path(name))
            for path in sorted(Path(name).rglob("*")):
                if (
                    path.is_file()
                    and path.name != "package.xml"
                    and any(str(path).endswith(file) for file in (*small.launch_files, *small.others))
                ):
                    yield f"-- {path.name} {small.arguments if str(path).endswith(small.entry) else ''}\n{path.read_text('utf-8')}"


def main() -> int:
    """See the module."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--show", type=int, default=20)
    options = parser.parse_args()
    real = front_end()
    if real is None:
        raise SystemExit(WHY_NOT)
    for text in run(real, options.count, options.seed, options.show):
        print(text, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
