"""Facts of small C++ programs as lines of text, so that a test shows a source and all that is found in it side by side."""

from __future__ import annotations

import json
from pathlib import Path

from launchlint.extract.cpp import cpp_program
from launchlint.extract.fact import Doubt, Fact


def program(root: Path, files: str | dict[str, str], entry: str | None = None) -> tuple[tuple[Fact, ...], tuple[Doubt, ...]]:
    """What is found in the given files: all that end in .cpp are the sources. One text is ``main.cpp``."""
    files = {"main.cpp": files} if isinstance(files, str) else files
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    sources = [str(root / name) for name in files if name.endswith(".cpp")]
    return cpp_program(sources, [str(root / "include")], str(root), entry)[:2]


def spelled(fact: Fact) -> str:
    """One fact on one line: category, name, type, line, and what else is known of it."""
    parts = [fact.category, fact.name, fact.type or fact.value_type or "-", str(fact.line)]
    parts += [fact.role] if fact.role else []
    parts += [f"transport={fact.transport}"] if fact.transport else []
    parts += ["latched"] if fact.latched else []
    parts += [f"queue={fact.queue}"] if fact.queue is not None else []
    parts += [f"default={json.dumps(fact.default)}"] if fact.default is not None else []
    parts += [f"when={fact.when}"] if fact.when != "start" else []
    parts += [f"if {fact.condition}"] if fact.condition else []
    return " ".join(parts)


def lines(text: str) -> list[str]:
    """The lines of an expectation."""
    return [line.strip() for line in text.strip().splitlines() if line.strip()]


def in_main(body: str, before: str = "") -> str:
    """A program whose main() starts at line 1, with ``body`` in lines of its own from line 2 on."""
    return f"int main(int argc, char** argv) {{\n{body.strip()}\n}}\n{before}"
