"""Random launch trees: several files that include each other, with everything roslaunch knows, mostly right and sometimes wrong."""

from __future__ import annotations

from random import Random
from typing import NamedTuple

from tests.evaluate.comparison import MAIN, Case

WORDS = ("1", "0", "true", "false", "x", "2.5", "robot 1", "", "a/b", "007", "-3", "TRUE", "yes", "1e3")
TRUTHS = ("true", "false", "1", "0", "True", " false ")
NAMESPACES = ("a", "b/c", "/", "/abs", "a//b", "a/", "/abs/b//", "my-robot")
TOPICS = ("x", "/x", "x/", "//x", "y", "a/y", "~z", "/abs/x", "out")
PARAMETERS = ("p", "q", "/p", "a/p", "~p", "~q", "a", "p/q", "/abs/q", " q ", "~p/r", "n1/p", "/n2/q")
TYPED = (
    ("int", ("1", "-2", " 3 ")),
    ("double", ("1", "2.5", "1e3", "nan")),
    ("str", WORDS),
    ("bool", TRUTHS),
    ("yaml", ("{a: 1}", "[1, x]", "null", "on", "deg(90)", "1:30")),
    ("auto", WORDS),
)
YAMLS = (
    "{p: 1, q: two}",
    "a: {p: [1, 2.5, yes], q: ~}\n",
    "{p: {q: {r: 1}}, /abs/q: 2}",
    "",
    "{~p: 1, q/: 2}",
    "p: deg(45)\nq: rad(pi)\n",
    "{a: {}, b: 1}",
    "\n  p: on\n  q: 012\n",
)
EVALUATIONS = (
    "1 + 1",
    "'x' + 'y'",
    "2 &gt; 1",
    "str(3)",
    "not True",
    "dirname()[0]",
    "optenv('NO', 'd')",
    "find('pkg')[-3:]",
    "env('SET')",
)
MISTAKES = (
    '<node pkg="p" name="m"/>',
    '<node pkg="p" type="t" name="a/b"/>',
    '<node pkg="p" type="t" name="m" required="1"/>',
    '<node pkg="p" type="t" name="m" respawn="true" required="true"/>',
    '<node pkg="p" type="t" name="m" output="both"/>',
    '<node pkg="p" type="t" name="m"><remap from="" to="x"/></node>',
    '<node pkg="p" type="t" name="m" args="\'"/>',
    '<node pkg="p" type="t" name="m" machine="nowhere"/>',
    '<test pkg="p" type="t" test-name="m" time-limit="0"/>',
    '<test pkg="p" type="t" name="m"/>',
    '<test pkg="p" type="t" test-name="m" output="log"/>',
    '<param name="p"/>',
    '<param name="p" value="1" textfile="x"/>',
    '<param name="p" type="int" value="1.5"/>',
    '<param name="p" type="number" value="1"/>',
    '<param name="p" value="$(arg nothing)"/>',
    '<param name="p" value="$(eval nothing)"/>',
    '<param name="p" value="$(env NOT_SET)"/>',
    '<param name="p" value="$(find nothing)"/>',
    '<param name="p" value="$(args a)"/>',
    '<param name="p" value="$(arg $(arg a))"/>',
    '<rosparam file="nowhere.yaml"/>',
    "<rosparam>[1]</rosparam>",
    "<rosparam>{1: 2}</rosparam>",
    "<rosparam>a: [</rosparam>",
    '<rosparam command="delete" file="x"/>',
    '<remap from="x"/>',
    '<remap from="x y" to="z"/>',
    '<env name="" value="1"/>',
    '<machine name="m0" address="other" user="u"/>',
    '<machine name="m0"/>',
    '<group ns=""/>',
    '<group ns="~a"/>',
    '<group clear_params="true"/>',
    '<group if="maybe"/>',
    '<group if="1" unless="0"/>',
    '<arg name="a" value="1" default="1"/>',
    '<arg name="a0" default="again"/>',
    '<arg name="late_$(arg late)" default="1"/><arg name="late" default="1"/>',
    '<include file="nowhere.launch"/>',
    "<include/>",
    '<group><arg name="inner" default="1"/></group><param name="p" value="$(arg inner)"/>',
    '<node pkg="p" type="t" name="same"/><node pkg="p" type="t" name="same"/>',
    '<node pkg="p" type="t" name="rosout"/>',
    "<unknown/>",
    "text",
    '<param name="p" value="1" if="0" unless="0"/>',
)


class Interface(NamedTuple):
    """The args a file takes: those it needs, those with a default, those it fixes."""

    required: tuple[str, ...]
    optional: tuple[str, ...]
    fixed: tuple[str, ...]


