"""Every rule's page: what it claims of its examples is true, and it has the parts that readers look for."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from launchlint.evaluate.ros2 import parameter_problems
from launchlint.evaluate.ros2 import problems as ros2_results
from launchlint.finding import Severity
from launchlint.rules.page import page
from launchlint.rules.registry import RULES, Entry, speaking_of
from launchlint.syntax.ros2 import problems as ros2_problems
from launchlint.syntax.ros2.python import problems as python_problems
from tests.rules.pipeline import check, commit

SECTIONS = ("Why it matters", "Example", "Use instead")
every_rule = pytest.mark.parametrize("entry", RULES, ids=lambda entry: entry.id)


def findings(entry: Entry, section: str, directory: Path, select: str) -> list[dict[str, Any]]:
    """What a check of the files of one section finds; for rules that compare revisions, ``Use instead`` is what was before."""
    options = []
    if entry.view == "base":
        write(entry, "Use instead", directory)
        options = ["--base", commit(directory)]
    write(entry, section, directory)
    _, output = check(directory, "-v", "--select", select, *options, "--format", "json", ".")
    found: list[dict[str, Any]] = json.loads(output)["findings"]
    return found


def write(entry: Entry, section: str, directory: Path) -> None:
    """The files of one section, written into a directory."""
    examples = [example for example in page(entry).examples if example.section == section]
    assert examples, f"the page has no example under {section}"
    for example in examples:
        file = directory / example.file
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(example.text, encoding="utf-8")
        if example.text.startswith("#!"):
            file.chmod(0o755)


@every_rule
def test_registry_and_rule_agree(entry: Entry) -> None:
    module = entry.load()
    rule = module.RULE
    assert (rule.id, rule.name, rule.severity, rule.default) == (entry.id, entry.name, entry.severity, entry.default)
    assert module.__name__.rpartition(".")[2] == entry.name.replace("-", "_")
    assert entry.on or entry.ros2 or entry.view != "problem"
    if entry.on or entry.ros2:
        problem = module.tell.__annotations__["problem"]
        assert sorted(problem.split(" | ")) == sorted((*(kind.__name__ for kind in entry.on), *entry.ros2))
    assert entry.view == "problem" or callable(module.check)


def test_kinds_of_ros2_are_told_by_name() -> None:
    """The registry names them, so that a check of ROS 1 does not import them."""
    rooms = (ros2_problems, python_problems, ros2_results, parameter_problems)
    kinds = [kind for room in rooms for kind in vars(room).values() if isinstance(kind, type) and kind.__module__ == room.__name__]
    assert [
        kind.__name__ for kind in vars(ros2_problems).values() if isinstance(kind, type) and kind in kinds and not speaking_of(kind)
    ] == []
    assert len(kinds) > 10
    assert [entry.id for entry in speaking_of(ros2_problems.OfRos1)] == ["LL112"]
    named = {name for entry in RULES for name in entry.ros2}
    assert named - {kind.__name__ for kind in kinds} == set()


@every_rule
def test_page_has_its_parts(entry: Entry) -> None:
    text = page(entry)
    assert re.findall(r"^## (.+)$", text.markdown, re.MULTILINE)[: len(SECTIONS)] == list(SECTIONS)
    assert re.fullmatch(r"[A-Z`<$](?:[^.!?]|[.!?](?!\s))*\.", text.summary), f"the summary is one sentence: {text.summary}"
    assert text.markdown.count("```") % 2 == 0


@every_rule
def test_example_shows_the_mistake(entry: Entry, tmp_path: Path) -> None:
    found = findings(entry, "Example", tmp_path, entry.id)
    assert (entry.id, entry.severity.word) in {(finding["rule"], finding["severity"]) for finding in found}


@every_rule
def test_use_instead_is_in_order(entry: Entry, tmp_path: Path) -> None:
    found = findings(entry, "Use instead", tmp_path, "all")
    assert [finding for finding in found if finding["rule"] == entry.id or finding["severity"] == Severity.ERROR.word] == []
