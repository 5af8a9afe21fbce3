"""A description as far as a declarative launch file can hold it, and what of it cannot be carried over.

What the front ends for XML and YAML lack, and Python has, is put into their words where that means exactly the same. The rest is left
out: the smallest part of an action that can be, else the action; each time it is said what, and why.
"""

from __future__ import annotations

from launchlint.evaluate.ros2.typed import TypeFault, convert
from launchlint.export.ros2.ending import ending, shuts_down
from launchlint.export.ros2.losses import Left, Lost, Remark, cut, in_words, no_tag, shown
from launchlint.export.ros2.said import is_sayable
from launchlint.export.ros2.shaping import Shaper
from launchlint.export.ros2.texts import NOWHERE, CannotWrite, TextWriter, joined
from launchlint.export.ros2.xml import attribute_text, check
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import (
    CALLED,
    FULL_NAME,
    NOT_KNOWN,
    Condition,
    Description,
    Parameter,
    ParameterFile,
    Parameters,
    Process,
    Substitution,
    Text,
    TypedValue,
)
from launchlint.syntax.ros2.loops import Loop
from launchlint.syntax.ros2.tables import Attribute
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

    from launchlint.export.ros2.portable import Portable
    from launchlint.export.ros2.tree import Branch
    from launchlint.syntax.ros2.description import Action, Component, ParameterSource
    from launchlint.syntax.ros2.tables import Distribution

_JOIN = "path-join"


class Carried(NamedTuple):
    """``description`` holds nothing but what can be written; ``lost`` what it lacks, ``remarks`` what a person should know.

    ``less`` is the same description where it does not do all that the original does, or does it by other actions.
    """

    description: Description
    lost: tuple[Lost, ...]
    remarks: tuple[Remark, ...]
    less: Description | None


def carried(description: Description, distribution: Distribution, *, xml: bool, portable: Portable | None = None) -> Carried:
    """What can be carried over of ``description``; ``xml``: into XML, which cannot hold every character.

    ``portable`` is for descriptions of programs: what they compute holds paths of this machine.
    """
    carrier = _Carrier(distribution, xml=xml, portable=portable)
    before = ending(description.actions) if carrier.can_end else description.actions
    made = Description(carrier.actions(before), description.place)
    other = carrier.lost or carrier.ends or before is not description.actions
    return Carried(made, tuple(carrier.lost), tuple(dict.fromkeys(carrier.remarks)), made if other else None)


