"""Headers that several programs include are read once, however many a program has."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path

import pytest

from launchlint.extract.cpp import files
from tests.cli.running import write

HEADERS = {f"include/part{number}.h": f"#pragma once\nint of_part{number}();\n" for number in range(20)}
INCLUDES = "".join(f'#include "part{number}.h"\n' for number in range(20))


def read(root: Path, program: str, trees: files.Trees) -> list[str]:
    """The files of a program."""
    source, include = str(root / "src" / program), str(root / "include")
    found, problems, missing = files.read_files((source,), (include,), str(root), (), trees)
    assert (problems, missing) == ([], [])
    return [each.path for each in found]


@pytest.mark.parametrize("most", [0, 300, 8 << 20])
def test_a_program_larger_than_what_is_kept_leaves_what_fits_to_the_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, most: int
) -> None:
    parsed: Counter[bytes] = Counter()

    def parse(data: bytes) -> files.Root:
        parsed[data] += 1
        return real(data)

    real = files.parse
    monkeypatch.setattr(files, "parse", parse)
    monkeypatch.setattr(files, "_MOST_KEPT", most)
    write(tmp_path, {**HEADERS, **{f"src/{name}.cpp": f"{INCLUDES}int {name};\n" for name in "abc"}})
    trees = files.Trees()
    expected = sorted(os.path.normpath(each) for each in HEADERS)
    for name in "abc":
        assert read(tmp_path, f"{name}.cpp", trees) == [*sorted(expected, key=lambda each: int(each[12:-2])), f"src/{name}.cpp"]
    times = [parsed[text.encode()] for text in HEADERS.values()]
    # What was read last is kept first: of 30 bytes a header, 300 keep ten, and each program reads the others again.
    kept = {0: 0, 300: 10, 8 << 20: 20}[most]
    assert sorted(times) == [1] * kept + [3] * (20 - kept)


def test_what_is_kept_of_programs_that_are_done_is_bounded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(files, "_MOST_KEPT", 1_000)
    write(tmp_path, {f"src/p{number}.cpp": f"int of_p{number};\n" * 20 for number in range(30)} | {"include/x.h": ""})
    trees = files.Trees()
    for number in range(30):
        read(tmp_path, f"p{number}.cpp", trees)
        trees.next_program()
        assert sum(size for _, size, _ in trees._kept) <= 1_000
