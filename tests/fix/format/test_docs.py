"""docs/format.md shows what the formatter does."""

from __future__ import annotations

import re
from pathlib import Path

from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.syntax.ros1.dialect import TAGS

_ROW = re.compile(r"^ *\| ([a-z]+) \| ([a-z_ -]+) \|$", re.MULTILINE)


def test_the_example_is_what_comes_out(root: Path) -> None:
    before, after, table = re.findall(r"```xml\n(.*?)```", (root / "docs/format.md").read_text(), re.DOTALL)
    assert formatted(before.encode(), "a.launch", Style()).data.decode() == after
    assert formatted(table.encode(), "a.launch", Style()).data.decode() == table


def test_the_order_of_attributes_is_that_of_the_dialect(root: Path) -> None:
    rows = dict(_ROW.findall((root / "docs/format.md").read_text()))
    named = {tag: " ".join(rule.known) for tag, rule in TAGS.items() if rule.known and not rule.status and tag != "launch"}
    assert {tag: order for tag, order in rows.items() if tag != "tag"} == named