class _Carrier:
    def __init__(self, distribution: Distribution, *, xml: bool, portable: Portable | None) -> None:
        self._portable = portable
        self._distribution = distribution
        self._texts = TextWriter(distribution)
        self._shaper = Shaper(distribution)
        self._xml = xml
        self.ends = False
        self.can_end = any(isinstance(each, Attribute) and each.name == "on_exit" for each in distribution.tags["node"].reads)
        self.lost: list[Lost] = []
        self.remarks: list[Remark] = []

    # -- actions -------------------------------------------------------------------------------------------------------

    def actions(self, actions: Iterable[Action]) -> tuple[Action, ...]:
        """Those that can be carried over, at least in part."""
        found: list[Action] = []
        for action in actions:
            if isinstance(action, described.Unsettled):  # it does nothing that a launch file could say
                self.remarks.append(Remark(action.place, action.reason))
                continue
            before = len(self.lost)
            try:
                made = self._action(action)
                self._writable(self._shaper.action(_bare(made)))
                found.append(made)
            except Left as left:
                del self.lost[before:]
                self.lost.append(Lost(left.place, in_words(action), left.why))
            except CannotWrite as cannot:
                del self.lost[before:]
                self.lost.append(Lost(action.place, in_words(action), cannot.reason))
        return tuple(found)

    def _writable(self, branch: Branch) -> None:
        """Raises CannotWrite."""
        if not self._xml:
            return
        for name, value in branch.attributes.items():
            check(attribute_text(value, typed=name in branch.typed))
        for each in branch.inner:
            self._writable(each)

    def _action(self, action: Action) -> Action:
        if isinstance(action, described.SetUseSimTime) and isinstance(action.value, bool):
            value = TypedValue(Text(("true" if action.value else "false",), action.place))
            name = Text(("use_sim_time",), action.place)
            action = described.SetParameter(name, value, action.place, action.condition)
        if not is_sayable(action):
            raise Left(action.place, no_tag(action))
        fields: dict[str, Any] = {}
        if action.condition is not None:
            fields["condition"] = self._condition(action.condition)
        if isinstance(action, (described.Group, described.Timer)):
            fields["actions"] = self.actions(action.actions)
        if isinstance(action, described.Opaque) and isinstance(action.call, Loop):
            fields["call"] = action.call._replace(over=self._text(action.call.over), actions=self.actions(action.call.actions))
        if isinstance(action, described.Timer) and isinstance(action.period, Text):
            period = fields["period"] = _seconds(self._text(action.period))
            if isinstance(period, Text) and period.literal is not None:
                raise Left(period.place, "its period is no number")
        if isinstance(action, (described.Node, described.LoadComponents)):
            fields["components"] = self._components(action.components)
        if isinstance(action, described.LoadComponents) and not fields["components"]:
            raise Left(action.place, "nothing is left of what it loads")
        if isinstance(action, described.Node):
            fields.update(self._kind(action), parameters=self._parameters(action.parameters))
        if isinstance(action, (described.Node, described.Executable)):
            fields["process"] = self._process(action.process)
        if isinstance(action, described.SetParameter):
            fields["value"] = self._computed(action.value, action.place)
        if isinstance(action, described.AppendEnvironment) and isinstance(action.prepend, Text):
            prepend = fields["prepend"] = _flag(self._text(action.prepend))
            if isinstance(prepend, Text) and prepend.literal is not None:
                raise Left(prepend.place, "prepend is neither true nor false")
        if isinstance(action, described.Argument):
            if action.choices == ():
                raise Left(action.place, "no value is among its choices")
            self._texts.word(action.name)
        made: Action = self._rest(action, fields)
        return made

    def _kind(self, node: described.Node) -> dict[str, Any]:
        """Which tag it gets, and what that must have."""
        if node.kind == "lifecycle":
            words = "a LifecycleNode is written as <node>: the same program, whose states launch does not follow"
            self.remarks.append(Remark(node.place, words))
        if node.kind != "container":
            return {"kind": "node"}
        if node.name is None or node.namespace is None:
            raise Left(node.place, "a <node_container> must have a name and a namespace")
        return {"name": self._text(node.name), "namespace": self._text(node.namespace)}

    def _components(self, components: tuple[Component, ...]) -> tuple[Component, ...]:
        found = (self._kept("a composable node", self._component, each) for each in components)
        return tuple(each for each in found if each is not None)

    def _component(self, component: Component) -> Component:
        fields: dict[str, Any] = {"parameters": self._parameters(component.parameters)}
        if component.condition is not None:
            fields["condition"] = self._condition(component.condition)
        if component.name is None:
            raise Left(component.place, "a <composable_node> must have a name")
        fields["name"] = self._text(component.name)
        made: Component = self._rest(component, fields)
        return made

    def _process(self, process: Process) -> Process:
        fields: dict[str, Any] = {}
        if process.environment or process.replaces_environment:
            place = process.environment[0].place if process.environment else _somewhere(process)
            self.lost.append(Lost(place, "env", "a whole environment cannot be given, only single variables"))
            fields.update(environment=(), replaces_environment=False)
        if self.can_end and shuts_down(process.on_exit):
            self.ends, fields["on_exit"] = True, "shutdown"
        elif isinstance(process.on_exit, tuple):
            self.lost.append(Lost(_place(process.on_exit), "on_exit", "only shutdown can follow the end of a process"))
            fields["on_exit"] = None
        respawn = process.respawn
        if isinstance(respawn, bool):
            fields["respawn"] = Text(("true",), _somewhere(process)) if respawn else None
        for name in ("emulate_tty", "shell"):
            value = getattr(process, name)
            if isinstance(value, Text):
                known = _flag(value)
                if isinstance(known, Text):
                    self.lost.append(Lost(value.place, name, "it takes true or false, and nothing that is computed"))
                fields[name] = known if isinstance(known, bool) else None
        for name in ("sigterm_timeout", "sigkill_timeout"):
            value = getattr(process, name)
            if value is None:
                continue
            seconds = _seconds(value)
            if isinstance(seconds, Text) or seconds < 0:
                self.lost.append(Lost(value.place, name, "it takes a number, and nothing that is computed"))
                fields[name] = None
            else:
                fields[name] = Text((str(seconds),), value.place)
        made: Process = self._rest(process, fields)
        return made

    def _rest(self, item: Any, fields: dict[str, Any]) -> Any:
        """``item`` with ``fields`` in place of its own, and all other texts in it as they can be written. Raises Left."""
        kinds = type(item).__annotations__
        for name, value in zip(item._fields, item, strict=True):
            if name in fields:
                continue
            if isinstance(value, Text):
                try:
                    fields[name] = self._text(value)
                except Left as left:
                    if "None" not in _written(kinds[name]):
                        raise
                    self.lost.append(Lost(value.place, f"{name} of {in_words(item)}", left.why))
                    fields[name] = None
            elif isinstance(value, tuple) and not hasattr(value, "_fields") and name not in ("choices", "actions"):
                fields[name] = self._each(item, name, value)
        return item._replace(**fields)

    def _each(self, item: Any, name: str, values: tuple[Any, ...]) -> tuple[Any, ...]:
        if isinstance(item, described.Executable):
            return tuple(map(self._one, values))
        if values and isinstance(values[0], Text):  # the words of a command line: without one of them the others would say something else
            return self._kept(f"{name} of {in_words(item)}", lambda words: tuple(map(self._text, words)), values) or ()
        found = (self._kept(f"one of the {name} of {in_words(item)}", self._one, value) for value in values)
        return tuple(each for each in found if each is not None)

    def _one(self, value: Any) -> Any:
        if isinstance(value, Text):
            return self._text(value)
        if isinstance(value, Parameter) and value.value is not None:  # an extra argument
            return Parameter(self._text(value.name), self._computed(value.value, value.place), (), value.place)
        return self._rest(value, {})

    def _kept(self, what: str, make: Callable[[Any], Any], given: Any) -> Any:
        """What ``make`` makes of ``given``; None where that is lost, which is noted."""
        before = len(self.lost)
        try:
            return make(given)
        except Left as left:
            del self.lost[before:]
            self.lost.append(Lost(left.place, what, left.why))
            return None

    # -- params --------------------------------------------------------------------------------------------------------

    def _parameters(self, sources: Iterable[ParameterSource]) -> tuple[ParameterSource, ...]:
        found: list[ParameterSource] = []
        for source in sources:
            for each in source.entries if isinstance(source, Parameters) else (source,):
                what, make = ("a param", self._parameter) if isinstance(each, Parameter) else ("a file of params", self._file)
                kept = self._kept(what, make, each)
                if kept is not None:
                    found.append(kept)
        return tuple(found)

    def _file(self, source: ParameterSource) -> ParameterSource:
        if not isinstance(source, ParameterFile):
            raise Left(source.place, "XML and YAML have nothing for it")
        allowed = source.allow_substs
        if isinstance(allowed, Text):
            allowed = _flag(self._text(allowed))
        return ParameterFile(self._text(source.file), allowed, source.place)

    def _parameter(self, parameter: Parameter) -> Parameter:
        name = self._text(parameter.name)
        if parameter.value is None:
            nested = tuple(each for each in (self._kept("a param", self._parameter, each) for each in parameter.nested) if each is not None)
            if not nested:
                raise Left(parameter.place, "it holds nothing that can be carried over")
            return Parameter(name, None, nested, parameter.place)
        return Parameter(name, self._value(parameter.value), (), parameter.place)

    def _value(self, value: TypedValue) -> TypedValue:
        if not isinstance(value.value, Text):
            known = value.plain if isinstance(value.plain, tuple) else (None,) * len(value.value)
            texts = tuple(self._of_value(text, plain) for text, plain in zip(value.value, known, strict=True))
            plains = tuple(_known(text, None, plain) for text, plain in zip(texts, known, strict=True))
            return TypedValue(texts, value.type, plains)
        text = self._of_value(value.value, value.plain)
        type_ = "str" if isinstance(value.plain, str) and text.literal is None else value.type
        return TypedValue(text, type_, _known(text, value.type, value.plain))

    def _of_value(self, text: Text, plain: object) -> Text:
        return self._text(text._replace(pieces=(plain,)) if isinstance(plain, str) else text)

    def _computed(self, value: TypedValue, place: Place) -> TypedValue:
        """A value that is always a text, and read when it is needed."""
        if not isinstance(value.value, Text):
            raise Left(place, "it is a list that is computed item by item")
        return TypedValue(self._text(value.value))

    # -- texts and conditions ------------------------------------------------------------------------------------------

    def _condition(self, condition: Condition) -> Condition:
        if condition.kind in ("if", "unless"):
            return condition._replace(operands=(self._text(condition.operands[0]),))
        if len(condition.operands) < 2:
            raise Left(condition.place, "its condition asks whether an arg is set at all")
        name, value = condition.operands
        if name.literal is None or not name.literal.isidentifier() or value.literal is None or not _quiet(value.literal):
            raise Left(condition.place, "its condition compares in a way that XML and YAML cannot")
        asked = Substitution("var", (name,), condition.place)
        code = Text(("'", asked, f"' == '{value.literal}'"), condition.place)
        compared = Text((Substitution("eval", (code,), condition.place),), condition.place)
        self.remarks.append(Remark(condition.place, f"a comparison with {value.literal!r} fails where {name.literal} is not set at all"))
        return Condition("if" if condition.kind == "equals" else "unless", (self._text(compared),), condition.place)

    def _text(self, text: Text) -> Text:
        try:
            made = Text(self._pieces(text), text.place)
            self._texts.text(made)
            return made
        except CannotWrite as cannot:
            raise Left(text.place, cannot.reason) from None

    def _pieces(self, text: Text) -> tuple[str | Substitution, ...]:
        found: list[str | Substitution] = []
        for piece in text.pieces:
            if isinstance(piece, str):
                found += self._literal(piece, text.place)
            elif piece.name == _JOIN:
                found += self._path(piece)
            elif piece.name == FULL_NAME:
                found += self._container(piece)
            elif piece.name == NOT_KNOWN:
                raise Left(piece.place, f"{shown(piece.place)} is not known ({piece.arguments[0].literal})")
            elif piece.name == CALLED:
                raise Left(piece.place, f"{shown(piece.place)} is a substitution that the program has made itself")
            elif piece.name not in self._distribution.substitutions:
                raise Left(piece.place, f"XML and YAML have no {piece.name or 'such substitution'}")
            else:
                found.append(piece._replace(arguments=tuple(Text(self._pieces(each), each.place) for each in piece.arguments)))
        return joined(found)

    def _literal(self, text: str, place: Place) -> list[str | Substitution]:
        if self._portable is None or "/" not in text:
            return [text]
        found = self._portable.pieces(text, place)
        if any(isinstance(each, str) and self._portable.is_local(each) for each in found):
            self.remarks.append(Remark(place, f"{cut(text)} is a path of this machine that lies in no package"))
        return found

    def _container(self, substitution: Substitution) -> tuple[str | Substitution, ...]:
        """The full name of a container, which counts from the top: what is pushed before the container is not seen here."""
        namespace, name = (self._pieces(each) for each in substitution.arguments)
        whole = joined((*namespace, *([] if namespace in ((), ("/",)) else ["/"]), *name))
        whole = whole if whole and isinstance(whole[0], str) and whole[0].startswith("/") else joined(("/", *whole))
        self.remarks.append(
            Remark(
                substitution.place,
                f"a container is named {self._texts.text(Text(whole, substitution.place))}: so it is called where no namespace is pushed",
            )
        )
        return whole

    def _path(self, substitution: Substitution) -> list[str | Substitution]:
        """The parts of a path, joined by slashes, where os.path.join would do the same."""
        found: list[str | Substitution] = []
        for number, part in enumerate(substitution.arguments):
            pieces = self._pieces(part)
            first = pieces[0] if pieces else ""
            if number and isinstance(first, str) and first.startswith("/"):
                found = []
            elif number and found:
                last = found[-1]
                found += [] if isinstance(last, str) and last.endswith("/") else ["/"]
            if number and not isinstance(first, str):
                shown = self._texts.text(Text(pieces, part.place))
                self.remarks.append(Remark(part.place, f"a path is joined with /: the same, as long as {shown} is no absolute path"))
            found += pieces
        return found


