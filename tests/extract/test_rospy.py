"""Small programs and all that is found in them.

A case is a file: the program, a line of dashes, what is found. ``--update`` writes the latter.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.extract.fact import Fact
from launchlint.extract.python.modules import PackageModules
from launchlint.extract.python.program import Extracted, python_program

CASES = Path(__file__).parent / "rospy_cases"
LINE = "-----\n"


def shown(found: Extracted) -> str:
    """What was found, a line each."""
    lines = [told(fact) for fact in found.facts]
    lines += [f"? {doubt.category}: {doubt.reason} @{doubt.path}:{doubt.line}" for doubt in found.doubts]
    if found.options:
        lines.append(f"options {found.options}")
    return "".join(f"{line}\n" for line in lines)


def told(fact: Fact) -> str:
    """A fact in one line: what is not at its default."""
    words = [fact.category, fact.name, fact.type]
    for name in ("role", "latched", "queue", "default", "value_type", "when"):
        value = getattr(fact, name)
        if name == "default":
            words += [] if value is None else [f"default={value!r}"]
        elif value not in ("", False, None, "start"):
            words.append(f"{name}={value}")
    place = f"@{fact.line}" if fact.path == "node.py" else f"@{fact.path}:{fact.line}"
    return " ".join(filter(None, [*words, place, f"if {fact.condition}" if fact.condition else ""]))


def follow(directory: Path, source: str) -> Extracted:
    """What ``source`` does, alone in a package."""
    (directory / "node.py").write_text(source, encoding="utf-8")
    return python_program(str(directory / "node.py"), str(directory), str(directory), PackageModules({str(directory): "p"}))


@pytest.mark.parametrize("case", sorted(CASES.glob("*.txt")), ids=lambda case: case.stem)
def test_program(case: Path, tmp_path: Path, update: bool) -> None:
    source, _, expected = case.read_text(encoding="utf-8").partition(LINE)
    found = shown(follow(tmp_path, source))
    if update:
        case.write_text(source + LINE + found, encoding="utf-8")
    else:
        assert found == expected


@pytest.mark.parametrize("case", sorted(CASES.glob("*.txt")), ids=lambda case: case.stem)
def test_the_same_program_twice_is_the_same(case: Path, tmp_path: Path) -> None:
    source = case.read_text(encoding="utf-8").partition(LINE)[0]
    assert follow(tmp_path, source) == follow(tmp_path, source)
