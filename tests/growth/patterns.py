"""Texts on which a regular expression may take time by the square of what it reads, made from the expression itself.

``python -m tests.growth.patterns [--texts N]`` tries all regular expressions of launchlint, with as many texts for each as are asked for.
"""

from __future__ import annotations

import argparse
import ast
import importlib
import pkgutil
import re
import re._constants as kinds  # type: ignore[import-not-found]
import re._parser as parser  # type: ignore[import-not-found]
import signal
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

import launchlint

ROOT = Path(launchlint.__file__).parent
LENGTH = 50_000
"""Characters of a text: what grows by its square takes a billion steps, and all else a few hundred thousand."""
MOST_SECONDS = 2.0
"""Of processor, for one text."""
SEARCHING = frozenset(("search", "finditer", "findall", "split", "sub", "subn"))
AT_ONCE = ("match", "fullmatch")
NEVER_MATCHED = "\n!\x01"
OTHERS = "a 0\n\t<>\"'$(){}[]#/-_.,;:=\\!xZ"
"""What a set of all but some characters may stand for."""


class Found(NamedTuple):
    """A regular expression: where it is written, its name (empty where it has none), itself, and how it is used."""

    module: str
    line: int
    name: str
    pattern: re.Pattern[Any]
    uses: tuple[str, ...]

    @property
    def place(self) -> str:
        return f"{self.module}.{self.name}" if self.name else f"{self.module}, line {self.line}"


class _Slow(Exception):
    pass


def patterns() -> Iterator[Found]:
    """All regular expressions of launchlint but those that functions put together."""
    sources = {
        each.name: _source(each.name) for each in pkgutil.walk_packages(launchlint.__path__, "launchlint.") if "__main__" not in each.name
    }
    used: dict[str, set[tuple[str, str]]] = {}
    for module, source in sources.items():
        for name, use in re.findall(r"\b(\w+)\.(search|match|fullmatch|finditer|findall|split|subn?)\(", source):
            used.setdefault(name, set()).add((module, use))
    for module, source in sources.items():
        if not re.search(r"\blate\(|\bre\.", source):
            continue
        known = vars(importlib.import_module(module))
        tree = ast.parse(source)
        names = {
            id(each.value): each.targets[0].id
            for each in tree.body
            if isinstance(each, ast.Assign) and isinstance(each.targets[0], ast.Name)
        }
        for node in ast.walk(tree):
            called = ast.unparse(node.func) if isinstance(node, ast.Call) else ""
            if not isinstance(node, ast.Call) or not node.args or not (called == "late" or called.startswith("re.")):
                continue
            is_kept = called in ("late", "re.compile")
            if not is_kept and called.removeprefix("re.") not in (*SEARCHING, *AT_ONCE):
                continue
            pattern = _compiled(node, known, is_kept)
            if pattern is None:
                continue
            name = names.get(id(node), "")
            here = {use for where, use in used.get(name, ()) if where == module or not name.startswith("_")}
            uses = here or set(AT_ONCE) if is_kept else {called.removeprefix("re.")}
            yield Found(module, node.lineno, name, pattern, tuple(sorted({"finditer" if each in SEARCHING else each for each in uses})))


def _source(module: str) -> str:
    path = ROOT.parent.joinpath(*module.split("."))
    return (path / "__init__.py" if path.is_dir() else path.with_suffix(".py")).read_text(encoding="utf-8")


def _compiled(call: ast.Call, known: dict[str, Any], is_kept: bool) -> re.Pattern[Any] | None:
    """The regular expression that a call is given; None where it is worked out as the function runs."""
    given = [*call.args[1:], *(each.value for each in call.keywords if each.arg == "flags")]
    flags = next((each for each in given if is_kept or ast.unparse(each).startswith("re.")), None)
    try:
        text = eval(compile(ast.Expression(call.args[0]), "", "eval"), dict(known))  # noqa: S307 - launchlint's own source
        number = 0 if flags is None else eval(compile(ast.Expression(flags), "", "eval"), {**known, "re": re})  # noqa: S307
        return re.compile(text, number)
    except (NameError, TypeError, AttributeError, SyntaxError):
        return None


