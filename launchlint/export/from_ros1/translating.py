"""A launch file of ROS 1 as the description of one of ROS 2, in the order in which roslaunch reads it."""

from __future__ import annotations

from launchlint.evaluate.ros1.launch_tags import TAGS
from launchlint.evaluate.session import Read, Session
from launchlint.export.from_ros1.choosing import SUBSTITUTION
from launchlint.export.from_ros1.frame import Account, Scope, Setting
from launchlint.export.from_ros1.nodes import MOST_CONDITIONS, Nodes
from launchlint.export.from_ros1.values import Values
from launchlint.export.ros2.comparing import normal
from launchlint.export.ros2.losses import Left, Lost, Remark
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Condition, Description, Pair, Substitution, Text, TypedValue
from launchlint.syntax.ros2.tables import distribution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from launchlint.source import Place
    from launchlint.syntax.ros2.description import Action
    from launchlint.syntax.tree import Document, Element

_NO_SERVER = "ROS 2 has no parameter server; give it to the nodes that read it"
_CALLED = {
    "node": ("name",),
    "param": ("name",),
    "arg": ("name",),
    "rosparam": ("file", "param", "ns"),
    "include": ("file",),
    "machine": ("name",),
}
"""What says which of several elements is meant."""
_SIM_TIME = ("use_sim_time", "/use_sim_time")


class Translated(NamedTuple):
    """``dropped`` are the places of elements whose params the proof leaves out."""

    description: Description
    lost: tuple[Lost, ...]
    remarks: tuple[Remark, ...]
    dropped: tuple[Place, ...]


def translate(session: Session, document: Document, values: Values, included: Mapping[int, str]) -> Translated:
    """The launch file ``document``. ``included`` are the files that its includes mean, by where these begin."""
    assert document.launch is not None
    account = Account()
    translation = _Translation(session, values, account, included)
    actions = translation.children(document.launch, Scope(), last=True)
    description = Description(tuple(actions), document.place(document.launch.start_span))
    return Translated(description, tuple(account.lost), tuple(dict.fromkeys(account.remarks)), tuple(account.dropped))