class _Scope:
    """What can be read at one point of a file: args of any kind, args that are boolean, machines."""

    def __init__(self, parent: _Scope | None = None) -> None:
        self.names: list[str] = [] if parent is None else list(parent.names)
        self.truths: list[str] = [] if parent is None else list(parent.truths)


class Generator:
    """Draws one case. ``mistakes`` is the share of cases that may hold mistakes, ``files`` and ``elements`` the most there may be of
    them.
    """

    def __init__(self, random: Random, mistakes: float, files: int, elements: int) -> None:
        self.random = random
        self.most_files = files
        self.most_elements = elements
        self.wrong = random.random() < mistakes
        self.counter = 0
        self.machines: list[str] = []
        self.interfaces: dict[str, Interface] = {}
        self.current = ""

    def case(self) -> Case:
        """A whole tree; the entry file comes last, since it has to know what the others take."""
        random = self.random
        count = random.randint(1, self.most_files)
        files: dict[str, str] = {}
        for number in range(count - 1, 0, -1):
            name = f"f{number}.launch" if number % 2 else f"sub/f{number}.launch"
            files[name] = self.file(name)
        files[MAIN] = self.file(MAIN)
        files = {MAIN: files.pop(MAIN), **files}
        files["pkg/package.xml"] = "<package><name>pkg</name></package>"
        files["values.yaml"] = random.choice(YAMLS)
        files["text.txt"] = random.choice(("12\n", "text", ""))
        interface = self.interfaces[MAIN]
        given = {name: random.choice(WORDS[:6]) for name in interface.required}
        for name in interface.optional:
            if random.random() < 0.3:
                given[name] = random.choice(TRUTHS[:4]) if name.startswith("t") else random.choice(WORDS)
        for name in interface.required:
            if name.startswith("t"):
                given[name] = random.choice(TRUTHS[:4])
        if self.wrong and interface.fixed and random.random() < 0.2:
            given[interface.fixed[0]] = "1"
        if random.random() < 0.1:
            given["__ns"] = random.choice(("robot", "/robot/"))
        if self.wrong and random.random() < 0.03:
            name = random.choice([each for each in files if each.endswith(".launch")])
            files[name] = files[name].replace("</launch>", '<include file="main.launch"/></launch>')
        environment = {"SET": random.choice(("1", "value", "$(find pkg)/x")), "HERE": "$(find pkg)/../"}
        if random.random() < 0.1:
            environment["ROS_NAMESPACE"] = random.choice(("fleet", "/fleet/one"))
        return Case(files, (), given, environment)

    def file(self, name: str) -> str:
        """The text of one file."""
        scope = _Scope()
        required, optional, fixed = [], [], []
        lines: list[str] = []
        for number in range(self.random.randint(0, 4)):
            kind = self.random.choice(("required", "optional", "optional", "fixed"))
            truth = self.random.random() < 0.4
            arg = f"{'t' if truth else 'a'}{number}"
            text = self.random.choice(TRUTHS) if truth else self.value(scope)
            condition = self.condition(scope, 0.1) if kind == "fixed" and not truth else ""
            if kind == "required":
                required.append(arg)
                lines.append(f'<arg name="{arg}"/>')
            elif kind == "optional":
                optional.append(arg)
                lines.append(f'<arg name="{arg}" default="{text}"/>')
            else:
                fixed.append(arg)
                lines.append(f'<arg name="{arg}" value="{text}"{condition}/>')
            if not condition:
                (scope.truths if truth else scope.names).append(arg)
        self.current = name
        self.interfaces[name] = Interface(tuple(required), tuple(optional), tuple(fixed))
        lines += self.elements(scope, self.random.randint(1, self.most_elements), 0)
        return "<launch>\n" + "\n".join(lines) + "\n</launch>\n"

    def elements(self, scope: _Scope, count: int, depth: int) -> list[str]:
        """Some elements in one scope."""
        makers = [self.node] * 4 + [self.param] * 3 + [self.rosparam] * 2 + [self.remap] * 2
        makers += [self.env, self.machine, self.arg, self.include, self.include, self.test]
        if depth < 3:
            makers += [self.group] * 3
        lines = []
        for _ in range(count):
            if self.wrong and self.random.random() < 0.06:
                lines.append(self.random.choice(MISTAKES))
            else:
                lines.append(self.random.choice(makers)(scope, depth))
        return lines

    # -- values

    def value(self, scope: _Scope) -> str:
        """An attribute value, with substitutions now and then."""
        random = self.random
        roll = random.random()
        if roll < 0.4:
            return random.choice(WORDS)
        if roll < 0.65 and scope.names:
            return random.choice(("{0}", "x{0}", "{0}/{0}", "{0} y")).format(f"$(arg {random.choice(scope.names)})")
        if roll < 0.72 and scope.truths:
            return f"$(arg {random.choice(scope.truths)})"
        if roll < 0.8:
            return f"$(anon {random.choice('ab')})"
        if roll < 0.9:
            return random.choice(
                ("$(dirname)", "$(optenv NO x y)", "$(env SET)", "$(find pkg)/x y", "$(find pkg)x", "$(optenv SET)", "${arg a}")
            )
        return self.evaluation(scope)

    def evaluation(self, scope: _Scope) -> str:
        """An ``$(eval …)`` that any arg can go through."""
        names = scope.names + scope.truths
        if names and self.random.random() < 0.6:
            name = self.random.choice(names)
            form = self.random.choice(("{0}", "str({0}) + 'z'", "arg('{0}')", "{0} == 'x'", "[{0}, 1][0]", "'q' if {0} == 1 else 'r'"))
            return f"$(eval {form.format(name)})"
        return f"$(eval {self.random.choice(EVALUATIONS)})"

    def condition(self, scope: _Scope, share: float = 0.25) -> str:
        """An ``if`` or ``unless``, or nothing."""
        random = self.random
        if random.random() >= share:
            return ""
        name = random.choice(("if", "unless"))
        if scope.truths and random.random() < 0.7:
            arg = random.choice(scope.truths)
            return random.choice((f' {name}="$(arg {arg})"', f' {name}="$(eval bool({arg}))"', f' {name}="$(eval not {arg})"'))
        if scope.names and random.random() < 0.5:
            return f" {name}=\"$(eval {random.choice(scope.names)} == 'x')\""
        return f' {name}="{random.choice(TRUTHS)}"'

    def namespace(self, share: float = 0.3) -> str:
        """An ``ns`` with ``clear_params`` now and then, or nothing."""
        if self.random.random() >= share:
            return ""
        clear = ' clear_params="true"' if self.random.random() < 0.1 else ""
        return f' ns="{self.random.choice(NAMESPACES)}"{clear}'

    # -- elements

    def _fresh(self) -> str:
        self.counter += 1
        return f"n{self.counter}" if self.random.random() < 0.9 else f"$(anon n{self.random.randint(1, 2)})"

    def node(self, scope: _Scope, depth: int) -> str:
        """A node with its children."""
        random = self.random
        extra = ""
        if random.random() < 0.2:
            extra += f' args="{self.value(scope)}"'
        if random.random() < 0.1:
            extra += random.choice(
                (' output="screen"', ' respawn="true" respawn_delay="2"', ' required="True"', ' cwd="node"', ' launch-prefix="nice"')
            )
        if self.machines and random.random() < 0.1:
            extra += f' machine="{random.choice(self.machines)}"'
        start = f'<node pkg="p" type="t" name="{self._fresh()}"{self.namespace(0.15)}{extra}{self.condition(scope, 0.15)}'
        return start + self._children(scope, depth) + "</node>"

    def test(self, scope: _Scope, depth: int) -> str:
        """A test with its children."""
        extra = self.random.choice(("", ' name="named"', ' time-limit="5.5"', ' retry="2"', ' required="false"'))
        start = f'<test pkg="p" type="t" test-name="{self._fresh()}"{self.namespace(0.1)}{extra}{self.condition(scope, 0.1)}'
        return start + self._children(scope, depth) + "</test>"

    def _children(self, scope: _Scope, depth: int) -> str:
        makers = (self.param, self.param, self.rosparam, self.remap, self.env)
        return ">" + "".join(self.random.choice(makers)(scope, depth) for _ in range(self.random.choice((0, 0, 0, 1, 2, 3))))

    def param(self, scope: _Scope, depth: int) -> str:
        """A param of any type and source."""
        random = self.random
        start = f'<param name="{random.choice(PARAMETERS)}"'
        roll = random.random()
        if roll < 0.4:
            type_, values = random.choice(TYPED)
            source = f'type="{type_}" value="{random.choice(values)}"'
        elif roll < 0.9:
            source = f'value="{self.value(scope)}"'
        else:
            source = random.choice(('textfile="text.txt"', 'binfile="text.txt"', 'command="cat $(anon c)"'))
        return f"{start} {source}{self.condition(scope, 0.1)}/>"

    def rosparam(self, scope: _Scope, depth: int) -> str:
        """A rosparam of any command."""
        random = self.random
        roll = random.random()
        condition = self.condition(scope, 0.1)
        place = random.choice(("", ' ns="a"', ' param="a"', ' ns="/abs" param="b"', ' ns="~"', ' param="~c"'))
        if roll < 0.1:
            return f'<rosparam command="{random.choice(("delete", "dump"))}"{place}{condition}/>'.replace('"dump"', '"dump" file="d.yaml"')
        if roll < 0.25:
            return f'<rosparam file="values.yaml"{place}{condition}/>'
        if roll < 0.4:
            text = "{p: '" + self.value(scope).replace("'", "") + "', q: 1}"
            text = text if "$(eval" not in text else "{p: $(anon a)}"
            return f'<rosparam subst_value="{random.choice(("true", "True"))}"{place}{condition}>{text}</rosparam>'
        return f"<rosparam{place}{condition}>{random.choice(YAMLS)}</rosparam>"

    def remap(self, scope: _Scope, depth: int) -> str:
        """A remap."""
        target = self.random.choice(TOPICS) if self.random.random() < 0.9 else "$(anon topic)"
        return f'<remap from="{self.random.choice(TOPICS)}" to="{target}"{self.condition(scope, 0.1)}/>'

    def env(self, scope: _Scope, depth: int) -> str:
        """An env."""
        return f'<env name="{self.random.choice(("A", "B"))}" value="{self.value(scope)}"{self.condition(scope, 0.1)}/>'

    def machine(self, scope: _Scope, depth: int) -> str:
        """A machine, mostly of a new name."""
        name = f"m{len(self.machines)}"
        condition = self.condition(scope, 0.1)
        if not condition:
            self.machines.append(name)
        extra = self.random.choice(("", ' default="true"', ' default="never"', ' user="u"', ' ssh-port="23" timeout="2"', ' password=""'))
        return f'<machine name="{name}" address="host"{extra}{condition}/>'

    def arg(self, scope: _Scope, depth: int) -> str:
        """An arg that is declared between other things."""
        self.counter += 1
        truth = self.random.random() < 0.3
        name = f"{'t' if truth else 'a'}{self.counter + 10}"
        if depth and self.random.random() < 0.5:
            # A name that other groups and files have too: siblings may share it, and pass_all_args hands it on.
            name = self.random.choice(("t8", "t9") if truth else ("a8", "a9"))
        text = self.random.choice(TRUTHS) if truth else self.value(scope)
        line = f'<arg name="{name}" {self.random.choice(("default", "value"))}="{text}"/>'
        (scope.truths if truth else scope.names).append(name)
        return line

    def group(self, scope: _Scope, depth: int) -> str:
        """A group with a scope of its own."""
        inner = _Scope(scope)
        start = f"<group{self.namespace(0.5)}{self.condition(scope)}>"
        lines = self.elements(inner, self.random.randint(0, self.most_elements // 2 + 1), depth + 1)
        return "\n".join((start, *lines, "</group>"))

    def include(self, scope: _Scope, depth: int) -> str:
        """An include of a file that is there already, with the args it takes."""
        random = self.random
        if not self.interfaces:
            return self.node(scope, depth)
        known = [name for name in self.interfaces if name != self.current or random.random() < 0.01]
        if not known:
            return self.node(scope, depth)
        name = random.choice(known)
        interface = self.interfaces[name]
        every = random.random() < 0.3
        passed = list(interface.required)
        passed += [each for each in interface.optional if random.random() < 0.5]
        if self.wrong and random.random() < 0.2:
            passed.append(random.choice(("undeclared", *interface.fixed)))
            passed = passed[random.randint(0, 1) :]
        if every and random.random() < 0.5:
            passed = passed[: len(passed) // 2]
        children = ""
        for each in passed:
            text = random.choice(TRUTHS) if each.startswith("t") else self.value(scope)
            children += f'<arg name="{each}" {random.choice(("value", "value", "default"))}="{text}"/>'
        if random.random() < 0.2:
            children += self.env(scope, depth)
        attributes = self.namespace(0.4) + (' pass_all_args="true"' if every else "") + self.condition(scope, 0.2)
        # Where every file is included at most in one namespace, its nodes would be there twice: give most of them one of their own.
        if "ns=" not in attributes and random.random() < 0.7:
            self.counter += 1
            attributes += f' ns="i{self.counter}"'
        prefix = random.choice(("", "", "$(find pkg)/../", "$(env HERE)", "./"))
        return f'<include file="{prefix}{name}"{attributes}>{children}</include>'


def random_case(random: Random, mistakes: float = 0.35, files: int = 4, elements: int = 7) -> Case:
    """One random tree."""
    return Generator(random, mistakes, files, elements).case()
