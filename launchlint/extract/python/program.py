"""One Python program, from its first statement to the callbacks that are called when it has come to its end."""

from __future__ import annotations

import ast
import gc
import os
import re
from contextlib import suppress
from typing import Any

from launchlint.extract.fact import Doubt, Fact, Made
from launchlint.extract.python.arguments import Call, plain
from launchlint.extract.python.following import Following
from launchlint.extract.python.modules import PackageModules
from launchlint.extract.python.names import ros_name
from launchlint.extract.python.recognised import ROSPY
from launchlint.extract.python.recogniser import TYPES, RosRecogniser
from launchlint.extract.python.silence import says_nothing
from launchlint.named_tuple import NamedTuple
from launchlint.python.calls import Callback
from launchlint.python.memory import Ended, Exhausted
from launchlint.python.source import Routine, Source, SourceError, parse
from launchlint.python.text import joined
from launchlint.python.values import MISSING, UNKNOWN, Bound, Class, External, Function, Instance, Module, Scope, Unknown, Value
from launchlint.workspace.looking import read_bytes

_PLUGIN = re.compile(r"<class\s[^<>]*?\btype\s*=\s*[\"']([\w.]+)[\"'][^<>]*?rqt_gui_py")


class Extracted(NamedTuple):
    """What a program does.

    ``options`` is how its command line is read (see the library format), ``uses_rospy`` whether it imports rospy at all; ``nodes`` are
    those of ROS 2 that it makes, the first one first.
    """

    facts: tuple[Fact, ...]
    doubts: tuple[Doubt, ...]
    options: dict[str, int]
    uses_rospy: bool
    nodes: tuple[Made, ...] = ()


def python_program(path: str, root: str, package: str, finder: PackageModules) -> Extracted:
    """Follow the program at ``path``. Nothing is run or imported.

    Args:
        path: the file.
        root: the directory that paths of facts are relative to.
        package: directory of the package it is of; empty where it is of none.
        finder: where its modules are looked for.

    Raises:
        SourceError: the file itself is not Python, or cannot be read.
    """
    return followed(Run(root, package, finder, os.path.dirname(path)), path)


def followed(run: Run, path: str, entry: str = "") -> Extracted:
    """What a program does.

    Args:
        run: follows it.
        path: the file.
        entry: ``module:function`` where that is what is called of it.

    Raises:
        SourceError: the file is not Python, or cannot be read.
    """
    collecting = gc.isenabled()
    gc.disable()  # a tree is many objects, of which none is garbage: looking for it takes a third of the time
    try:
        run.follow(path, entry)
    finally:
        run.leave()
        if collecting:
            gc.enable()
    facts = tuple(dict.fromkeys(_hashable(_as_node(fact, run.starts)) for fact in run.settled()))
    return Extracted(tuple(each.fact for each in facts), tuple(run.doubts), run.options, run.uses_ros, run.made)


def _as_node(fact: Fact, starts: list[str]) -> Fact:
    """A fact without the conditions under which the program is a node at all: who gave the wrong args has started none."""
    first = starts[0] if starts else ""
    if not first or any(each != first for each in starts) or not f"{fact.condition} and ".startswith(f"{first} and "):
        return fact
    return fact._replace(condition=fact.condition[len(first) :].removeprefix(" and "))


def configuration_params(path: str, root: str) -> tuple[list[Fact], bool]:
    """The params that a dynamic_reconfigure ``.cfg`` file describes, as private ones, and whether that is all of them."""
    run = Run(root, "", PackageModules({}), os.path.dirname(path))
    try:
        run.follow(path)
    except SourceError:
        return [], False
    finally:
        run.leave()
    return [fact for fact in run.facts if fact.category == "params"], not any(doubt.category == "params" for doubt in run.doubts)


class _Hashed:
    """A fact that can be a key although its default may be a list."""

    __slots__ = ("fact", "key")

    def __init__(self, fact: Fact) -> None:
        self.fact = fact
        self.key = repr(fact)

    def __hash__(self) -> int:
        return hash(self.key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Hashed) and self.key == other.key


def _hashable(fact: Fact) -> _Hashed:
    return _Hashed(fact)


