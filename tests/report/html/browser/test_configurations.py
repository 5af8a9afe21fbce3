"""Any combination of args: the tree, the tables, the counts and the drawing follow, and the command that starts it is there."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import boxes, drawn, fragment

pytestmark = pytest.mark.chromium


def choose(page, **args: str) -> None:
    page.locator(".popup summary").click()
    for name in ("sim", "gui", "log"):
        page.locator(f".args select[data-name={name}]").select_option(args.get(name, "default"))
    page.keyboard.press("Escape")
    drawn(page)


@pytest.mark.parametrize(
    ("args", "nodes"),
    [
        ({}, ["always"]),
        ({"sim": "true"}, ["always", "sim"]),
        ({"gui": "true"}, ["always"]),
        ({"sim": "true", "gui": "true"}, ["always", "both", "quiet", "sim"]),
        ({"log": "true"}, ["always", "log"]),
        ({"gui": "true", "log": "true"}, ["always", "log"]),
        ({"sim": "true", "log": "true"}, ["always", "log", "sim"]),
        ({"sim": "true", "gui": "true", "log": "true"}, ["always", "both", "log", "sim"]),
    ],
)
def test_any_combination(open_report, args, nodes):
    page = open_report("choices")
    choose(page, **args)
    assert [label.split(",")[0].rpartition("/")[2] for label in boxes(page)] == nodes
    assert sorted(page.locator("#tree .node .label").all_inner_texts()) == nodes
    page.locator(".openers").get_by_role("button", name="Nodes").click()
    assert page.locator("#table-nodes tr[data-index] td:first-child").all_inner_texts() == [f"/{each}" for each in nodes]
    number = f"{len(nodes)} node{'s' if len(nodes) > 1 else ''}"
    assert number in page.locator("#counts li").all_inner_texts()
    given = "".join(f" {name}:=true" for name in ("sim", "gui", "log") if name in args)
    told = page.locator(".args pre").text_content().split(" ")
    assert told[:3] == ["roslaunch", "demo", "choices.launch"]
    assert sorted(told[3:]) == sorted(given.split())


def test_a_combination_has_an_address(open_report):
    page = open_report("choices")
    choose(page, sim="true", log="true")
    assert "configuration=" in fragment(page)
    again = open_report("choices", f"#{fragment(page)}")
    assert sorted(again.locator("#tree .node .label").all_inner_texts()) == ["always", "log", "sim"]


def test_the_head_counts_what_is_started_without_other_args_as_check_does(open_report):
    page = open_report("choices")
    counts = page.locator("#counts li").all_inner_texts()
    assert counts[counts.index("1 node") + 1] == "4 more with other args"
