"""Small Python programs made up at random, from a grammar: what launch files do with strings, numbers, lists, dicts, functions and classes.

They ask for nothing outside but ``flag()``, which is true or false, nobody knows which.
"""

from __future__ import annotations

from random import Random

NAMES = ("a", "b", "c", "d", "e")
_STRINGS = ("''", "'x'", "'robot_1'", "'a/b.yaml'", "' pad '", "'1,2,3'", "'{}-{}'", "'%s=%d'", "'True'", "'7'")
_NUMBERS = ("0", "1", "2", "3", "(-1)", "7", "0.5", "2.0", "True", "False", "None")
_METHODS = (
    "upper()",
    "strip()",
    "split(',')",
    "split('/')",
    "rsplit('_', 1)",
    "replace('a', 'bb')",
    "startswith('r')",
    "endswith(('l', '1'))",
    "find('b')",
    "join(['p', 'q'])",
    "join(str(i) for i in range(3))",
    "title()",
    "zfill(4)",
    "partition('_')",
    "isdigit()",
    "count('a')",
    "format(1, 2)",
    "format('l', b'' and 0)",
    "removeprefix('ro')",
    "index('z')",
    "center(5, '*')",
    "splitlines()",
    "swapcase()",
    "lower()",
)
_LIST_METHODS = (
    "append({0})",
    "extend([{0}, {1}])",
    "insert(1, {0})",
    "pop()",
    "pop(0)",
    "remove({0})",
    "clear()",
    "reverse()",
    "sort()",
    "sort(key=str)",
    "sort(key=str, reverse=True)",
    "index({0})",
    "count({0})",
    "copy()",
    "update({{'k': {0}}})",
    "setdefault('k', {0})",
    "get('k')",
    "get({0}, 5)",
    "pop('k', None)",
    "keys()",
    "items()",
    "values()",
    "add({0})",
    "discard({0})",
    "union([{0}])",
    "popitem()",
)
_CALLS = (
    "len({0})",
    "str({0})",
    "int({0})",
    "float({0})",
    "bool({0})",
    "list({0})",
    "tuple({0})",
    "sorted({0})",
    "sorted(set({0}))",
    "sum({0})",
    "any({0})",
    "all({0})",
    "min({0})",
    "max({0}, default=0)",
    "max({0}, {1})",
    "list(reversed({0}))",
    "list(enumerate({0}))",
    "list(zip({0}, {1}))",
    "dict(zip({0}, {1}))",
    "list(map(str, {0}))",
    "list(filter(None, {0}))",
    "list(filter(lambda v: v != {1}, {0}))",
    "round({0})",
    "round({0}, 1)",
    "isinstance({0}, str)",
    "isinstance({0}, (int, list))",
    "type({0}) is str",
    "type({0}).__name__ if False else 1",
    "abs({0})",
    "divmod({0}, 2)",
    "repr({0})",
    "next(iter({0}))",
    "next(iter({0}), None)",
    "dict({0})",
    "dict(a={0}, **{{'b': {1}}})",
    "len(set({0}))",
    "chr(65)",
    "hash(1) and {0}",
    "callable({0})",
    "pow({0}, 2)",
    "format({0}, '>5')",
    "getattr({0}, 'nothing', 3)",
    "[*{0}, {1}]",
    "{{**{0}, 'z': {1}}}",
    "sum([[1], [2]], [])",
)
_OPERATORS = ("+", "-", "*", "/", "//", "%", "**", "&", "|", "<<")
_COMPARISONS = ("==", "!=", "<", "<=", ">", ">=", "in", "not in", "is", "is not")
_ERRORS = ("ValueError", "KeyError", "TypeError", "(KeyError, IndexError)", "Exception", "LookupError", "ZeroDivisionError", "RuntimeError")


