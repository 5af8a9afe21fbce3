"""The page of a rule, made from its module's docstring: for ``launchlint explain``, the documentation and SARIF."""

from __future__ import annotations

import re

from launchlint.named_tuple import NamedTuple
from launchlint.rules.registry import Entry

_BLOCK = re.compile(r"^```(?P<info>[^\n`]*)\n(?P<text>.*?)(?:^```$|\Z)", re.MULTILINE | re.DOTALL)
_TELLS = {"refuses": "roslaunch refuses the file", "reports": "roslaunch-check reports it", "nobody": "nobody tells you today"}
_FIXES = {"safe": "--fix repairs it", "unsafe": "--unsafe-fixes repairs it", "never": "a person has to repair it"}


class Example(NamedTuple):
    """A fenced block of a page: ``file`` is the name it is checked under."""

    section: str
    file: str
    text: str


class Page(NamedTuple):
    """``summary`` is the first sentence; ``markdown`` the whole page; ``text`` the same for a terminal; ``examples`` its
    blocks in order.
    """

    summary: str
    markdown: str
    text: str
    examples: tuple[Example, ...]


def page(entry: Entry) -> Page:
    """The page of the rule ``entry``."""
    module = entry.load()
    body = (module.__doc__ or "").strip()
    rule = module.RULE
    summary = " ".join(body.split("\n\n", 1)[0].split())
    state = f"{rule.severity.word} · {_TELLS[rule.roslaunch]} · {_FIXES[rule.fixable]}" + ("" if rule.default else " · off by default")
    markdown = f"# {rule.id} {rule.name}\n\n*{state}*\n\n{body}\n"
    text = f"{rule.id} {rule.name}\n{state}\n\n{_plain(body)}\n"
    return Page(summary, markdown, text, tuple(_examples(body)))


def _examples(body: str) -> list[Example]:
    examples: list[Example] = []
    for match in _BLOCK.finditer(body):
        headings = re.findall(r"^## (.+)$", body[: match.start()], re.MULTILINE)
        words = match["info"].split()
        file = words[1] if len(words) > 1 else "example.launch"
        examples.append(Example(headings[-1] if headings else "", file, match["text"]))
    return examples


def _plain(body: str) -> str:
    """Markdown as plain text: headings in capitals, blocks indented."""
    lines: list[str] = []
    inside = False
    for line in body.splitlines():
        if line.startswith("```"):
            inside = not inside
            name = line[3:].split()[1:]
            if inside and name:
                lines.append(f"  {name[0]}:")
        elif inside:
            lines.append(f"    {line}".rstrip())
        else:
            lines.append(line[3:].upper() if line.startswith("## ") else line.replace("`", ""))
    return "\n".join(lines)
