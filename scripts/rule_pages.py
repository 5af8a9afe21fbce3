"""Write the rule pages under ``docs/rules`` from the docstrings of the rules, or check that they are what those say.

``python scripts/rule_pages.py`` writes one page per rule and the index; ``--check`` writes nothing, names each page that is missing,
out of date or without a rule, and exits with status 1 where there is one. The docstring of a rule is its documentation; nothing in
``docs/rules`` is edited by hand.
"""

from __future__ import annotations

import argparse
import inspect
import sys
from pathlib import Path
from typing import NamedTuple

from launchlint.finding import Severity
from launchlint.model import ROS1, ROS2
from launchlint.rules.registry import RULES
from launchlint.rules.rule import Rule

PAGES = Path(__file__).resolve().parent.parent / "docs" / "rules"

CATEGORIES = {
    "1": "XML and dialect",
    "2": "Args and substitutions",
    "3": "Nodes, names and machines",
    "4": "Includes",
    "5": "Params",
    "6": "Remaps, connections and frames",
    "7": "Packages",
    "8": "Style and normal form",
    "9": "ROS 2",
}

TODAY = {
    "refuses": "roslaunch refuses the file",
    "reports": "roslaunch accepts it, roslaunch-check reports it",
    "nobody": "nobody",
}

FIX = {
    "safe": "yes, with `--fix`",
    "unsafe": "yes, with `--fix --unsafe-fixes` (may change what the file means)",
    "never": "no",
}


SPEAKS = {(ROS1,): "ROS 1", (ROS2,): "ROS 2", (ROS1, ROS2): "both"}
"""Which launch files a rule looks at, by the dialects that the registry names."""


class Page(NamedTuple):
    """One rule with the text of its docstring; ``speaks`` says of which dialect's launch files."""

    rule: Rule
    text: str
    speaks: str

    @property
    def summary(self) -> str:
        """The first sentence of the docstring, on one line and without its full stop."""
        first_paragraph = self.text.split("\n\n", 1)[0]
        return " ".join(first_paragraph.split()).removesuffix(".")


def rule_pages() -> list[Page]:
    """All rules of the registry, by ID."""
    pages = []
    for entry in RULES:
        module = entry.load()
        rule: Rule = module.RULE
        declared = (entry.id, entry.name, entry.severity, entry.default)
        if (rule.id, rule.name, rule.severity, rule.default) != declared:
            raise SystemExit(f"{entry.module}: the registry says {declared}, the module {rule}")
        if not module.__doc__:
            raise SystemExit(f"{entry.module}: a rule without a docstring has no page")
        pages.append(Page(rule, inspect.cleandoc(module.__doc__), SPEAKS[entry.dialects]))
    return sorted(pages, key=lambda page: page.rule.id)


def page_text(page: Page) -> str:
    """The Markdown of one rule's page."""
    rule = page.rule
    return "\n".join(
        [
            f"# {rule.id} {rule.name}",
            "",
            "| severity | launch files of | who tells you without launchlint | can be fixed | on by default |",
            "|---|---|---|---|---|",
            f"| {rule.severity.word} | {_of(page)} | {_today(page)} | {FIX[rule.fixable]} | {'yes' if rule.default else 'no, select it'} |",
            "",
            page.text,
            "",
        ]
    )


def _of(page: Page) -> str:
    return "ROS 1 and ROS 2" if page.speaks == "both" else page.speaks


def _today(page: Page) -> str:
    """Who tells people now, by the name of the program that starts such launch files."""
    return TODAY[page.rule.roslaunch].replace("roslaunch", "ros2 launch") if page.speaks == "ROS 2" else TODAY[page.rule.roslaunch]


def index_text(pages: list[Page]) -> str:
    """The Markdown of the index: one table per category."""
    lines = ["# The rules", "", "`launchlint explain LL301` shows a page on the terminal, `launchlint rules` the list.", "", *_levels(), ""]
    for digit, title in CATEGORIES.items():
        members = [page for page in pages if page.rule.id[2] == digit]
        if not members:
            continue
        lines += [f"## {digit}xx {title}", "", "| rule | name | severity | ROS | what |", "|---|---|---|---|---|"]
        for page in members:
            rule, summary = page.rule, page.summary.replace("|", "\\|")
            lines.append(f"| [{rule.id}]({rule.id}.md) | {rule.name} | {rule.severity.word} | {_ROS[page.speaks]} | {summary} |")
        lines.append("")
    return "\n".join(lines)