def slowest(found: Found, texts: int, seed: int = 0) -> tuple[float, str]:
    """The most seconds that one of so many texts took, and that text told in Python."""
    worst, told = 0.0, ""
    for start, repeated in _candidates(found.pattern, texts, Random(seed)):
        for end in (NEVER_MATCHED, ""):
            text: Any = start + repeated * (LENGTH // len(repeated)) + end
            if isinstance(found.pattern.pattern, bytes):
                text = text.encode("latin-1", "replace")
            for use in found.uses:
                seconds = _seconds(found.pattern, use, text)
                if seconds > worst:
                    worst, told = seconds, f"{use} of {start!r} + {repeated!r} * {LENGTH // len(repeated)} + {end!r}"
        if worst >= MOST_SECONDS:
            break
    return worst, told


def _seconds(pattern: re.Pattern[Any], use: str, text: Any) -> float:
    """How long it takes, :data:`MOST_SECONDS` at most."""

    def work() -> object:
        return sum(1 for _ in pattern.finditer(text)) if use == "finditer" else getattr(pattern, use)(text)

    before = signal.signal(signal.SIGVTALRM, _stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, MOST_SECONDS)
    begun = time.process_time()
    try:
        work()
    except _Slow:
        return MOST_SECONDS
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)
    return time.process_time() - begun


def _stop(number: int, frame: object) -> None:
    raise _Slow


def _candidates(pattern: re.Pattern[Any], count: int, random: Random) -> list[tuple[str, str]]:
    """What a text may begin with, and what is repeated in it: what parts of the expression match."""
    written = pattern.pattern.decode("latin-1") if isinstance(pattern.pattern, bytes) else pattern.pattern
    tree = parser.parse(written, pattern.flags & ~re.UNICODE)
    ahead: dict[tuple[str, str], None] = {}
    others: dict[tuple[str, str], None] = {}
    for _ in range(12):
        repeated: list[tuple[int, str]] = []
        sample = _sample(tree, {}, repeated, random)
        for at, body in repeated:
            ahead[sample[:at], body] = ahead["", sample[:at] + body] = ahead["", body] = None
        ahead["", sample] = None
        others.update(dict.fromkeys(("", sample[:end]) for end in range(1, min(len(sample), 12))))
    first, more = [each for each in ahead if each[1]], [each for each in others if each not in ahead]
    random.shuffle(first)
    random.shuffle(more)
    half = count - min(len(more), count // 3)
    return [*first[:half], *more[: count - min(len(first), half)]]


def _sample(tree: Any, groups: dict[int, str], repeated: list[tuple[int, str]], random: Random) -> str:
    """A text that the expression (or nearly that) matches; what it repeats, with its place, is noted in ``repeated``."""
    text = ""
    for kind, value in tree:
        if kind is kinds.LITERAL:
            text += chr(value)
        elif kind is kinds.NOT_LITERAL:
            text += _one_of([(kinds.NEGATE, None), (kinds.LITERAL, value)], random)
        elif kind is kinds.ANY:
            text += random.choice("a x-")
        elif kind is kinds.IN:
            text += _one_of(value, random)
        elif kind is kinds.BRANCH:
            text += _sample(random.choice(value[1]), groups, repeated, random)
        elif kind is kinds.SUBPATTERN:
            inner = _sample(value[-1], groups, [] if not text else repeated, random)
            groups[value[0]] = inner
            text += inner
        elif kind in (kinds.MAX_REPEAT, kinds.MIN_REPEAT):
            least, most, body = value
            if int(most) > 3:
                repeated.append((len(text), _sample(body, groups, [], random)))
            text += "".join(
                _sample(body, groups, repeated, random) for _ in range(random.randint(least, max(least, min(int(most), least + 3))))
            )
        elif kind is kinds.GROUPREF:
            text += groups.get(value, "")
    return text


def _one_of(items: Sequence[tuple[Any, Any]], random: Random) -> str:
    """A character of a set."""
    categories = {kinds.CATEGORY_DIGIT: "0129", kinds.CATEGORY_SPACE: " \n\t", kinds.CATEGORY_WORD: "aZ_0"}
    among: set[str] = set()
    for kind, value in items:
        if kind is kinds.LITERAL:
            among.add(chr(value))
        elif kind is kinds.RANGE:
            among.update(map(chr, range(value[0], min(value[1], value[0] + 200) + 1)))
        elif kind is kinds.CATEGORY:
            among.update(categories.get(value, "a-$ ;"))
    if items[0][0] is kinds.NEGATE:
        among = set(OTHERS) - among or {"\u2603"}
    return random.choice(sorted(among))


def main() -> int:
    """Try all, and print those that take long."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--texts", type=int, default=60, help="texts for each regular expression")
    arguments.add_argument("--seed", type=int, default=0)
    given = arguments.parse_args()
    status = 0
    for found in patterns():
        seconds, text = slowest(found, given.texts, given.seed)
        if seconds >= MOST_SECONDS / 4:
            status = 1
            print(f"{found.place}: {seconds:.2f} s: {text}\n    {found.pattern.pattern!r}", flush=True)
    return status


if __name__ == "__main__":
    sys.exit(main())