class Programs:
    """Makes one program; ``flags`` is how often it may ask ``flag()``."""

    def __init__(self, random: Random, flags: int) -> None:
        self._random = random
        self._flags = flags
        self._lines: list[str] = []
        self._functions: list[str] = []
        self._classes: list[str] = []
        self._counter = 0

    def program(self) -> str:
        for name in NAMES:
            self._lines.append(f"{name} = {self.value(2)}")
        for _ in range(self._random.randint(2, 7)):
            if self._random.random() < 0.2:
                self.statement(0, 2)
                continue
            begin = len(self._lines)
            self.statement(0, 2)
            if self._lines[begin].startswith(("def ", "class ")):
                continue
            self._lines[begin:] = [
                "try:",
                *(f"    {each}" for each in self._lines[begin:]),
                "except Exception:",
                f"    {self.name()} = 'failed'",
            ]
        return "\n".join(self._lines) + "\n"

    def pick(self, *options: str) -> str:
        return self._random.choice(options)

    def name(self) -> str:
        return self._random.choice(NAMES)

    # -- expressions ---------------------------------------------------------------------------------------------------

    def value(self, depth: int) -> str:
        """A literal."""
        kind = self._random.randint(0, 6)
        if depth == 0 or kind < 2:
            return self.pick(*_STRINGS, *_NUMBERS)
        items = ", ".join(self.value(depth - 1) for _ in range(self._random.randint(0, 3)))
        if kind == 2:
            return f"({items},)" if items else "()"
        if kind in (3, 4):
            return f"[{items}]"
        if kind == 5:
            return (
                f"{{{', '.join(f'{self.pick(*_STRINGS, *_NUMBERS)}: {self.value(depth - 1)}' for _ in range(self._random.randint(0, 3)))}}}"
            )
        return f"{{{', '.join(self.pick(*_STRINGS, *_NUMBERS) for _ in range(self._random.randint(1, 3)))}}}"

    def expression(self, depth: int) -> str:
        if depth == 0:
            return self.pick(self.name(), self.name(), self.pick(*_STRINGS, *_NUMBERS))
        one, two = self.expression(depth - 1), self.expression(depth - 1)
        kind = self._random.randint(0, 15)
        if kind == 0:
            return f"({one} {self.pick(*_OPERATORS)} {two})"
        if kind == 1:
            return f"({one} {self.pick(*_COMPARISONS)} {two})"
        if kind == 2:
            return f"({one} {self.pick('and', 'or')} {two})"
        if kind == 3:
            return f"({one} if {self.condition(depth - 1)} else {two})"
        if kind in (4, 5):
            return self.pick(*_CALLS).format(one, two)
        if kind == 6:
            return f"{self.pick(self.name(), *_STRINGS)}.{self.pick(*_METHODS)}"
        if kind == 7:
            return f"({one})[{self.pick('0', '-1', '1', '1:', ':2', '::-1', repr('k'), two)}]"
        if kind == 8:
            return self.comprehension(one, two)
        if kind == 9:
            return f"f'{{{self.name()}}}/{{{self.name()}{self.pick('', '!r', '!s')}}}'"
        if kind == 10:
            return f"'{self.pick('%s', '%r', '%s %s', '%d', '%05.1f')}' % ({one},{self.pick('', f' {two}')})"
        if kind == 11:
            return f"{self.name()}.{self.pick(*_LIST_METHODS).format(one, two)}"
        if kind == 12 and self._functions:
            return self.call(one, two)
        if kind == 13:
            return f"(lambda p, q={one}: {self.pick('p', 'q', '[p, q]', 'p or q')})({two})"
        if kind == 14:
            return f"({self.pick('not', '-')} {one})"
        return self.pick(one, f"{one} < {self.name()} < {two}", one)

    def call(self, one: str, two: str) -> str:
        given = self.pick(one, f"{one}, {two}", f"*{one}", f"{one}, q={two}", f"q={one}", f"**{one}")
        return f"{self._random.choice(self._functions)}({given})"

    def comprehension(self, one: str, two: str) -> str:
        test = self.pick("", "", f" if v != {two}", " if v", f" if {self.condition(0)}")
        one = f"({one})"
        return self.pick(
            f"[v for v in {one}{test}]",
            f"[(v, {two}) for v in {one}{test}]",
            f"{{v: {two} for v in {one}{test}}}",
            f"sorted({{str(v) for v in {one}{test}}})",
            f"[v for w in {one} for v in w{test}]",
            f"list(str(v) for v in {one}{test})",
            f"[n for n, v in enumerate({one}){test}]",
            f"{{k: v for k, v in {one}.items(){test}}}",
        )

    def condition(self, depth: int) -> str:
        if self._flags and self._random.random() < 0.5:
            self._flags -= 1
            return self.pick("flag()", "not flag()", f"flag() and {self.name()}", f"{self.name()} == 1 or flag()")
        return self.expression(depth)

    # -- statements ----------------------------------------------------------------------------------------------------

    def line(self, indent: int, text: str) -> None:
        self._lines.append("    " * indent + text)

    def block(self, indent: int, depth: int, *ends: str) -> None:
        for _ in range(self._random.randint(1, 3)):
            self.statement(indent, depth)
        if ends and self._random.random() < 0.5:
            self.line(indent, self._random.choice(ends))

    def statement(self, indent: int, depth: int, *ends: str) -> None:
        kind = self._random.randint(0, 17) if depth > 0 else self._random.randint(0, 7)
        name = self.name()
        if kind < 3:
            self.line(indent, f"{name} = {self.expression(2)}")
        elif kind == 3:
            self.line(indent, f"{name} {self.pick('+=', '-=', '*=', '|=', '%=')} {self.expression(1)}")
        elif kind in (4, 5):
            self.line(indent, f"{name}.{self.pick(*_LIST_METHODS).format(self.expression(0), self.expression(0))}")
        elif kind == 6:
            self.line(indent, f"{name}[{self.pick('0', '-1', repr('k'), '1:2', self.expression(0))}] = {self.expression(1)}")
        elif kind == 7:
            self.line(
                indent,
                self.pick(
                    f"{name}, {self.name()} = {self.expression(1)}",
                    f"{name}, *{self.name()} = {self.expression(1)}",
                    f"del {name}[{self.pick('0', '-1:', repr('k'))}]",
                    f"assert {self.condition(1)}",
                    f"{name} = {self.name()}",
                    f"{name} = ({self.name()} := {self.expression(1)})",
                    f"{name} = [({self.name()} := v) for v in {self.name()}]",
                    f"raise {self.pick('ValueError', 'KeyError', 'RuntimeError')}({self.expression(0)})" if depth < 2 else "pass",
                ),
            )
        elif kind in (8, 9, 10):
            self.line(indent, f"if {self.condition(1)}:")
            self.block(indent + 1, depth - 1, *ends)
            if self._random.random() < 0.5:
                self.line(indent, "else:")
                self.block(indent + 1, depth - 1, *ends)
        elif kind in (11, 12):
            self.line(
                indent,
                f"for {self.pick(name, f'{name}, {self.name()}')} in {self.pick('range(3)', 'enumerate([4, 5])', self.expression(1))}:",
            )
            self.loop(indent, depth, ends)
        elif kind == 13:
            self._counter += 1
            self.line(indent, f"n{self._counter} = 0")
            self.line(indent, f"while n{self._counter} < 3{self.pick('', f' and {self.condition(0)}')}:")
            self.line(indent + 1, f"n{self._counter} += 1")
            self.loop(indent, depth, ends)
        elif kind == 14:
            self.line(indent, "try:")
            self.block(indent + 1, depth - 1, *ends)
            self.line(indent, f"except {self._random.choice(_ERRORS)} as error:")
            self.line(indent + 1, f"{name} = {self.pick('str(type(error))[:0]', 'len(error.args)', '1')}")
            self.block(indent + 1, depth - 1, *ends)
            if self._random.random() < 0.3:
                self.line(indent, "else:")
                self.block(indent + 1, depth - 1, *ends)
            if self._random.random() < 0.3:
                self.line(indent, "finally:")
                self.block(indent + 1, depth - 1)
        elif kind == 15 and indent == 0:
            self.function(depth)
        elif kind == 16 and indent == 0:
            self.klass()
        else:
            self.match(indent, depth, ends)

    def loop(self, indent: int, depth: int, ends: tuple[str, ...]) -> None:
        self.block(indent + 1, depth - 1, *ends)
        if self._random.random() < 0.6:
            self.line(indent + 1, f"if {self.condition(1)}:")
            self.line(indent + 2, self.pick("break", "continue"))
            self.block(indent + 1, depth - 1, *ends)
        if self._random.random() < 0.3:
            self.line(indent, "else:")
            self.block(indent + 1, depth - 1, *ends)

    def function(self, depth: int) -> None:
        self._counter += 1
        name = f"f{self._counter}"
        self.line(0, f"def {name}({self.pick('p', 'p, q=1', '*p, q=2', 'p=3, **q', 'p, /, q=4')}):")
        for each in NAMES[:3]:
            self.line(1, f"{each} = {self.pick('p', 'q', self.value(1)) if each != 'b' else 'p'}")
        if self._random.random() < 0.3:
            self.line(1, "global d")
        else:
            self.line(1, "d = e = 1")
        self.line(1, "e = [p]")
        for _ in range(3):
            self.statement(1, depth - 1, f"return {self.name()}", f"return {self.expression(1)}", "return")
        if self._random.random() < 0.2:
            self.line(1, f"yield {self.name()}")
            self.line(1, f"yield from {self.pick('(1, 2)', self.name())}")
            self._lines.append(f"{self.name()} = list({name}(1))")
        else:
            self.line(1, f"return {self.expression(1)}")
            self._functions.append(name)

    def klass(self) -> None:
        self._counter += 1
        name, value = f"K{self._counter}", self.name()
        base = self._random.choice(self._classes) if self._classes and self._random.random() < 0.5 else ""
        self._lines += [
            f"class {name}({base}):",
            f"    kind = {self.expression(1)}",
            "    def __init__(self, p=1):",
            f"        {self.pick('super().__init__()', 'pass')}",
            f"        self.p = {self.expression(1)}",
            "    def get(self, more=()):",
            f"        return {self.pick('self.p', '[self.p, self.kind]', '(self.p, more)')}",
            "    @property",
            "    def twice(self):",
            "        return [self.p] * 2",
            "    @staticmethod",
            "    def still(p):",
            "        return [p]",
            "    @classmethod",
            "    def made(cls):",
            "        return cls(2)",
            f"o{self._counter} = {name}({self.pick('', self.expression(0))})",
            f"{value} = {self.pick(f'o{self._counter}.get()', f'o{self._counter}.twice', f'{name}.still(1)', f'{name}.made().p')}",
        ]
        self._classes.append(name)

    def match(self, indent: int, depth: int, ends: tuple[str, ...]) -> None:
        self.line(indent, f"match {self.expression(1)}:")
        for _ in range(self._random.randint(1, 3)):
            pattern = self.pick(
                "1", "'x'", "[v, w]", "[v, *w]", "(1 | 2) as v", "{'k': v}", "{'k': 1, **w}", "None", "str()", "int(v)", "True", "[]"
            )
            self.line(indent + 1, f"case {pattern}{self.pick('', '', f' if {self.condition(0)}')}:")
            self.block(indent + 2, depth - 1, *ends)
        if self._random.random() < 0.5:
            self.line(indent + 1, "case _:")
            self.block(indent + 2, depth - 1, *ends)