def _known(text: Text, wanted: str | None, plain: Any) -> Any:
    """What launch knows of a value when it reads the file: of a text without substitutions, what it becomes."""
    if text.literal is None:
        return None if isinstance(plain, str) else plain
    if plain is not None:
        return plain
    try:
        value = convert(text.literal, wanted)
    except (TypeFault, YamlBeyond):
        raise Left(text.place, "it is no value of its type") from None
    if isinstance(value, list):
        raise Left(text.place, "it is a list that is written as a text")
    return value


def _seconds(text: Text) -> Text | float:
    try:
        return text if text.literal is None else float(text.literal)
    except ValueError:
        return text


def _flag(text: Text) -> Text | bool:
    word = "" if text.literal is None else text.literal.strip().lower()
    return word == "true" if word in ("true", "false") else text


def _quiet(text: str) -> bool:
    """Whether a text stands for itself between quotes of Python."""
    return text.isprintable() and not any(char in "'\"\\$()" for char in text)


def _place(actions: tuple[Action, ...]) -> Place:
    return actions[0].place


def _somewhere(process: Process) -> Place:
    texts = (value for value in process if isinstance(value, Text))
    return next((text.place for text in texts), NOWHERE)


def _bare(action: Action) -> Action:
    """An action without those in it."""
    if isinstance(action, (described.Group, described.Timer)):
        return action._replace(actions=())
    if isinstance(action, described.Opaque) and isinstance(action.call, Loop):
        return action._replace(call=action.call._replace(actions=()))
    return action


def _written(kind: object) -> str:
    return str(getattr(kind, "__forward_arg__", kind))