class _Translation:
    def __init__(self, session: Session, values: Values, account: Account, included: Mapping[int, str]) -> None:
        self._session = session
        self._values = values
        self._account = account
        self._included = included
        self._nodes = Nodes(values, account, chooses=SUBSTITUTION in distribution(session.distro).substitutions)

    def children(self, parent: Element, scope: Scope, *, last: bool) -> list[Action]:
        """What stands in a ``<launch>`` or ``<group>``. ``last``: nothing follows behind it in the file."""
        found: list[Action] = []
        known = [each for each in parent.children if each.tag in TAGS]
        addressed = self._addressed(known)
        for element in known:
            place = self._values.place(element)
            before = len(self._account.lost)
            try:
                condition = self._nodes.condition(element)
                if element.tag == "node":
                    found += self._nodes.node(element, scope, condition, addressed.get(_name(element), ()))
                elif element.tag in ("param", "rosparam"):
                    found += self._param(element, scope, condition, addressed)
                else:
                    found += self._other(element, scope, condition, last=last and element is known[-1])
            except Left as left:
                del self._account.lost[before:]
                called = next(filter(None, (element.get(name) for name in _CALLED.get(element.tag, ()))), "")
                name = f" {' '.join(called.split())}" if called else ""
                self._account.lose(left.place if left.place.source is place.source else place, f"the {element.tag}{name}", left.why)
                self._account.dropped.append(self._values.whole(element))
        return found

    def _other(self, element: Element, scope: Scope, condition: Condition | None, *, last: bool) -> list[Action]:
        tag, place = element.tag, self._values.place(element)
        if tag == "arg":
            return self._arg(element, scope, condition)
        if tag == "remap":
            scope.add(scope.remaps, self._nodes.remap(element)._replace(condition=condition))
            return []
        if tag == "env":
            name, value = self._must(element, "name"), self._must(element, "value")
            return [described.SetEnvironment(name, value, place, condition)]
        if tag == "group":
            return self._group(element, scope, condition)
        if tag == "include":
            return self._include(element, scope, condition, last=last)
        if tag == "machine":
            raise Left(place, "ROS 2 launch starts nothing on other machines")
        raise Left(place, "rostest has no counterpart; launch_testing has tests in Python")

    # -- args, groups and includes -------------------------------------------------------------------------------------

    def _arg(self, element: Element, scope: Scope, condition: Condition | None) -> list[Action]:
        place, name = self._values.place(element), self._nodes.literal(element, "name")
        scope.declared.append(name)
        value = self._values.attribute(element, "value")
        if value is not None:
            return [described.Let(Text((name,), place), value, place, condition)]
        doc = element.attributes["doc"].value if "doc" in element.attributes else ""
        try:
            default = self._values.attribute(element, "default")
        except Left as left:
            self._account.say(left.place, f"the default of the arg {name}", left.why)
            default = None
        return [described.Argument(name, default, doc, None, place, condition)]

    def _group(self, element: Element, scope: Scope, condition: Condition | None) -> list[Action]:
        place = self._values.place(element)
        inner: list[Action] = []
        namespace = self._values.attribute(element, "ns")
        if namespace is not None and namespace.literal != "":
            inner.append(described.PushNamespace(namespace, place))
        self._cleared(element)
        inner += self.children(element, Scope(scope), last=True)
        return [described.Group(tuple(inner), True, True, (), place, condition)] if inner else []

    def _include(self, element: Element, scope: Scope, condition: Condition | None, *, last: bool) -> list[Action]:
        """An include; one for each side of the conditions that its args have."""
        place = self._values.place(element)
        tests: dict[tuple[object, ...], Text] = {}
        for child in element.children:
            own = self._nodes.condition(child)
            if own is not None and child.tag.lower() == "arg":
                tests[tuple(normal(own.operands))] = own.operands[0]
        if len(tests) > MOST_CONDITIONS:
            raise Left(place, f"more than {MOST_CONDITIONS} conditions stand in it, and ROS 2 has none there")
        self._account.remark(place, f"{element.attributes['file'].value} has to be translated, too")
        if not tests:
            return self._included_once(element, scope, condition, {}, last=last)
        found = self._variants(element, scope, list(tests.items()), {})
        return found if condition is None else [described.Group(tuple(found), False, True, (), place, condition)]

    def _variants(
        self, element: Element, scope: Scope, tests: list[tuple[tuple[object, ...], Text]], chosen: dict[tuple[object, ...], str]
    ) -> list[Action]:
        if not tests:
            return self._included_once(element, scope, None, chosen, last=False)
        (key, text), *rest = tests
        found: list[Action] = []
        for kind in ("if", "unless"):
            inner = self._variants(element, scope, rest, {**chosen, key: kind})
            found.append(described.Group(tuple(inner), False, True, (), self._values.place(element), Condition(kind, (text,), text.place)))
        return found

    def _included_once(
        self, element: Element, scope: Scope, condition: Condition | None, chosen: Mapping[tuple[object, ...], str], *, last: bool
    ) -> list[Action]:
        place = self._values.place(element)
        file = self._must(element, "file")
        before: list[Action] = []
        namespace = self._values.attribute(element, "ns")
        if namespace is not None and namespace.literal != "":
            before.append(described.PushNamespace(namespace, place))
        before += [described.SetRemap(*each.remap, each.place, each.condition) for each in scope.remaps if each.remap is not None]
        if scope.private:
            self._account.say(place, "~params for what is included", "a param of ROS 2 belongs to one node")
        self._cleared(element)
        passed: dict[str, Pair] = {}
        for child in element.children:
            tag, at, own = child.tag.lower(), self._values.place(child), self._nodes.condition(child)
            if tag == "env":
                before.append(described.SetEnvironment(self._must(child, "name"), self._must(child, "value"), at, own))
            elif tag == "arg" and (own is None or chosen[tuple(normal(own.operands))] == own.kind):
                name = self._nodes.literal(child, "name")
                value = self._values.attribute(child, "value") or self._values.attribute(child, "default") or Text((), at)
                passed[name] = Pair(Text((name,), at), value, at)
        self._pass_on(element, scope, passed)
        included = described.Include(file, tuple(passed.values()), place)
        if not before and last and condition is None:
            return [included]
        return [described.Group((*before, included), True, True, (), place, condition)]

    def _pass_on(self, element: Element, scope: Scope, passed: dict[str, Pair]) -> None:
        """What the included file must be told, since ROS 2 hands on all that is set: of the args that both files have, the right values."""
        place = self._values.place(element)
        everything = "pass_all_args" in element.attributes and element.attributes["pass_all_args"].value.lower() == "true"
        for name, default in self._declared_in(self._included.get(element.start_span.start)).items():
            if name in passed or (name not in scope.declared and default is not None):
                continue
            if name not in scope.declared:
                passed[name] = Pair(Text((name,), place), Text((), place), place)
                self._account.remark(place, f"the arg {name} is passed empty, since ROS 2 wants all args without a default")
                continue
            if everything:
                passed[name] = Pair(Text((name,), place), Text((Substitution("var", (Text((name,), place),), place),), place), place)
            elif default is not None and "$" not in default:
                passed[name] = Pair(Text((name,), place), Text((default,) if default else (), place), place)
            elif default is not None:
                self._account.remark(place, f"both files have an arg {name}: in ROS 2, the included one gets the value that it has here")

    def _declared_in(self, file: str | None) -> dict[str, str | None]:
        """The args of a file that can be passed, with their defaults."""
        document = None if file is None else self._session.document(file)
        if document is None or isinstance(document, Read) or document.launch is None:
            return {}
        args = (each for each in document.launch.children if each.tag == "arg" and "value" not in each.attributes)
        return {each.attributes["name"].value: each.get("default") for each in args if "name" in each.attributes}

    def _cleared(self, element: Element) -> None:
        if "clear_params" in element.attributes and element.attributes["clear_params"].value.lower() != "false":
            self._account.say(self._values.place(element), "clear_params", "there is no parameter server to be cleared")

    # -- params outside of nodes ---------------------------------------------------------------------------------------

    def _param(self, element: Element, scope: Scope, condition: Condition | None, addressed: Mapping[str, list[Setting]]) -> list[Action]:
        place = self._values.place(element)
        if any(each.place == place for settings in addressed.values() for each in settings):
            return []
        name = self._nodes.literal(element, "name" if element.tag == "param" else "ns").strip()
        if name.startswith("~"):
            scope.add(scope.private, self._nodes.private(element)._replace(condition=condition, key=name))
            return []
        if element.tag == "param" and name in _SIM_TIME and "value" in element.attributes:
            value = TypedValue(self._values.of(element.attributes["value"]))
            return [described.SetParameter(Text(("use_sim_time",), place), value, place, condition)]
        if element.tag == "rosparam" and element.attributes.get("command") is not None:
            command = element.attributes["command"].value
            if command != "load":
                raise Left(place, f"command={command} has no counterpart")
        raise Left(place, _NO_SERVER)

    def _addressed(self, elements: list[Element]) -> dict[str, list[Setting]]:
        """Params outside of nodes whose names begin with that of a node beside them: they are params of that node, by its name."""
        nodes = {_name(each) for each in elements if each.tag == "node" and "$" not in _name(each) and "ns" not in each.attributes}
        found: dict[str, list[Setting]] = {}
        for element in elements:
            attribute = "name" if element.tag == "param" else "ns" if element.tag == "rosparam" else ""
            words = (element.get(attribute) or "").split("/", 1) if attribute else []
            if not words or words[0] not in nodes or (element.tag == "param" and len(words) < 2):
                continue
            command = element.attributes.get("command")
            if command is not None and command.value != "load":
                continue
            try:
                found.setdefault(words[0], []).append(self._nodes.addressed(element, words[1] if len(words) > 1 else ""))
            except Left:
                continue
        return found

    def _must(self, element: Element, name: str) -> Text:
        text = self._values.attribute(element, name)
        if text is None:
            raise Left(self._values.place(element), f"it lacks {name}")
        return text


def _name(element: Element) -> str:
    return (element.get("name") or "").strip()