class Run(Following):
    """One program of ROS as it is followed, by default one of ROS 1."""

    dialect = ROSPY
    recognise: type[RosRecogniser] = RosRecogniser

    def __init__(self, root: str, package: str, finder: PackageModules, beside: str) -> None:
        super().__init__(self.recognise(self), root, package, finder, beside)
        self._modules_of_packages = finder
        self.facts = []
        self.doubts = {}
        self.starts = []
        self.when = "start"
        self.options = {}
        self.uses_ros = False

    # -- the run ------------------------------------------------------------------------------------------------------

    @property
    def made(self) -> tuple[Made, ...]:
        """The nodes that it makes, where that is told."""
        return ()

    def settled(self) -> list[Fact]:
        """The facts, once all is followed."""
        return self.facts

    def follow(self, path: str, entry: str = "") -> None:
        """Follow the file at ``path`` from beginning to end, or the function that the entry point ``module:function`` names."""
        source = parse(path)
        if says_nothing(source, self.beside, self.package, self.finder):
            return
        name, _, function = entry.partition(":")
        main = self.main(path, source, name or "__main__")
        try:
            self._begin(source, main, function)
            self._call_back()
            self._doubt_unseen()
        except Ended:
            pass
        except (Exhausted, RecursionError):
            self.conditions.clear()
            self.doubt("it is too much to be followed to its end", main.path, 1)
        self.doubt_nothing(main.path)

    def _begin(self, source: Source, main: Module, function: str) -> None:
        """Go through the file, and call the function of it that is asked for."""
        mark = self.opened
        flow = self.execute(source.tree.body, main.scope)
        if not function:
            return
        if self.opened > mark:
            self._leave(mark, flow, main.scope)
        node = ast.Pass(lineno=1, col_offset=0)
        value: Value = main
        for name in function.split("."):
            value = self.attribute(value, name, node, main.scope)
        if isinstance(value, Unknown) or value is MISSING:
            self.doubt(f"its entry point {function} was not found", main.path, 1)
        else:
            with suppress(Ended):  # what was arranged before it ended is called all the same
                self.call(value, [], {}, node, main.scope)

    def doubt_nothing(self, path: str) -> None:
        """Note it where nothing at all was understood of the program at ``path``."""

    def _call_back(self) -> None:
        """What others call, after the program has come to its end."""
        done = 0
        for _ in range(20):
            while done < len(self.callbacks):
                self._call_one(self.callbacks[done])
                done += 1
            self._framework_methods()
            if done == len(self.callbacks):
                return

    def _call_one(self, callback: Callback) -> None:
        self.conditions = [callback.condition] if callback.condition else []
        self._enter(callback.when)
        positional = callback.positional if callback.known else self._unknown_arguments(callback.function)
        try:
            self.call(callback.function, positional, callback.keywords, ast.Pass(lineno=1, col_offset=0), Scope(Module("", "", None), None))
        except Ended:
            pass
        finally:
            self.conditions = []
            self._enter("start")

    def _enter(self, when: str) -> None:
        """From here on it is ``when``."""
        self.when = when

    @staticmethod
    def _unknown_arguments(function: Value) -> list[Value]:
        return [UNKNOWN] * 3 if isinstance(function, (Function, Bound, Class)) else []

    def _framework_methods(self) -> None:
        """Objects whose class has a base that is not followed, or that were given away: whoever knows them may call their methods."""
        escaped = {id(each) for each in self.escaped}
        for instance in list(self.instances):
            foreign = [each for each in instance.type.order if not isinstance(each, Class) and each != External("builtins.object")]
            given = bool(foreign) or id(instance) in escaped
            for name, when in self._callable(instance, foreign) if given else self._implied(instance):
                method = self._of_instance(instance, name)
                if isinstance(method, Bound) and isinstance(method.function, Function) and id(method.function.node) not in self.executed:
                    self.arrange(method, when)

    def _implied(self, instance: Instance) -> list[tuple[str, str]]:
        """Methods that are called without being named, by operators and the like."""
        names = {name for each in instance.type.order if isinstance(each, Class) for name in each.attributes if name.startswith("__")}
        return [(name, "message") for name in sorted(names - {"__init__", "__new__", "__owner__", "__qualname__", "__class__"})]

    def _callable(self, instance: Instance, foreign: list[Value]) -> list[tuple[str, str]]:
        names = dict.fromkeys(name for each in instance.type.order if isinstance(each, Class) for name in each.attributes)
        bases = {each.name if isinstance(each, External) else "" for each in foreign}
        if bases and bases <= {"threading.Thread", "multiprocessing.Process"}:
            return [("run", "start")] if "run" in names else []
        callable_ = [name for name in names if not name.startswith("__") or name == "__call__"]
        return [(name, "start" if name in ("run", "setUp") else "message") for name in callable_]

    def _doubt_unseen(self) -> None:
        """Functions that make names and are called, if at all, only through values that are not known."""
        made = {id(each) for instance in self.instances for each in instance.type.order if isinstance(each, Class)}
        given = {id(each): each for each in self.given_classes if id(each) not in made}
        methods = {id(each.node) for class_ in given.values() for each in class_.attributes.values() if isinstance(each, Function)}
        if not (self.unknown_methods or methods):
            return
        unseen = [(module, each) for module in self.modules.values() for each in module.routines if id(each.node) not in self.executed]
        talking = [each for each in unseen if self._talks(*each)]
        words = {each.name for _, each in talking}
        while True:
            more = [each for each in unseen if each not in talking and not words.isdisjoint(each[1].calls)]
            if not more:
                break
            talking += more
            words.update(each.name for _, each in more)
        for module, each in talking:
            if each.name in self.unknown_methods or id(each.node) in methods:
                self.doubt(f"{each.name}() is called through a value that is not known", module.path, each.node.lineno)

    def _talks(self, module: Module, routine: Routine) -> bool:
        """Whether a function makes names by itself, or calls what may."""
        if not self.dialect.making.isdisjoint(routine.calls):
            return True
        outside = [module.scope.variables.get(each) for each in routine.roots]
        return any(isinstance(each, External) and not self.recogniser.is_silent(each.name) for each in outside)

    # -- what recognised calls ask for -----------------------------------------------------------------------------------

    def libraries(self) -> frozenset[str]:
        """The libraries of Python that its package says it needs."""
        return self._modules_of_packages.libraries(self.package, self.root)

    def plugin(self, name: Value, made: Call) -> None:
        """Make the rqt plugin that a program is the window of: by its class, or by the name of its package."""
        if isinstance(name, str) and "." not in name:
            name = self._plugin_class(name)
        if not isinstance(name, str) or "." not in name or len(name) > 200:
            made.doubt("it shows an rqt plugin that is not known")
            return
        module, _, class_ = name.rpartition(".")
        node = ast.Pass(lineno=made.line, col_offset=0)
        found = self.attribute(self.import_module(module, 0, node, made.scope), class_, node, made.scope)
        if isinstance(found, Class):
            self.arrange(found, "start")
        else:
            made.doubt(f"it shows the rqt plugin {name}, whose source was not found")

    def _plugin_class(self, package: str) -> str:
        try:
            text = read_bytes(os.path.join(self.package, "plugin.xml")).decode("utf-8", "replace")
        except OSError:
            return ""
        classes = [match[1] for match in _PLUGIN.finditer(text)]
        return classes[0] if len(classes) == 1 else next((each for each in classes if each.startswith(f"{package}.")), "")

    def test_classes(self) -> list[Value]:
        """The test cases of the program."""
        main = next((module for module in self.modules.values() if module.name == "__main__"), None)
        return [] if main is None else [each for each in main.scope.variables.values() if isinstance(each, Class)]

    # -- dynamic_reconfigure ------------------------------------------------------------------------------------------------

    def configuration(self, package: str, name: str, namespace: Value, made: Call) -> None:
        """The params of ``package.cfg.<name>Config`` below a namespace."""
        path = self._modules_of_packages.configuration(package, name) if name else None
        if path is None:
            what = f"the params of {package}.cfg.{name}Config" if name else "the params that it reconfigures"
            made.doubt(f"{what} are not known", ("params",))
            return
        params, complete = configuration_params(path, self.root)
        for each in params:
            spelled = ros_name(joined([namespace, each.name.removeprefix("~")]))
            self.note({**each._asdict(), "name": spelled, "when": self.when, "condition": ""}, "")
        if not complete:
            made.doubt(f"some params of {name}.cfg are not known", ("params",))

    def note(self, fact: Any, condition: str) -> None:
        """Note a fact under the conditions that hold here."""
        super().note({key: value for key, value in fact.items() if key != "condition"}, condition)

    def configured(self, name: Value, type_: Value, default: Value, made: Call) -> None:
        """A param that a ``.cfg`` file describes."""
        kind = type_.name.rpartition(".")[2] if isinstance(type_, External) else type_ if isinstance(type_, str) else ""
        known = plain(default) if default is not MISSING else MISSING
        made.fact("params", joined(["~", name]), default=None if known is MISSING else known, value_type=TYPES.get(kind, ""))
