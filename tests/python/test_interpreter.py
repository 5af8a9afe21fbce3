"""The interpreter by itself: programs that know nothing of ROS, with a recogniser made for the test."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from launchlint.python import standard
from launchlint.python.call import Call
from launchlint.python.interpreter import Interpreter
from launchlint.python.memory import Ended, Exhausted
from launchlint.python.modules import ModuleFinder
from launchlint.python.source import SourceError, parse, parse_text
from launchlint.python.values import MISSING, UNKNOWN, Choice, External, Function, Handle, Instance, Map, Scope, Seq, Value


class Shop:
    """Knows the module ``shop``: ``shop.Apple(weight)`` gives an object with a weight and the method ``eaten()``."""

    run: Interpreter

    def call(self, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        made = Call(self.run, name, positional, keywords, node, scope)
        if name == "shop.Apple":
            return Handle("apple", {"weight": made.get(0, "weight", 1), "line": made.line})
        handler = standard.HANDLERS.get(name)
        return UNKNOWN if handler is None else handler(made)

    def attribute(self, name: str, member: str) -> Value:
        return standard.attribute(name, member)

    def member(self, receiver: Handle, name: str) -> Value:
        return receiver.state["weight"] if name == "weight" else MISSING

    def method(
        self, receiver: Handle, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        return "core" if (receiver.kind, name) == ("apple", "eaten") else UNKNOWN

    def inherited(
        self, base: str, instance: Instance, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> None:
        self.run.store(instance.attributes, "from", base)

    def inherited_method(
        self, name: str, instance: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        return f"inherited {name}"

    def text_method(self, spelled: str, name: str, positional: Sequence[Value]) -> Value:
        return MISSING

    def stays_outside(self, name: str) -> bool:
        return name == "shop"

    def is_generated(self, name: str) -> bool:
        return name.endswith(".made")

    def is_harmless(self, spelled: str) -> bool:
        return False

    def from_stars(self, name: str, stars: list[str]) -> Value:
        return External(f"{stars[0]}.{name}") if stars else UNKNOWN

    def is_silent(self, name: str) -> bool:
        return True

    def is_open(self, name: str) -> bool:
        return False

    def matters(self, name: str) -> bool:
        return False

    def mattering(self, name: str) -> list[str]:
        return []


class Noting(Interpreter):
    """Keeps the doubts."""

    def __init__(self, directory: str) -> None:
        shop = Shop()
        super().__init__(shop, directory, "", ModuleFinder({}), directory)
        shop.run = self
        self.said: list[tuple[str, str, int]] = []

    def doubt(self, reason: str, path: str, line: int) -> None:
        self.said.append((reason, path, line))


def ran(tmp_path: Path, text: str, **files: str) -> dict[Any, Value]:
    """The variables of a program when it has come to its end."""
    for name, content in files.items():
        (tmp_path / f"{name}.py").write_text(content, encoding="utf-8")
    path = tmp_path / "program.py"
    path.write_text(text, encoding="utf-8")
    run = Noting(str(tmp_path))
    main = run.main(str(path), parse(str(path)))
    run.execute(run_body(text), main.scope)
    return main.scope.variables


def run_body(text: str) -> list[ast.stmt]:
    return parse_text(text).tree.body


@pytest.mark.parametrize(
    ("program", "value"),
    [
        ("x = 'a' + 'b'", "ab"),
        ("x = '%s/%d' % ('a', 2)", "a/2"),
        ("x = f'{1 + 1}'.strip()", "2"),
        ("x = 0\nfor n in range(4):\n    x += n", 6),
        ("x = 1\nwhile x < 5:\n    x = x * 2", 8),
        ("def f(a, *b, c=3, **d):\n    return a + len(b) + c + d['e']\nx = f(1, 2, 2, e=10)", 16),
        (
            "class A:\n    def f(self):\n        return 'A'\nclass B(A):\n    def f(self):\n        return super().f() + 'B'\nx = B().f()",
            "AB",
        ),
        ("x = [n for n in (1, 2, 3) if n != 2][-1]", 3),
        ("x = {'a': {'b': 5}}['a']['b']", 5),
        ("def f():\n    n = 1\n    def g():\n        nonlocal n\n        n = 2\n    g()\n    return n\nx = f()", 2),
        ("import os\nx = os.path.join('a', 'b')", UNKNOWN),
        ("import shop\nx = shop.Apple(weight=7).weight", 7),
        ("from shop import Apple as Fruit\nx = Fruit().eaten()", "core"),
        ("from shop import *\nx = Apple(2).weight", 2),
        ("import shop\nclass A(shop.Apple):\n    pass\nx = A().ripen()", "inherited shop.Apple.ripen"),
        ("from copy import deepcopy\nx = deepcopy('a')", "a"),
        ("print 'Python 2'\nx = 0777", 511),
        ("x = unheard_of()", UNKNOWN),
        ("x = open('/etc/passwd').read()", UNKNOWN),
    ],
)
def test_what_a_program_makes(tmp_path: Path, program: str, value: Value) -> None:
    assert ran(tmp_path, program)["x"] == value


def test_both_ways_through_what_is_not_known(tmp_path: Path) -> None:
    x = ran(tmp_path, "import os\nif os.getenv('A'):\n    x = 1\nelse:\n    x = 2\n")["x"]
    assert isinstance(x, Choice)
    assert x.alternatives == (("os.getenv('A')", 1), ("not os.getenv('A')", 2))


def test_what_was_written_on_one_way_is_there_on_no_other(tmp_path: Path) -> None:
    found = ran(tmp_path, "import os\nx = []\nif os.getenv('A'):\n    x.append('a')\ny = x\n")["x"]
    assert isinstance(found, Seq)
    assert [each.alternatives for each in found.items] == [(("os.getenv('A')", "a"),)]


def test_modules_are_followed_where_their_source_is(tmp_path: Path) -> None:
    found = ran(tmp_path, "from beside import twice\nx = twice('a')\n", beside="def twice(a):\n    return a * 2\n")
    assert found["x"] == "aa"
    assert isinstance(found["twice"], Function)


def test_a_module_that_stays_outside_is_not_followed(tmp_path: Path) -> None:
    assert ran(tmp_path, "import shop\nx = shop.y\n", shop="y = 1\n")["x"] == External("shop.y")


def test_what_is_made_says_where(tmp_path: Path) -> None:
    assert ran(tmp_path, "import shop\n\n\nx = shop.Apple()\n")["x"].state["line"] == 4


def test_a_broken_module_is_a_doubt_at_its_import(tmp_path: Path) -> None:
    (tmp_path / "broken.py").write_text("def (:\n", encoding="utf-8")
    run = Noting(str(tmp_path))
    path = tmp_path / "program.py"
    path.write_text("\nimport broken\n", encoding="utf-8")
    main = run.main(str(path), parse(str(path)))
    run.execute(run_body("\nimport broken\n"), main.scope)
    assert run.said == [("the module broken is not Python: line 1: invalid syntax", "program.py", 2)]


def test_a_program_ends(tmp_path: Path) -> None:
    variables = ran(tmp_path, "x = 1\nimport sys\nsys.exit()\nx = 2\n")
    assert variables["x"] == 1


def test_steps_are_counted(tmp_path: Path) -> None:
    loops = "".join(f"{' ' * n}for a{n} in range(60):\n" for n in range(5))
    with pytest.raises(Exhausted):
        ran(tmp_path, f"{loops}     x = a0\n")


def test_dicts_and_lists_can_be_changed(tmp_path: Path) -> None:
    found = ran(tmp_path, "x = {}\nx['a'] = [1]\nx['a'].append(2)\nx.update(b=3)\n")["x"]
    assert isinstance(found, Map)
    assert (found.entries["a"].items, found.entries["b"], found.complete) == ([1, 2], 3, True)


def test_an_end_in_a_function_ends_its_caller(tmp_path: Path) -> None:
    run = Noting(str(tmp_path))
    path = tmp_path / "program.py"
    path.write_text("def f():\n    raise ValueError\n", encoding="utf-8")
    main = run.main(str(path), parse(str(path)))
    run.execute(run_body("def f():\n    raise ValueError\n"), main.scope)
    with pytest.raises(Ended):
        run.call(main.scope.variables["f"], [], {}, ast.Pass(lineno=1, col_offset=0), main.scope)


def test_what_is_no_python() -> None:
    with pytest.raises(SourceError, match="is not Python: line 1"):
        parse_text("def (:\n")
