"""Of one rule as many findings are listed as anybody reads; where there are more, that is said, and everything else goes on."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from launchlint.check.listing import MOST_LISTED, Listing
from launchlint.finding import Finding, Location, Severity
from tests.cli.running import run, write

OTHER = '<node name="a b" pkg="p" type="t"/>'
MORE = f"more than {MOST_LISTED:,} findings of LL103 unknown-tag: from here on they are not listed"


def checked(directory: Path, text: str, *words: str) -> list[dict[str, object]]:
    """The findings of a launch file that holds ``text``."""
    write(directory, {"x.launch": f"<launch>\n{text}\n</launch>\n"})
    found: list[dict[str, object]] = json.loads(run(directory, "check", "--no-cache", "--format", "json", *words, "x.launch").output)[
        "findings"
    ]
    return found


def tags(count: int) -> list[str]:
    """Tags that roslaunch does not know, all of them different: equal ones are one cause, and told as one."""
    return [f"<anything{number}/>" for number in range(count)]


def test_findings_of_a_rule_end_where_nobody_reads_on(tmp_path: Path) -> None:
    found = checked(tmp_path, "\n".join([*tags(MOST_LISTED + 50), OTHER]))
    counts = Counter(each["rule"] for each in found)
    assert counts["LL103"] == MOST_LISTED
    (end,) = [each for each in found if each["rule"] == "LL216"]
    assert (end["message"], end["severity"], end["line"]) == (MORE, "info", MOST_LISTED + 2)
    assert counts["LL302"] == 1  # other rules go on


def test_what_fits_is_listed_and_nothing_is_said_of_more(tmp_path: Path) -> None:
    counts = Counter(each["rule"] for each in checked(tmp_path, "\n".join(tags(MOST_LISTED))))
    assert (counts["LL103"], counts["LL216"]) == (MOST_LISTED, 0)


def test_who_did_not_ask_for_the_rule_is_told_nothing_of_it(tmp_path: Path) -> None:
    found = checked(tmp_path, "\n".join(tags(MOST_LISTED + 1)), "--select", "LL103")
    assert Counter(each["rule"] for each in found) == {"LL103": MOST_LISTED}


def test_a_rule_that_has_said_enough_is_not_asked_for_more() -> None:
    asked = 0

    def endless() -> Iterator[Finding]:
        nonlocal asked
        while True:
            asked += 1
            yield Finding("LL103", "unknown-tag", Severity.WARNING, Location("x.launch", 1, 1, 1, 1, asked, asked, ""), "unknown")

    listing = Listing()
    assert len(list(listing.listed(endless()))) == MOST_LISTED
    assert (asked, listing.is_full("LL103"), listing.is_full("LL104")) == (MOST_LISTED + 1, True, False)
