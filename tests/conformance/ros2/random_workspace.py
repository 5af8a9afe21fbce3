"""Random small workspaces of ROS 2: launch files that include each other, with everything launch knows, mostly right, sometimes wrong."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random
from typing import Any

from tests.conformance.ros2.tree import Tag, as_xml, as_yaml

PACKAGE = "<package format='3'><name>{}</name><version>0.0.0</version><description>d</description></package>\n"
WORDS = (
    "1",
    "0",
    "true",
    "false",
    "x",
    "2.5",
    "a b",
    "",
    "a/b",
    "007",
    "-3",
    "TRUE",
    "yes",
    "1e3",
    "it's",
    "[1, 2]",
    "n",
    "/abs",
    "x_1",
    "é",
)
PLAIN = ("1", "x", "2.5", "true", "a/b", "False", "0", "-3")
TRUTHS = ("true", "false", "1", "0", "True", " false ", "FALSE")
NAMESPACES = ("a", "b/c", "/", "/abs", "a/", "/abs/b/", "", "a_1")
TOPICS = ("x", "/x", "~/x", "y", "a/y", "/abs/x", "out", "{ns}", "x y")
PARAMETERS = ("p", "q", "a.p", "p.q", "use_sim_time", "r")
VARIABLES = ("SET", "HERE", "OTHER")
VALUES = (
    "1", "1.5", "true", "text", "'quoted'", "[1, 2]", "[1.5, 2]", "[a, b]", "[true, false]", "1e3", "y", "off", "0x1F", "010", "1_000",
    ".5", "1.", "inf", "", " padded ", "-7", "~", "null", "[]", "a: b", "{a: 1}", "[1, a]", "12:30", "2024-01-01", "\"1\"", "[[1]]",
    "a#b", "a #b", "- x", "*x", "&x y", "!x y",
)  # fmt: skip
TYPES = ("str", "int", "float", "bool", "list_of_str", "list_of_int", "list_of_float", "list_of_bool", "yaml")
RAW = (1, 1.5, True, False, "text", [1, 2], ["a", "b"], [True], [1.5, 2.0], "true", "1", [], ["1", "2"])
FILES = (
    "/**:\n  ros__parameters:\n    p: 1\n    q: two\n",
    "n1:\n  ros__parameters:\n    p: [1, 2]\n/abs/n2:\n  ros__parameters: {q: true, r: {s: 1.5}}\n",
    "/**:\n  n1:\n    ros__parameters: {p: 1e3}\n",
    "/*:\n  ros__parameters:\n    p: '$(var a0)'\n",
    "p: 1\nq: [a, b]\n",
    "",
    "/a:\n  n1:\n    ros__parameters:\n      p: yes\n      q: 010\n",
)
EXPRESSIONS = (
    "1 + 1", "'x' + 'y'", "2 > 1", "str(3)", "not True", "3 // 2", "1 / 4", "2 ** 3", "-7 % 3", "'a b'.split()", "'x' * 3", "len('abc')",
    "max(1, 2.0)", "pi", "sin(0)", "[1, 2][0]", "{'a': 1}['a']", "'a' in 'abc'", "True and 'x'", "None", "1 if True else 2",
    "round(2.567, 1)", "int('5') + 1", "float('1e3')", "'%s-%d' % ('a', 1)", "'{}'.format(1)", "'A'.lower()", "(1, 2)",
    "'a,b'.split(',')[1]", "abs(-1.5)", "sorted([2, 1])", "min([3, 1])", "bool('')", "1e3", "0x1F", "1 == 1.0", "'1' == 1", "any([0, 1])",
    "str(True).lower()", "'x'.upper() if 1 else 'y'", "1 < 2 < 3", "sqrt(16)", "'a'.replace('a', 'b')",
)  # fmt: skip
MISTAKES = (
    Tag("node", {"pkg": "pk", "exec": "e", "name": "a/b"}),
    Tag("node", {"pkg": "pk", "exec": "e", "namespace": "a-b"}),
    Tag("node", {"pkg": "nowhere", "exec": "e"}),
    Tag("node", {"pkg": "pk"}),
    Tag("node", {"pkg": "pk", "exec": "e", "type": "e"}),
    Tag("node", {"pkg": "pk", "exec": "e", "output": "both_"}),
    Tag("node", {"pkg": "pk", "exec": "e", "respawn": "yes"}),
    Tag("node", {"pkg": "pk", "exec": "e", "respawn_delay": "-1"}),
    Tag("node", {"pkg": "pk", "exec": "e", "args": "it's"}),
    Tag("node", {"pkg": "pk", "exec": "e"}, (Tag("param", {"name": "p"}),)),
    Tag("node", {"pkg": "pk", "exec": "e"}, (Tag("param", {"name": "p", "value": "x", "type": "int"}),)),
    Tag("node", {"pkg": "pk", "exec": "e"}, (Tag("remap", {"from": "x"}),)),
    Tag("node", {"pkg": "pk", "exec": "e", "if": "maybe"}),
    Tag("node", {"pkg": "pk", "exec": "e", "if": "1", "unless": "0"}),
    Tag("node_container", {"pkg": "pk", "exec": "e", "name": "c"}),
    Tag("load_composable_node", {"target": "c"}),
    Tag("include", {"file": "nowhere.launch.xml"}),
    Tag("let", {"name": "l", "value": "$(var nothing)"}),
    Tag("let", {"name": "l", "value": "$(env NOT_SET)"}),
    Tag("let", {"name": "l", "value": "$(find-pkg-share nowhere)"}),
    Tag("let", {"name": "l", "value": "$(var  x)"}),
    Tag("let", {"name": "l", "value": "$(vra x)"}),
    Tag("let", {"name": "l", "value": "$(eval nothing)"}),
    Tag("let", {"name": "l", "value": "$(not maybe)"}),
    Tag("let", {"name": "l", "value": "$(var x"}),
    Tag("let", {"name": "l", "value": "$(any true)"}),
    Tag("let", {"name": "l", "value": "$(file-content nowhere.txt)"}),
    Tag("arg", {"name": "needed"}),
    Tag("arg", {"name": "chosen", "default": "c"}, (Tag("choice", {"value": "a"}), Tag("choice", {"value": "b"}))),
    Tag("set_use_sim_time", {"value": "true"}),
    Tag("set_parameters_from_file", {"filename": "nowhere.yaml"}),
    Tag("set_parameter", {"name": "p", "value": "{a: 1}"}),
    Tag("timer", {"period": "soon"}),
    Tag("timer", {"period": "-1"}),
    Tag("timer", {}),
    Tag("group", {"ns": "x"}),
    Tag("push_ros_namespace", {"namespace": "a b"}),
    Tag("unknown", {}),
    Tag("append_env", {"name": "SET", "value": "x", "prepend": "maybe"}),
    Tag("unset_env", {"name": "NOT_SET"}),
)


@dataclass(frozen=True)
class Workspace:
    """Launch files by their paths in the package ``pk``, other files of it, and the arguments of the first launch file."""

    launch_files: dict[str, Tag]
    others: dict[str, str]
    arguments: dict[str, str]

    @property
    def entry(self) -> str:
        """The launch file that is started."""
        return f"pk/{next(iter(self.launch_files))}"

    def write(self, directory: Path) -> None:
        """Write all files below ``directory``."""
        files = {f"pk/{name}": as_yaml(tag) if name.endswith("yaml") else as_xml(tag) for name, tag in self.launch_files.items()}
        files |= {f"pk/{name}": text for name, text in self.others.items()}
        files |= {f"{name}/package.xml": PACKAGE.format(name) for name in ("pk", "other_pk")}
        for name, text in files.items():
            (directory / name).parent.mkdir(parents=True, exist_ok=True)
            (directory / name).write_text(text, "utf-8")

    def smaller(self) -> list[Workspace]:
        """This workspace with one thing less, the largest cuts first."""
        found = []
        for name, tag in self.launch_files.items():
            found += [replace(self, launch_files={**self.launch_files, name: less}) for less in tag.smaller()]
        found += [replace(self, launch_files={k: v for k, v in self.launch_files.items() if k != n}) for n in list(self.launch_files)[1:]]
        found += [replace(self, others={key: value for key, value in self.others.items() if key != name}) for name in self.others]
        found += [replace(self, arguments={key: value for key, value in self.arguments.items() if key != name}) for name in self.arguments]
        return found


class _Scope:
    """What can be read at one point: configurations of any kind, and those that are boolean."""

    def __init__(self, parent: _Scope | None = None) -> None:
        self.names: list[str] = [] if parent is None else list(parent.names)
        self.truths: list[str] = [] if parent is None else list(parent.truths)


class Generator:
    """Draws one workspace. ``mistakes``: the share of workspaces that may hold mistakes."""

    def __init__(self, random: Random, mistakes: float = 0.35, most: int = 7) -> None:
        self.random = random
        self.most = most
        self.wrong = random.random() < mistakes
        self.counter = 0
        self.containers: list[str] = []
        self.wanted: dict[str, tuple[list[str], list[str]]] = {}
        self.anywhere = _Scope()

    def workspace(self) -> Workspace:
        """A whole workspace; the entry file is drawn last, since it has to know what the others take."""
        random = self.random
        names = [
            f"launch/{name}.launch.{random.choice(('xml', 'xml', 'yaml'))}"
            for name in ("main", "one", "two")[: random.choice((1, 2, 2, 3))]
        ]
        drawn = {name: self.file(name) for name in reversed(names)}
        launch_files = {name: drawn[name] for name in names}
        others = {f"config/{number}.yaml": random.choice(FILES) for number in range(2)}
        others["config/text.txt"] = random.choice(("text\n", "1", "true", "a\nb\n"))
        needed, optional = self.wanted[names[0]]
        given = {name: self.plain(name) for name in needed}
        given |= {name: self.plain(name) for name in optional if random.random() < 0.3}
        if random.random() < 0.1:
            given["undeclared"] = "1"
        return Workspace(launch_files, others, given)

    def plain(self, name: str) -> str:
        """A value of an arg, without blanks."""
        return self.random.choice(TRUTHS[:5] if name.startswith("t") else PLAIN)

    def file(self, name: str) -> Tag:
        """One launch file."""
        random = self.random
        scope = _Scope()
        needed, optional, tags = [], [], []
        for number in range(random.randint(0, 4)):
            truth = random.random() < 0.4
            arg = f"{'t' if truth else 'a'}{number}"
            attributes: dict[str, Any] = {"name": arg}
            children: tuple[Tag, ...] = ()
            if random.random() < 0.25:
                needed.append(arg)
            else:
                optional.append(arg)
                attributes["default"] = random.choice(TRUTHS) if truth else self.value(scope)
            if random.random() < 0.2:
                attributes["description"] = random.choice(("what it is", "$(var a0) (", "it's"))
            if not truth and random.random() < 0.1:
                children = tuple(
                    Tag("choice", {"value": value}) for value in {*PLAIN, str(attributes.get("default", "x"))} if "$(" not in value
                )
                children = tuple(sorted(children, key=lambda child: str(child.attributes["value"])))
            tags.append(Tag("arg", attributes, children))
            (scope.truths if truth else scope.names).append(arg)
        tags += self.actions(scope, random.randint(1, self.most), 0)
        self.wanted[name] = (needed, optional)
        attributes = {"version": "1"} if random.random() < 0.1 and name.endswith("xml") else {}
        return Tag("launch", attributes, tuple(tags))

    def actions(self, scope: _Scope, count: int, depth: int) -> list[Tag]:
        """Some actions in one scope."""
        makers: list[Callable[[_Scope, int], Tag]] = [self.node] * 5 + [self.let] * 2 + [self.include] * 3 + [self.setting] * 4
        makers += [self.arg, self.container, self.load, self.executable, self.push, self.environment, self.environment, self.reset]
        if depth < 3:
            makers += [self.group] * 4 + [self.timer]
        return [
            self.random.choice(MISTAKES) if self.wrong and self.random.random() < 0.06 else self.random.choice(makers)(scope, depth)
            for _ in range(count)
        ]

    # -- values

    def value(self, scope: _Scope, depth: int = 0) -> str:
        """Text, with substitutions now and then."""
        random = self.random
        roll = random.random()
        if roll < 0.35 or depth > 2:
            return random.choice(WORDS)
        if roll < 0.6 and scope.names:
            return random.choice(("{0}", "x{0}", "{0}/{0}", "{0} y")).format(f"$(var {random.choice(scope.names)})")
        if roll < 0.66 and scope.truths:
            return f"$(var {random.choice(scope.truths)})"
        if roll < 0.72:
            return self.evaluation(scope)
        if roll < 0.76 and self.wrong and (self.anywhere.names or self.anywhere.truths):
            return f"$(var {random.choice(self.anywhere.names + self.anywhere.truths)})"
        return self.substitution(scope, depth)

    def word(self, scope: _Scope, depth: int) -> str:
        """A value as a word in a substitution."""
        value = self.value(scope, depth + 1)
        if value and not set(value) & set(" '\"()") and self.random.random() < 0.7:
            return value
        if "(" in value and "'" not in value and '"' not in value and " " in value and self.random.random() < 0.4:
            return value if value.startswith("$(") and value.endswith(")") and value.count("$(") == 1 else f"'{value}'"
        return f"'{value}'" if "'" not in value else f'"{value}"' if '"' not in value else "x"

    def substitution(self, scope: _Scope, depth: int) -> str:
        """One substitution, of any kind but ``eval``."""
        truth, word, random = self.truth, self.word, self.random
        name = random.choice((*scope.names, "undefined"))
        return random.choice(
            (
                lambda: f"$(var {name} {word(scope, depth)})",
                lambda: f"$(env {random.choice(VARIABLES)} {word(scope, depth)})",
                lambda: "$(env SET)",
                lambda: f"$(find-pkg-share {random.choice(('pk', 'other_pk'))})/x",
                lambda: "$(find-pkg-prefix pk)",
                lambda: "$(exec-in-pkg e pk)",
                lambda: "$(find-exec bash)",
                lambda: "$(dirname)",
                lambda: "$(filename)",
                lambda: random.choice(("$(log_dir)", "$(launch_log_dir)")),
                lambda: f"$(anon {random.choice(('x', 'a.b', 'my-name'))})",
                lambda: f"$(not {truth(scope)})",
                lambda: f"$({random.choice(('and', 'or'))} {truth(scope)} {truth(scope)})",
                lambda: f"$(if {truth(scope)} {word(scope, depth)})",
                lambda: f"$(if {truth(scope)} {word(scope, depth)} {word(scope, depth)})",
                lambda: f"$({random.choice(('equals', 'not-equals'))} {word(scope, depth)} {word(scope, depth)})",
                lambda: "$(file-content $(dirname)/../config/text.txt)",
                lambda: random.choice(("\\$(var x)", "$", "${x}", "$x", "a$(dirname)b", "\\\\", "a\\b", "'$(dirname)'", "$ (x)")),
            )
        )()

    def truth(self, scope: _Scope) -> str:
        """A word that is a boolean, with or without a substitution."""
        random = self.random
        roll = random.random()
        if roll < 0.5 and scope.truths:
            return f"$(var {random.choice(scope.truths)})"
        if roll < 0.65:
            return f"$(not {self.truth(scope)})"
        if roll < 0.7:
            return f"$(equals {random.choice(PLAIN)} {random.choice(PLAIN)})"
        return random.choice(("true", "false", "True", "1", "0", "yes", "off"))

    def evaluation(self, scope: _Scope) -> str:
        """An ``$(eval …)``."""
        random = self.random
        expression = random.choice(EXPRESSIONS)
        names = scope.names + scope.truths
        if names and random.random() < 0.5:
            name = random.choice(names)
            form = random.choice(
                (
                    "'$(var {0})' + 'z'",
                    "'$(var {0})' == 'x'",
                    "len('$(var {0})')",
                    "'$(var {0})'.lower() in ['true', '1']",
                    "'q' if '$(var {0})' else 'r'",
                )
            )
            expression = form.format(name)
        if random.random() < 0.5 and '"' not in expression:
            return f'$(eval "{expression}")'
        if "'" not in expression:
            return f"$(eval '{expression}')"
        return '$(eval "' + expression.replace('"', "\\'") + '")'

    def condition(self, scope: _Scope, share: float = 0.25) -> dict[str, Any]:
        """An ``if`` or ``unless``, or nothing."""
        if self.random.random() >= share:
            return {}
        name = self.random.choice(("if", "unless"))
        roll = self.random.random()
        if roll < 0.5 and scope.truths:
            return {name: f"$(var {self.random.choice(scope.truths)})"}
        if roll < 0.75:
            return {name: self.random.choice(("$(not {})", "$(and {} true)", "$(or {} false)")).format(self.truth(scope))}
        if roll < 0.85:
            return {name: f"$(equals {self.word(scope, 1)} {self.word(scope, 1)})"}
        if roll < 0.9 and scope.names:
            return {name: f"$(eval \"'$(var {self.random.choice(scope.names)})' == 'x'\")"}
        return {name: self.random.choice(TRUTHS)}

    def namespace(self) -> dict[str, Any]:
        """A ``namespace``, or none."""
        return {"namespace": self.random.choice(NAMESPACES)} if self.random.random() < 0.3 else {}

    # -- actions

    def named(self) -> str:
        """A name of a node."""
        self.counter += 1
        return self.random.choice((f"n{self.counter}", f"n{self.counter}", "n1", "$(anon n)"))

    def process(self, scope: _Scope) -> dict[str, Any]:
        """Attributes of what is started."""
        random = self.random
        choices: tuple[Callable[[], dict[str, Any]], ...] = (
            lambda: {"output": random.choice(("screen", "log", "both", "own_log", "full"))},
            lambda: {"respawn": random.choice(("true", "false", "True", "$(not false)")), "respawn_delay": random.choice((2.0, 0.5))},
            lambda: {"cwd": self.value(scope)},
            lambda: {"launch-prefix": random.choice(("nice", "xterm -e", "gdb -ex run --args", "$(env SET)"))},
            lambda: {"on_exit": "shutdown"},
            lambda: {"shell": random.choice(("true", "false"))},
            lambda: {"emulate_tty": random.choice(("true", "false"))},
            lambda: {"sigterm_timeout": 3.0, "sigkill_timeout": 1.5, "respawn_max_retries": 3},
        )
        return random.choice(choices)() if random.random() < 0.25 else {}

    def node(self, scope: _Scope, depth: int) -> Tag:
        """A node with its children."""
        random = self.random
        attributes: dict[str, Any] = {"pkg": "pk", "exec": "e"}
        if random.random() < 0.85:
            attributes["name"] = self.named()
        attributes |= {**self.namespace(), **self.process(scope), **self.condition(scope, 0.2)}
        if random.random() < 0.15:
            attributes["args"] = random.choice(
                ("--a b", "'a b' c", "$(command 'echo x') y", f"--x {self.value(scope)}", "\"q\" $(var a0 'd e')f")
            )
        if random.random() < 0.07:
            attributes["ros_args"] = random.choice(("--log-level debug", "-r x:=y", "--log-level $(var a0 info)"))
        if random.random() < 0.05:
            attributes["exec_name"] = "label"
        return Tag("node", attributes, self.inside(scope))

    def inside(self, scope: _Scope, *, component: bool = False) -> tuple[Tag, ...]:
        """Children of a node or a component."""
        random = self.random
        makers = (self.param, self.param, self.remap, self.extra if component else self.env)
        drawn = [random.choice(makers)(scope) for _ in range(random.choice((0, 0, 1, 2, 3)))]
        return tuple(sorted(drawn, key=lambda child: ("param", "remap", "env", "extra_arg").index(child.name)))

    def param(self, scope: _Scope, depth: int = 0) -> Tag:
        """A param of any form."""
        random = self.random
        roll = random.random()
        if roll < 0.15:
            file = random.choice(
                ("$(dirname)/../config/0.yaml", "$(find-pkg-share pk)/config/1.yaml", "$(find-pkg-share pk)/config/0.yaml")
            )
            if self.wrong and random.random() < 0.2:
                file = "$(dirname)/nowhere.yaml"
            if "dirname" in file or random.random() < 0.6:
                return Tag("param", {"from": file})
            return Tag(
                "param", {"from": file, "allow_substs": "$(not false)" if self.wrong and random.random() < 0.2 else random.random() < 0.7}
            )
        name = random.choice(PARAMETERS)
        if roll < 0.25 and depth < 2:
            return Tag("param", {"name": name}, tuple(self.param(scope, 2) for _ in range(random.randint(1, 2))))
        if roll < 0.35 and scope.names:
            return Tag("param", {"name": name, "value": f"$(var {random.choice(scope.names)})", **self.type(0.4)})
        if roll < 0.5:
            return Tag("param", {"name": name, "value": self.value(scope), **self.type(0.3)})
        if roll < 0.65:
            return Tag("param", {"name": name, "value": random.choice(RAW)})
        values = VALUES if self.wrong else VALUES[:23]
        return Tag("param", {"name": name, "value": random.choice(values), **(self.type(0.3) if self.wrong else {})})

    def type(self, share: float) -> dict[str, Any]:
        """A type of a param; where nothing is to be wrong, one that takes everything."""
        if self.random.random() >= share:
            return {}
        return {"type": self.random.choice(TYPES if self.wrong else ("str",))}

    def remap(self, scope: _Scope) -> Tag:
        """A remap."""
        target = self.random.choice(TOPICS) if self.random.random() < 0.8 else self.value(scope)
        return Tag("remap", {"from": self.random.choice(TOPICS), "to": target})

    def env(self, scope: _Scope) -> Tag:
        """A variable of one node."""
        return Tag("env", {"name": self.random.choice(VARIABLES), "value": self.value(scope)})

    def extra(self, scope: _Scope) -> Tag:
        """An extra argument of a component."""
        return Tag("extra_arg", {"name": "use_intra_process_comms", "value": self.random.choice(("true", "1", "text", True))})

    def executable(self, scope: _Scope, depth: int) -> Tag:
        """A program that is no node."""
        command = self.random.choice(
            ("echo hi", "echo 'a b'", f"echo {self.value(scope)}", "$(find-exec ls) -l", 'bash -c "echo $(var a0 x) y"')
        )
        named = {"name": "label"} if self.random.random() < 0.3 else {}
        children = tuple(self.env(scope) for _ in range(self.random.choice((0, 0, 1))))
        return Tag("executable", {"cmd": command, **named, **self.process(scope), **self.condition(scope, 0.15)}, children)

    def component(self, scope: _Scope) -> Tag:
        """A node of a container."""
        attributes = {"pkg": "pk", "plugin": "pk::C", "name": self.named(), **self.namespace(), **self.condition(scope, 0.2)}
        return Tag("composable_node", attributes, self.inside(scope, component=True))

    def container(self, scope: _Scope, depth: int) -> Tag:
        """A container with its components."""
        self.counter += 1
        name = f"c{self.counter}"
        self.containers.append(name)
        attributes = {"pkg": "pk", "exec": "e", "name": name, "namespace": self.random.choice(NAMESPACES[:7]), **self.process(scope)}
        children = tuple(self.component(scope) for _ in range(self.random.randint(0, 2)))
        return Tag("node_container", {**attributes, **self.condition(scope, 0.1)}, (*self.inside(scope), *children))

    def load(self, scope: _Scope, depth: int) -> Tag:
        """Components for a container that is started elsewhere."""
        target = self.random.choice((*self.containers, "other", "/abs/c", self.value(scope)))
        children = tuple(self.component(scope) for _ in range(self.random.randint(1, 2)))
        return Tag("load_composable_node", {"target": target, **self.condition(scope, 0.15)}, children)

    def let(self, scope: _Scope, depth: int) -> Tag:
        """A let, mostly of a new name."""
        self.counter += 1
        truth = self.random.random() < 0.4
        name = self.random.choice((f"{'t' if truth else 'a'}{self.counter + 10}", "t1" if truth else "a0"))
        condition = self.condition(scope, 0.1)
        value = self.truth(scope) if truth else self.value(scope)
        if not condition:
            (scope.truths if truth else scope.names).append(name)
            (self.anywhere.truths if truth else self.anywhere.names).append(name)
        return Tag("let", {"name": name, "value": value, **condition})

    def arg(self, scope: _Scope, depth: int) -> Tag:
        """An arg that is declared between other things."""
        self.counter += 1
        name = self.random.choice((f"a{self.counter + 10}", "a0", "a1"))
        value, condition = self.value(scope), self.condition(scope, 0.1)
        if not condition:
            scope.names.append(name)
        return Tag("arg", {"name": name, "default": value, **condition})

    def include(self, scope: _Scope, depth: int) -> Tag:
        """An include of a file that is drawn already, with what it needs; some node where there is none."""
        if not self.wanted:
            return self.node(scope, depth)
        random = self.random
        name = random.choice(list(self.wanted))
        needed, optional = self.wanted[name]
        passed = [each for each in needed if not self.wrong or random.random() < 0.9] + [each for each in optional if random.random() < 0.5]
        if random.random() < 0.15:
            passed.append("a0")
        children = tuple(
            Tag("arg", {"name": each, "value": random.choice(TRUTHS) if each.startswith("t") else self.value(scope)}) for each in passed
        )
        place = name.removeprefix("launch/")
        file = random.choice(
            (f"$(dirname)/{place}", f"$(find-pkg-share pk)/launch/{place}", f"$(find-pkg-share $(var undefined pk))/launch/{place}")
        )
        condition = self.condition(scope, 0.2)
        if not condition:
            scope.names += [each for each in (*needed, *optional) if each.startswith("a")]
            scope.truths += [each for each in (*needed, *optional) if each.startswith("t")]
        return Tag("include", {"file": file, **condition}, children)

    def group(self, scope: _Scope, depth: int) -> Tag:
        """A group of any kind."""
        random = self.random
        attributes: dict[str, Any] = {}
        inner = _Scope(scope)
        children: list[Tag] = []
        if random.random() < 0.25:
            attributes["scoped"] = random.choice(("true", "false", "1", "0"))
        if random.random() < 0.15:
            attributes["forwarding"] = random.choice(("true", "false"))
            if attributes["forwarding"] == "false" and attributes.get("scoped") not in ("false", "0"):
                inner = _Scope()
                for name in (scope.names + scope.truths)[:2]:
                    children.append(Tag("keep", {"name": name, "value": random.choice(TRUTHS[:4])}))
                    (inner.truths if name.startswith("t") else inner.names).append(name)
        children += self.actions(inner, random.randint(1, 4), depth + 1)
        if attributes.get("scoped") in ("false", "0"):
            scope.names, scope.truths = inner.names, inner.truths
        return Tag("group", {**attributes, **self.condition(scope, 0.2)}, tuple(children))

    def timer(self, scope: _Scope, depth: int) -> Tag:
        """A timer; what it does may fail, which launch finds out only then."""
        period = self.random.choice(("1.0", "2", "$(eval '1 + 1')", "0"))
        children = tuple(self.actions(_Scope(scope), self.random.randint(1, 3), depth + 1))
        return Tag(self.random.choice(("timer", "timer", "ros_timer")), {"period": period, **self.condition(scope, 0.1)}, children)

    def push(self, scope: _Scope, depth: int) -> Tag:
        """A namespace for what follows."""
        name = self.random.choice(("push_ros_namespace", "push-ros-namespace"))
        return Tag(name, {"namespace": self.random.choice(NAMESPACES), **self.condition(scope, 0.1)})

    def setting(self, scope: _Scope, depth: int) -> Tag:
        """Remaps and params for what follows."""
        random = self.random
        choices: tuple[Callable[[], Tag], ...] = (
            lambda: Tag("set_remap", dict(self.remap(scope).attributes)),
            lambda: Tag("set_parameter", {"name": random.choice(PARAMETERS), "value": random.choice((*VALUES[:20], self.value(scope)))}),
            lambda: Tag("set_parameters_from_file", {"filename": f"$(find-pkg-share pk)/config/{random.randint(0, 1)}.yaml"}),
            lambda: Tag("log", {"message": self.value(scope)}),
            lambda: Tag("set_ros_log_dir", {"new_log_dir": self.value(scope)}),
            lambda: Tag("shutdown", {"reason": self.value(scope)}),
        )
        made = random.choice(choices[:3] * 4 + choices)()
        return Tag(made.name, {**made.attributes, **self.condition(scope, 0.1)})

    def environment(self, scope: _Scope, depth: int) -> Tag:
        """Variables for what follows."""
        random = self.random
        name = {"name": random.choice(VARIABLES)}
        extra = {"prepend": random.choice(("true", "false", "$(not true)")), "separator": random.choice((":", ";", ", "))}
        made = random.choice(
            (
                Tag("set_env", {**name, "value": self.value(scope)}),
                Tag("set_env", {**name, "value": self.value(scope)}),
                Tag("append_env", {**name, "value": self.value(scope), **(extra if random.random() < 0.5 else {})}),
                Tag("unset_env", {"name": random.choice((*VARIABLES, "HOME"))} if self.wrong else {"name": "HOME"}),
                Tag("reset_env", {}),
            )
        )
        return Tag(made.name, {**made.attributes, **self.condition(scope, 0.1)})

    def reset(self, scope: _Scope, depth: int) -> Tag:
        """Everything that was set is gone, but for what is kept; rarely."""
        if self.random.random() < 0.8:
            return self.let(scope, depth)
        kept = [name for name in dict.fromkeys(scope.names + scope.truths) if self.random.random() < 0.5]
        scope.names = [name for name in kept if name.startswith("a")]
        scope.truths = [name for name in kept if name.startswith("t")]
        return Tag("reset", {}, tuple(Tag("keep", {"name": name, "value": f"$(var {name})"}) for name in kept))


def random_workspace(seed: int, mistakes: float = 0.35) -> Workspace:
    """The workspace of a number."""
    return Generator(Random(seed), mistakes).workspace()
