"""Does ``check --fix`` change what real launch files start?

``python -m tests.bench.fixed_corpus DIRECTORY``. Each repository in ``DIRECTORY`` is copied; its launch files are evaluated (``launchlint
model``), repaired (``launchlint check --fix .``) and evaluated again. Printed are the files that loaded before and start something else
now, with what differs and every line that was changed in that repository, and the files that start a node, a test or an include more than
before. The exit status is 1 where there is any of the two. Files that were refused before may load afterwards; these are counted.
"""

from __future__ import annotations

import argparse
import difflib
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from tests.bench.corpus import LAUNCH_FILES
from tests.bench.timing import launchlint

PARTS = ("args", "nodes", "tests", "params", "clear_params", "machines", "executables", "files", "includes")
STARTED = ("nodes", "tests", "files")
ENVIRONMENT = {"HOME": "/home/user", "USER": "user", "ROS_DISTRO": "noetic", "CMAKE_PREFIX_PATH": "", "PATH": os.environ.get("PATH", "")}


class Changed(NamedTuple):
    """One launch file that loaded before: which parts of its model are others now, and of which there is more."""

    file: str
    parts: tuple[str, ...]
    more: tuple[str, ...]


class Result(NamedTuple):
    """One repository: how many launch files load before and afterwards, the files of text that fixes changed, and what that changes."""

    loaded: int
    loads: int
    lines: tuple[str, ...]
    changed: tuple[Changed, ...]
    fixed: int


def repaired(repository: Path, scratch: Path) -> Result:
    """Repair a copy of ``repository`` below ``scratch``, and compare."""
    copy = scratch / repository.name
    shutil.copytree(repository, copy, symlinks=True)
    files = sorted(
        os.path.join(parent, name) for parent, _, names in os.walk(copy) for name in names if name.endswith(LAUNCH_FILES)
    )  # a link to a launch file is one, too
    entries = scratch / "entries.json"
    entries.write_text(json.dumps([{"file": file} for file in files]), encoding="utf-8")
    before = list(models(copy, repository.parent, entries))
    run(copy, "check", "--fix", "--exit-zero", "--no-cache", "--format", "json", ".")
    after = list(models(copy, repository.parent, entries))
    lines = tuple(difference(repository, copy))
    changed = [found for one, other in zip(before, after, strict=True) if (found := compared(one, other, copy)) is not None]
    return Result(
        sum(one["verdict"] == "ok" for one in before),
        sum(other["verdict"] == "ok" for other in after),
        lines,
        tuple(changed),
        len({line for line in lines if line.startswith("+++ ")}),
    )


def models(copy: Path, others: Path, entries: Path) -> Iterator[dict[str, Any]]:
    """What each launch file starts without args; packages of the other repositories are found, too."""
    words = ("--workspace", str(copy), "--workspace", str(others), "--entries", str(entries))
    for line in run(copy, "model", "--format", "jsonl", *words).splitlines():
        yield json.loads(line)


def run(directory: Path, *words: str) -> str:
    """The output of launchlint, started in ``directory``."""
    done = subprocess.run(launchlint(*words), cwd=directory, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):  # 1: some launch file is refused
        raise SystemExit(f"{directory.name}: launchlint {words[0]} ended with status {done.returncode}: {done.stderr[-500:]}")
    return done.stdout


def compared(before: Mapping[str, Any], after: Mapping[str, Any], copy: Path) -> Changed | None:
    """What of a launch file that loaded is another now; ``None`` where nothing is."""
    if before["verdict"] != "ok":
        return None
    parts = tuple(part for part in ("verdict", *PARTS) if before.get(part) != after.get(part))
    more = tuple(part for part in STARTED if len(after.get(part) or ()) > len(before.get(part) or ()))
    return Changed(os.path.relpath(before["file"], copy), parts, more) if parts else None


def difference(repository: Path, copy: Path) -> Iterator[str]:
    """The changed lines of all files."""
    for parent, _, names in os.walk(copy):
        for name in sorted(names):
            file = Path(parent, name)
            original = repository / file.relative_to(copy)
            if file.is_symlink() or file.read_bytes() == original.read_bytes():
                continue
            texts = [each.read_text(encoding="utf-8", errors="replace").splitlines() for each in (original, file)]
            shown = str(file.relative_to(copy))
            yield from difflib.unified_diff(texts[0], texts[1], shown, shown, n=0, lineterm="")


def main() -> int:
    """Repair, compare, print, and return the exit status."""
    parser = argparse.ArgumentParser(description="Repair real repositories and compare what their launch files start.")
    parser.add_argument("directory", type=Path, help="where the repositories are")
    parser.add_argument("--lines", action="store_true", help="print every line that was changed, of all repositories")
    arguments = parser.parse_args()
    total: Counter[str] = Counter()
    for repository in sorted(path for path in arguments.directory.resolve().iterdir() if path.is_dir()):
        with tempfile.TemporaryDirectory(prefix="launchlint-fixed-") as scratch:
            result = repaired(repository, Path(scratch).resolve())
        total.update(
            repositories=1,
            loaded=result.loaded,
            loads=result.loads,
            texts=result.fixed,
            changed=len(result.changed),
            more=sum(bool(each.more) for each in result.changed),
        )
        for each in result.changed:
            more = f"; more: {', '.join(each.more)}" if each.more else ""
            print(f"{repository.name}/{each.file}: other {', '.join(each.parts)}{more}", flush=True)
        if arguments.lines or result.changed:
            print("\n".join(f"    {line}" for line in result.lines), flush=True)
    print(
        f"{total['repositories']} repositories: {total['loaded']} launch files load before, {total['loads']} afterwards; {total['texts']} "
        f"files were changed; of those that loaded {total['changed']} start something else, {total['more']} start or include more"
    )
    return 1 if total["changed"] or total["more"] else 0


if __name__ == "__main__":
    sys.exit(main())