_ROS = {"ROS 1": "1", "ROS 2": "2", "both": "1, 2"}


def _levels() -> list[str]:
    """What each level means, and how a finding can have another one than its rule."""
    return [
        "## What a level means",
        "",
        "| level | a finding of this level says |",
        "|---|---|",
        *(f"| **{level.word}** | {level.meaning} |" for level in sorted(Severity, reverse=True)),
        "",
        "The tables below and the rule pages name the level that a rule usually has. A finding is milder where less is certain or less",
        "happens, and an error where roslaunch refuses the very case: its note says so. SARIF has `error`, `warning` and `note` for the",
        "three; `severity:` in `.launchlint.yaml` sets another level for all findings of a rule, `--fail-on` says which one fails a job.",
        "",
        "What is wrong in a copy of somebody else's project is for its people to mend. Where only launch files of the copy lead to it,",
        "a warning there is an info, and all that is refused there is one warning for the project: nobody who works on the workspace",
        "is known to start it. In copies of public packages with their list of changes it is an info, too. As soon as a launch file",
        "outside leads to it, it counts as anywhere. Nothing says plainly that a package is a copy, so that two things have to come",
        "together. First, most other packages of the workspace have other maintainers and authors. Second, the package is called as a",
        "public one and has a list of changes (`CHANGELOG.rst`); or it lies in a directory that has what only the root of a repository",
        "has (`.travis.yml`, `.github`, `.gitlab-ci.yml` and the like, or a README or released packages, with a licence), or is called",
        "as an unpacked archive (`…-noetic-devel`), or has a README and packages most of which have a page in ROS's wiki; or it lies",
        "in one that has a README and a package of the directory's own name, and other packages here have nobody's name but what",
        "`catkin_create_pkg` writes (`…@todo.todo`). Where a public package only names another repository, or people where others here",
        "have nobody's name, it may well have been changed here: then just what is untidy (args that nobody reads, a missing",
        "dependency and the like) is an info. What lies in no package, but in a directory with a README and a licence of its own beside",
        "several packages, is such a project, too: a driver whose `package.xml` gets that name when it is built.",
        "",
        "The column *ROS* says whose launch files a rule looks at: those of ROS 1, of ROS 2, or both. Where a page of both speaks of",
        "roslaunch, ros2 launch does the same, unless the page says otherwise.",
    ]


def expected_pages() -> dict[str, str]:
    """File name to content, for everything that belongs into ``docs/rules``."""
    pages = rule_pages()
    return {"index.md": index_text(pages), **{f"{page.rule.id}.md": page_text(page) for page in pages}}


def main() -> int:
    """Write or check the pages; return the exit status."""
    parser = argparse.ArgumentParser(description="Write docs/rules from the docstrings of the rules.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit with status 1 where a page is not what its rule says")
    check: bool = parser.parse_args().check
    expected = expected_pages()
    present = {path.name: path.read_text(encoding="utf-8") for path in sorted(PAGES.glob("*.md"))}
    complaints = [
        *(f"docs/rules/{name} is missing" for name in expected if name not in present),
        *(f"docs/rules/{name} is out of date" for name in expected if name in present and present[name] != expected[name]),
        *(f"docs/rules/{name} belongs to no rule" for name in present if name not in expected),
    ]
    if check:
        for complaint in complaints:
            print(complaint)
        if complaints:
            print("run: python scripts/rule_pages.py")
            return 1
        print(f"docs/rules: {len(expected) - 1} pages, all as their rules say")
        return 0
    PAGES.mkdir(parents=True, exist_ok=True)
    for name in present.keys() - expected.keys():
        (PAGES / name).unlink()
    for name, text in expected.items():
        (PAGES / name).write_text(text, encoding="utf-8")
    print(f"docs/rules: wrote the index and {len(expected) - 1} pages")
    return 0


if __name__ == "__main__":
    sys.exit(main())
