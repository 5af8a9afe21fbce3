"""docs/library-format.md is true: its example is a library, and it names every key there is and every template."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from launchlint.library.condition import QUESTIONS
from launchlint.library.format import INTERFACES, INTERFACES_2, PACKAGE, PACKAGE_2, PROGRAM, PROGRAM_2, QOS, VARIANT, VARIANT_2
from launchlint.library.inspection import inspect
from launchlint.library.template import SLOTS

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "library-format.md").read_text(encoding="utf-8")
OF_PROBES = {"args", "env", "remap", "run", "hash", "build", "launch"}
"""Keys in which a probe writes down how it ran a node; nobody writes or reads them."""


def examples() -> list[str]:
    return [str(block) for block in re.findall(r"^```json\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)]


def keys() -> Iterator[str]:
    shapes = (
        PACKAGE,
        PROGRAM,
        VARIANT,
        *INTERFACES.values(),
        *PACKAGE_2.shapes.values(),
        PROGRAM_2,
        VARIANT_2,
        *INTERFACES_2.values(),
        QOS,
    )
    for shape in shapes:
        yield from shape.keys


def test_each_example_is_a_library() -> None:
    assert [inspect(each.encode(), "example.json")[1] for each in examples()] == [[], []]


def test_every_key_is_explained() -> None:
    assert sorted(key for key in set(keys()) - OF_PROBES if f"`{key}`" not in PAGE and f'"{key}"' not in PAGE) == []


def test_every_template_and_question_is_explained() -> None:
    assert [slot for slot in SLOTS if f"`{{{slot}" not in PAGE] == []
    assert [question for question in (*QUESTIONS, "not", "all", "any", "text") if f'{{"{question}": ' not in PAGE] == []


def test_every_link_leads_to_a_heading() -> None:
    headings = {re.sub(r"[^\w -]", "", line).lower().replace(" ", "-") for line in re.findall(r"^## (.*)$", PAGE, re.MULTILINE)}
    assert [link for link in re.findall(r"\]\(#([\w-]+)\)", PAGE) if link not in headings] == []
