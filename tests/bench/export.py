"""``launchlint export`` on many files: does the real roslaunch start the same from what is exported?

``python -m tests.bench.export DIRECTORY [--every N] [--plain | --args-kept]``. The folders of DIRECTORY are repositories; a file sees the
packages of its own repository first. A required arg gets the value 1, which is a number, a truth value and a text. With ``--args-kept``
roslaunch also compares every configuration in which launchlint flips a condition. Each file is exported in this process; roslaunch loads
originals and exports in another one, and starts nothing.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from launchlint.evaluate.configurations import configurations
from launchlint.evaluate.problems import RequiredArgUnset
from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.export.flatten import flatten
from launchlint.export.plain import plain
from launchlint.export.written import CannotExport
from launchlint.fix.format.style import Style
from launchlint.workspace.packages import Packages
from tests.bench.corpus import launch_files
from tests.bench.timing import ros_python, table

PEER = Path(__file__).with_name("export_peer.py")
ENVIRONMENT = {
    "HOME": "/home/user",
    "USER": "user",
    "PATH": "/usr/bin:/bin",
    "LANG": "C.UTF-8",
    "ROS_DISTRO": "noetic",
    "ROS_MASTER_URI": "http://localhost:11311",
    "ROS_HOSTNAME": "localhost",
    "VALUE": "1",  # roslaunch's own example of $(env) asks for it
}
MODES = ("flatten", "plain", "args-kept")

Pairs = tuple[tuple[str, str], ...]


class Outcome(NamedTuple):
    """What became of one file: where it was exported to, and with which args original and export are started side by side."""

    file: str
    word: str
    exported: str = ""
    given: Pairs = ()
    started: tuple[Pairs, ...] = ()


def session_for(file: str, directory: Path) -> Session:
    """A session that sees the packages of the repository of ``file`` first, then those of the others, and nothing of this machine."""
    repository = Path(file).relative_to(directory).parts[0]
    packages = Packages((str(directory / repository), str(directory)), ENVIRONMENT, explicit=True)
    return Session(packages, ENVIRONMENT, str(directory))


def required(session: Session, file: str) -> Pairs:
    """A value for each arg that the file needs."""
    launch = evaluate(session, file).launch
    return tuple((problem.name, "1") for problem in launch.noticed(RequiredArgUnset))


def outcomes(files: Sequence[str], directory: Path, mode: str, scratch: Path) -> Iterator[Outcome]:
    """Export each file."""
    sessions: dict[str, Session] = {}
    for number, file in enumerate(files):
        repository = Path(file).relative_to(directory).parts[0]
        session = sessions.setdefault(repository, session_for(file, directory))
        given = required(session, file)
        if evaluate(session, file, given).launch.refused is not None:
            yield Outcome(file, "refused")
            continue
        try:
            if mode == "plain":
                data = plain(session, file, given, Style())
            else:
                data = flatten(session, file, given, Style(), args_kept=mode == "args-kept").data
        except CannotExport as error:
            yield Outcome(file, f"not exported: {error}")
            continue
        exported = scratch / f"{number}.launch"
        exported.write_bytes(data)
        started: tuple[Pairs, ...] = ((),)
        if mode == "args-kept":
            started = tuple(each.launch.given for each in configurations(session.with_text(file, data), file))
        yield Outcome(file, "exported", str(exported), given, started)


def words(pairs: Pairs) -> list[str]:
    """Args as roslaunch takes them."""
    return [f"{name}:={value}" for name, value in pairs]


def compare(found: Sequence[Outcome], interpreter: str, directory: Path, mode: str) -> list[tuple[Outcome, str]]:
    """What roslaunch says of each exported file: the empty text where it starts the same, else what differs or that it refuses it."""
    pairs = []
    for each in found:
        for started in each.started:
            both = tuple({**dict(each.given), **dict(started)}.items())
            after = each.given if mode == "plain" else started
            pairs.append({"original": each.file, "exported": each.exported, "given": words(both), "given_exported": words(after)})
    with tempfile.TemporaryDirectory() as temporary:
        result = os.path.join(temporary, "result.json")
        environment = {**ENVIRONMENT, "ROS_PACKAGE_PATH": str(directory)}
        command = [interpreter, "-W", "ignore", str(PEER), str(directory), result]
        subprocess.run(command, input=json.dumps(pairs).encode(), env=environment, check=True, stdout=subprocess.DEVNULL)
        answers = iter(json.loads(Path(result).read_text(encoding="utf-8")))
    told = []
    for each in found:
        mine = [next(answers) for _ in each.started]
        found_different = [answer["difference"] for answer in mine if answer["difference"] and (answer["loads"] or answer is mine[0])]
        told.append((each, found_different[0] if found_different else ""))
    return told


def main(arguments: Sequence[str] | None = None) -> int:
    """Export, compare, and print a table; status 1 where something differs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("directory", type=Path)
    parser.add_argument("--every", type=int, default=1, help="only every Nth file")
    parser.add_argument("--plain", dest="mode", action="store_const", const="plain", default="flatten")
    parser.add_argument("--args-kept", dest="mode", action="store_const", const="args-kept")
    options = parser.parse_args(arguments)
    interpreter = ros_python()
    if interpreter is None:
        raise SystemExit("no Python on this machine can import roslaunch (Debian: apt-get install python3-roslaunch)")
    directory = options.directory.resolve()
    with tempfile.TemporaryDirectory() as scratch:
        found = list(outcomes(launch_files(directory)[:: options.every], directory, options.mode, Path(scratch)))
        exported = [each for each in found if each.word == "exported"]
        told = compare(exported, interpreter, directory, options.mode)
    count = Counter("equal" if not text else text.split(":")[0] for _, text in told)
    rows = [
        ("files", str(len(found))),
        ("refused by roslaunch, as launchlint sees it", str(sum(each.word == "refused" for each in found))),
        ("exported", str(len(exported))),
        ("configurations compared", str(sum(len(each.started) for each in exported))),
        *((text, str(number)) for text, number in count.most_common()),
    ]
    print(table((options.mode, ""), rows))
    for each in found:
        if each.word.startswith("not exported"):
            print(f"{each.file}: {each.word}")
    for each, text in told:
        if text:
            print(f"{each.file}: {text}")
    return int(any(text and not text.startswith("roslaunch refuses the original") for _, text in told))


if __name__ == "__main__":
    sys.exit(main())
