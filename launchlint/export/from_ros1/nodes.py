"""A ``<node>`` of ROS 1 as one of ROS 2, with everything that acts on it."""

from __future__ import annotations

from launchlint.evaluate.names import canonical
from launchlint.export.from_ros1.choosing import chosen
from launchlint.export.from_ros1.frame import Account, Scope, Setting
from launchlint.export.from_ros1.params import Params, dotted
from launchlint.export.from_ros1.values import Values
from launchlint.export.ros2.comparing import normal
from launchlint.export.ros2.losses import Left
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.command_line import command_line
from launchlint.syntax.ros2.description import Condition, Pair, Process, Remap, Substitution, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Literal

    from launchlint.problem import Problem
    from launchlint.source import Place
    from launchlint.syntax.ros2.description import Action, ParameterSource
    from launchlint.syntax.tree import Element

MOST_CONDITIONS = 3
"""Conditions of children of one node: each doubles it."""
_ONE_WORD = "what is put into args is one word in ROS 2, also where it is empty or blanks stand in it"
_LOST = {
    "machine": "ROS 2 launch starts nothing on other machines",
    "clear_params": "there is no parameter server to be cleared",
}


class Nodes:
    """Makes the nodes of one file. ``chooses``: the distribution has ``$(if …)``."""

    def __init__(self, values: Values, account: Account, *, chooses: bool) -> None:
        self._values = values
        self._account = account
        self._chooses = chooses
        self.params = Params(values, account)

    def node(self, element: Element, scope: Scope, condition: Condition | None, addressed: Iterable[Setting]) -> list[Action]:
        """The actions of one node; several where children of it have conditions. Raises Left."""
        place = self._values.place(element)
        package, type_ = (self._values.attribute(element, name) for name in ("pkg", "type"))
        if package is None or type_ is None:
            raise Left(place, "it lacks pkg or type")
        if package.literal == "nodelet":
            words = " ".join(element.attributes["args"].value.split()) if "args" in element.attributes else ""
            raise Left(place, f"a nodelet ({words}): ROS 2 has components, in a <node_container> with <composable_node>s")
        settings = [*scope.remaps, *addressed, *scope.private, *self._own(element)]
        if self._chooses:
            settings = chosen(settings)
        tests = {_test(each.condition): each.condition.operands[0] for each in settings if each.condition is not None}
        conditions = list(tests.values())
        if len(conditions) > MOST_CONDITIONS:
            raise Left(place, f"more than {MOST_CONDITIONS} conditions stand in it, and ROS 2 has none there")
        if conditions:
            self._account.remark(place, "conditions of what stands in a <node> are written as several nodes, of which one is started")
        return self._variants(element, package, type_, settings, conditions, condition)

    def _variants(
        self, element: Element, package: Text, type_: Text, settings: list[Setting], conditions: list[Text], condition: Condition | None
    ) -> list[Action]:
        """The node for each side of each of ``conditions``, below ``condition``."""
        if not conditions:
            return [self._made(element, package, type_, settings, condition)]
        first, *rest = conditions
        found: list[Action] = []
        test = tuple(normal((first,)))
        for kind in ("if", "unless"):
            kept = [
                each._replace(condition=None) if _test(each.condition) == test else each
                for each in settings
                if _test(each.condition) != test or (each.condition is not None and each.condition.kind == kind)
            ]
            found += self._variants(element, package, type_, kept, rest, _condition(kind, first))
        return found if condition is None else [described.Group(tuple(found), False, True, (), self._values.place(element), condition)]

    def _made(self, element: Element, package: Text, type_: Text, settings: list[Setting], condition: Condition | None) -> Action:
        place = self._values.place(element)
        for name, why in _LOST.items():
            if name in element.attributes and element.attributes[name].value.lower() != "false":
                self._account.say(place, name, why)
        remaps: dict[str, Remap] = {}
        sources: list[ParameterSource] = []
        for number, each in enumerate(settings):
            if each.remap is not None:
                key = each.key or f"?{number}"
                remaps.pop(key, None)
                remaps[key] = Remap(*each.remap, each.place)
            sources += each.sources
        words, ros_words = self._words(element, place)
        return described.Node(
            "node",
            package,
            type_,
            self._values.attribute(element, "name"),
            self._values.attribute(element, "ns"),
            words,
            ros_words,
            tuple(remaps.values()),
            tuple(sources),
            (),
            self._process(element, place),
            place,
            condition,
        )

    def _words(self, element: Element, place: Place) -> tuple[tuple[Text, ...], tuple[Text, ...]]:
        """The arguments, and what of them are remaps and params: ``a:=b`` stands behind ``--ros-args`` in ROS 2."""
        text = self._values.attribute(element, "args")
        if text is None or not text.pieces:
            return (), ()
        problems: list[Problem] = []
        words, ros_words = list[Text](), list[Text]()
        for word in command_line(text, "node", "args", problems):
            first = word.pieces[0] if word.pieces else ""
            name, separator, rest = first.partition(":=") if isinstance(first, str) else ("", "", "")
            if not separator:
                if word.pieces:
                    words.append(word)
                continue
            private = name.startswith("_") and not name.startswith("__")
            pieces = (f"{dotted(name[1:]) if private else _name(name)}:={rest}", *word.pieces[1:])
            ros_words += [Text(("-p" if private else "-r",), place), Text(pieces, place)]
        if any(isinstance(piece, Substitution) and piece.name in ("var", "env", "eval") for piece in text.pieces):
            self._account.remark(place, f"{_ONE_WORD}: {' '.join(element.attributes['args'].value.split())}")
        return tuple(words), tuple(ros_words)

    def _process(self, element: Element, place: Place) -> Process:
        values = self._values
        required = element.attributes.get("required")
        delay = element.attributes.get("respawn_delay")
        cwd = element.attributes.get("cwd")
        seconds = None
        if delay is not None:
            try:
                seconds = float(delay.value)
            except ValueError:
                self._account.say(place, "respawn_delay", "it takes a number, and nothing that is computed")
        if cwd is not None and cwd.value.lower() not in ("ros_home", "ros-root"):
            self._account.say(place, "cwd", "a path is wanted in ROS 2")
        on_exit: Literal["shutdown"] | None = None
        if required is not None and required.value.lower() == "true":
            on_exit = "shutdown"
        elif required is not None and required.value.lower() != "false":
            self._account.say(place, "required", "that the end of a process ends the launch cannot be computed")
        respawn = values.attribute(element, "respawn")
        output = values.attribute(element, "output")
        pairs = []
        for child in element.children:
            if child.tag.lower() == "env":
                if _has_condition(child):
                    self._account.lose(values.place(child), "env", "ROS 2 has no condition there")
                    continue
                name, value = values.attribute(child, "name"), values.attribute(child, "value")
                if name is not None and value is not None:
                    pairs.append(Pair(name, value, values.place(child)))
        return Process(
            prefix=values.attribute(element, "launch-prefix"),
            output=None if output is None or not output.pieces else output,
            respawn=None if respawn is None or respawn.literal in ("false", "False") else respawn,
            respawn_delay=seconds,
            on_exit=on_exit,
            additional_environment=tuple(pairs),
        )

    # -- what acts on nodes --------------------------------------------------------------------------------------------

    def _own(self, element: Element) -> list[Setting]:
        found: list[Setting] = []
        for child in element.children:
            tag = child.tag.lower()
            try:
                if tag == "remap":
                    found.append(self.remap(child))
                elif tag in ("param", "rosparam"):
                    found.append(self.private(child))
            except Left as left:
                self._account.lose(self._values.place(child), f"a {tag}", left.why)
                self._account.dropped.append(self._values.whole(child))
        return found

    def condition(self, element: Element) -> Condition | None:
        """The condition of an element. Raises Left."""
        for kind in ("if", "unless"):
            text = self._values.attribute(element, kind)
            if text is not None:
                return Condition(kind, (text,), text.place)
        return None

    def remap(self, element: Element) -> Setting:
        """A ``<remap>``. Raises Left."""
        place = self._values.place(element)
        source, target = (self._values.attribute(element, name) for name in ("from", "to"))
        if source is None or target is None:
            raise Left(place, "it lacks from or to")
        return Setting(
            canonical(source.literal) if source.literal is not None else "",
            self.condition(element),
            place,
            (_renamed(source), _renamed(target)),
        )

    def private(self, element: Element) -> Setting:
        """A ``<param>`` or ``<rosparam>`` of a node. Raises Left."""
        place, condition = self._values.place(element), self.condition(element)
        if element.tag.lower() == "param":
            name = self.literal(element, "name").strip()
            if name.startswith("/"):
                raise Left(place, f"{name} is a param of all, and ROS 2 has none; give it to the nodes that read it")
            return Setting("", condition, place, sources=(self.params.param(element, dotted(name)),))
        inner = ".".join(filter(None, (dotted(self.literal(element, each)) for each in ("ns", "param"))))
        if any(self.literal(element, each).startswith("/") for each in ("ns", "param")):
            raise Left(place, "it sets params of all, and ROS 2 has none; give them to the nodes that read them")
        return Setting("", condition, place, sources=tuple(self.params.rosparam(element, f"{inner}." if inner else "")))

    def addressed(self, element: Element, name: str) -> Setting:
        """A param outside of the node that it belongs to; ``name`` is what is left of its name there. Raises Left."""
        place, condition = self._values.place(element), self.condition(element)
        if element.tag.lower() == "param":
            return Setting("", condition, place, sources=(self.params.param(element, dotted(name)),))
        inner = ".".join(filter(None, (dotted(name), dotted(self.literal(element, "param")))))
        return Setting("", condition, place, sources=tuple(self.params.rosparam(element, f"{inner}." if inner else "")))

    def literal(self, element: Element, name: str) -> str:
        """An attribute that must not be computed; empty where it is not there. Raises Left."""
        text = self._values.attribute(element, name)
        if text is None:
            return ""
        if text.literal is None:
            raise Left(text.place, f"its {name} is computed")
        return text.literal


def _test(condition: Condition | None) -> tuple[object, ...]:
    """What a condition looks at, wherever it is written."""
    return () if condition is None else tuple(normal(condition.operands))


def _condition(kind: str, operand: Text) -> Condition:
    return Condition("if" if kind == "if" else "unless", (operand,), operand.place)


def _has_condition(element: Element) -> bool:
    return "if" in element.attributes or "unless" in element.attributes


def _name(name: str) -> str:
    """A graph name: private ones have a slash behind the tilde in ROS 2."""
    if name.startswith("~") and not name.startswith("~/"):
        name = f"~/{name[1:]}"
    return name.rstrip("/") or name


def _renamed(text: Text) -> Text:
    if text.literal is not None:
        return Text((_name(canonical(text.literal)),), text.place)
    first = text.pieces[0]
    if isinstance(first, str) and first.startswith("~") and not first.startswith("~/"):
        return Text((f"~/{first[1:]}", *text.pieces[1:]), text.place)
    return text
