"""What launch_ros makes of a node's params: files, the content of files that it writes for the start, and rules, in command-line order.

Source: ``launch_ros.actions.node`` (``_perform_substitutions``), ``launch_ros.parameter_descriptions`` and
``launch_ros.utilities.normalize_parameters`` and ``evaluate_parameters``.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterable
from functools import partial
from typing import Any, Protocol

from launchlint.evaluate.ros2.parameter_problems import CommandReadAsYaml, ContentNoYaml, ParameterValueType
from launchlint.evaluate.ros2.typed import TypeFault, by_yaml_rules, convert, is_uniform, load_file
from launchlint.evaluate.session import WRITTEN
from launchlint.late import late
from launchlint.model import StandIn, Unknown, UnknownText, shown_text
from launchlint.named_tuple import NamedTuple
from launchlint.rcl.table import ANY
from launchlint.source import Source
from launchlint.syntax.ros2.description import Parameter, ParameterFile, Parameters, Substitution, Text
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn, TypeAlias

    from launchlint.evaluate.session import Read, Session
    from launchlint.problem import Problem
    from launchlint.source import Origin, Place
    from launchlint.syntax.ros2.description import ParameterSource, SetParameter, TypedValue

PARAMETERS = "ros__parameters"
_QUOTES = ("'", '"', "&quot;", "&apos;")
_DESCRIBES = late(r"\bxacro\b|\.(?:xacro|urdf|sdf|srdf)\b")
_ROBOT = late(r"\s['\"]?(/[^\s'\"]+\.(?:xacro|urdf|sdf|srdf))\b")
_HERE = (".", "..")
LETTERS = ("y", "Y", "n", "N")
"""Texts to everybody but rcl: letters."""


class Performs(Protocol):
    """What is asked of the evaluation: what texts stand for at this moment. ``outside`` turns true where one reads the environment."""

    outside: bool

    @property
    def session(self) -> Session:
        """Whose files these are."""

    @property
    def digits_are_boolean(self) -> bool:
        """Whether ``1`` and ``0`` are truth values."""

    @property
    def tags_count(self) -> bool:
        """Whether a tag in a parameter file says of which type a value is."""

    def perform(self, text: Text) -> str | Unknown:
        """The string that a text stands for. Raises where launch stops."""

    def perform_content(self, source: Source) -> str | Unknown:
        """A file with all substitutions in it performed. Raises where launch stops."""

    def where(self, place: Place) -> Origin:
        """The origin of a place."""

    def notice(self, problem: Problem) -> None:
        """Something that does not stop launch."""

    def fail(self, problem: Problem) -> NoReturn:
        """Stop: launch does."""


class GlobalParameter(NamedTuple):
    """What ``<set_parameter>`` leaves: ``text`` is the value as it stands on command lines; a list is a tuple.

    ``meant``: somebody has put the value in quotes, so that it is a text.
    """

    name: str | Unknown
    text: str
    value: Any
    origin: Origin
    meant: bool = False

    def doubted(self, reason: str) -> GlobalParameter:
        """The same where it is not known whether it is set at all."""
        return self if isinstance(self.value, Unknown) else self._replace(value=Unknown(self.text, reason))


class GlobalFile(NamedTuple):
    """What ``<set_parameters_from_file>`` leaves."""

    file: str | Unknown
    origin: Origin

    def doubted(self, reason: str) -> GlobalFile:
        """The same where it is not known whether it is set at all."""
        return self if isinstance(self.file, Unknown) else self._replace(file=Unknown(self.file, reason))


GlobalSource: TypeAlias = "GlobalParameter | GlobalFile"


class TextValue(NamedTuple):
    """A value of a param that is a text; ``meant``: because somebody says so, by ``type`` or by quotes, or since it is a letter."""

    name: str
    value: str
    place: Place
    meant: bool


class Passed(NamedTuple):
    """One of the things that a node gets on its command line.

    One of the first three is not None: a ``file``; the ``content`` of one that launch writes, as YAML reads it; a ``rule``
    (``name:=value``). ``text`` is what rcl finds in the file, where that is not what PyYAML makes of ``content``; ``of`` the file it is
    made from. ``unknown`` says that not all of it is known: values that are not are :class:`Unknown`, and a file is one altogether.
    ``given`` is the ``<set_parameter>`` that a rule stands for; ``texts`` are the values of ``content`` that are texts to launch.
    """

    origin: Origin
    file: str | None = None
    content: Any = None
    rule: str | None = None
    text: str | None = None
    of: str | None = None
    unknown: bool = False
    given: GlobalParameter | None = None
    texts: tuple[TextValue, ...] = ()


def set_parameter(action: SetParameter, asks: Performs) -> GlobalParameter:
    """What one ``<set_parameter>`` adds to those in force. Raises where launch stops."""
    origin = asks.where(action.place)
    name = asks.perform(action.name)
    value = _by_yaml_rules(name, action.value, asks)
    text = value.text if isinstance(value, Unknown) else value if isinstance(value, str) else str(value)
    return GlobalParameter(name, text, value, origin, isinstance(value, str) and _is_quoted(action.value))


def node_parameters(
    own: Iterable[ParameterSource], in_force: Iterable[GlobalSource], full_name: str | Unknown | None, asks: Performs
) -> list[Passed]:
    """What stands on the command line of a node. Raises where launch stops.

    Args:
        own: the node's own params.
        in_force: what ``<set_parameter>`` and ``<set_parameters_from_file>`` left, in order.
        full_name: namespace and name, if launch knows both: what is written for this start stands under it.
        asks: who performs texts.
    """
    passed: list[Passed] = []
    for each in in_force:
        if isinstance(each, GlobalParameter):
            unknown = isinstance(each.name, Unknown) or isinstance(each.value, Unknown)
            name = each.name.text if isinstance(each.name, Unknown) else each.name
            rule = f"{name}:={each.text}"
            passed.append(Passed(each.origin, rule=_unless_known(rule, each), unknown=unknown, given=each))
        elif isinstance(each.file, Unknown):
            passed.append(Passed(each.origin, file=shown_text(each.file), unknown=True))
        else:
            if not posixpath.isabs(each.file) or not asks.session.exists(each.file):
                asks.fail(missing(each.file, each.origin, "filename", asks))
            passed.append(Passed(each.origin, file=posixpath.normpath(each.file)))
    for source in own:
        given = parameter_file(source, asks) if isinstance(source, ParameterFile) else _content(source, full_name, asks)
        if given is not None:
            passed.append(given)
    return passed


def _unless_known(rule: str, given: GlobalParameter) -> str:
    """A rule as text, which is not one to be compared where a part of it is not known."""
    unknown = next((each for each in (given.name, given.value) if isinstance(each, Unknown) and not isinstance(each, StandIn)), None)
    return rule if unknown is None else UnknownText(rule, unknown.reason)


def parameter_file(source: ParameterFile, asks: Performs, must_exist: bool = False) -> Passed | None:
    """A file of a node, or what launch makes of it; None where there is none, which only warns. Raises where launch stops."""
    origin = asks.where(source.place)
    outside, asks.outside = asks.outside, False
    file = asks.perform(source.file)
    environment = asks.outside
    asks.outside |= outside
    substitute = source.allow_substs
    if isinstance(substitute, Text):
        said = asks.perform(substitute)
        if isinstance(said, Unknown):
            return Passed(origin, file=UnknownText(source.file.place.text, said.reason), unknown=True)
        substitute = _boolean(said, substitute, asks)
    if isinstance(file, Unknown):
        return Passed(origin, file=shown_text(file), unknown=True)
    read = _read(file, asks)
    if read is None or read.data is None:
        must_exist = must_exist or substitute
        problem = missing(file, asks.where(source.file.place), "from", asks, must_exist, environment)
        if must_exist:
            asks.fail(problem)
        asks.notice(problem)
        return None
    file = posixpath.normpath(file)
    if file.startswith(WRITTEN):
        made = _made(file, read.data, substitute is True, asks)
        if made is not None:
            return Passed(origin, content=made[0], text=made[1], of=file)
    if not substitute:
        return Passed(origin, file=file)
    text = asks.perform_content(source_of(file, read.data, asks))
    if isinstance(text, Unknown):
        return Passed(origin, content=text, of=file, unknown=True)
    content = asks.session.by_text.once(text, load_file, partial(_loaded, text))
    if isinstance(content, YamlError):
        asks.fail(ContentNoYaml(origin=origin, refused=True, file=file, reason=content.message))
    if isinstance(content, YamlBeyond):
        return Passed(origin, content=Unknown(text[:100], content.message), of=file, unknown=True)
    return Passed(origin, content=content, text=text, of=file)


def _loaded(text: str) -> Any:
    """What PyYAML makes of a whole file, or why it makes nothing of it."""
    try:
        return load_file(text)
    except (YamlError, YamlBeyond) as error:
        return error.with_traceback(None)


def _made(file: str, data: bytes, substitute: bool, asks: Performs) -> tuple[Any, str] | None:
    """What is in a file that the launch itself has written; None where texts in it have to be performed first, or it is no YAML."""
    if substitute and b"$(" in data:
        return None
    known: tuple[Any, str] | None = asks.session.loaded.get(f"made {file}")
    if known is None:
        text = data.decode("utf-8")
        try:
            known = asks.session.loaded[f"made {file}"] = (load_file(text), text)
        except (YamlError, YamlBeyond):
            return None
    return known


def values(source: Parameter | Parameters, asks: Performs, texts: list[TextValue] | None = None) -> dict[str, Any]:
    """What one ``<param>`` or dict sets, those in it joined by points; what is not known is Unknown. Raises where launch stops.

    ``texts`` is filled with the values that are texts.
    """
    found: dict[str, Any] = {}
    for each in source.entries if isinstance(source, Parameters) else (source,):
        _collect(each, "", found, [] if texts is None else texts, asks)
    return found


def source_of(file: str, data: bytes, asks: Performs) -> Source:
    """The text of a file, read once."""
    known = asks.session.sources.get(file)
    if known is None:
        known = Source(asks.session.shown(file), data.decode("utf-8", "replace").removeprefix("\ufeff"), file)
        asks.session.sources[file] = known
    return known


def missing(file: str, origin: Origin, attribute: str, asks: Performs, refused: bool = True, environment: bool = False) -> Problem:
    """The problem of a file that cannot be read; a relative one counts from wherever ros2 launch is called."""
    from launchlint.evaluate.missing_file import NO_SUCH_FILE, missing_file  # only a file that is not there pays for it

    reason = (
        asks.session.read(file).reason
        if posixpath.isabs(file)
        else "it is a directory"
        if file and posixpath.normpath(file) in _HERE
        else ""
    )
    return missing_file(asks.session, origin, attribute, file, reason or NO_SUCH_FILE, environment=environment, refused=refused)


def _read(file: str, asks: Performs) -> Read | None:
    return asks.session.read(file) if posixpath.isabs(file) else None


def _content(source: Parameter | Parameters, full_name: str | Unknown | None, asks: Performs) -> Passed:
    texts: list[TextValue] = []
    found = values(source, asks, texts)
    unnamed = next((name for name in found if isinstance(name, UnknownText)), None)
    if unnamed is not None:
        return Passed(asks.where(source.place), file=unnamed, unknown=True, texts=tuple(texts))
    unknown = isinstance(full_name, Unknown) or any(isinstance(each, Unknown) for each in found.values())
    key = ANY if full_name is None else shown_text(full_name)
    return Passed(asks.where(source.place), content={key: {PARAMETERS: found}}, unknown=unknown, texts=tuple(texts))


def _collect(source: Parameter, before: str, found: dict[str, Any], texts: list[TextValue], asks: Performs) -> None:
    name = asks.perform(source.name)
    full = f"{before}{name.text if isinstance(name, Unknown) else name}"
    hidden = name if isinstance(name, Unknown) else before if isinstance(before, UnknownText) else None
    if hidden is not None:
        full = UnknownText(full, hidden.reason)
    if source.value is None:
        for inner in source.nested:
            below = f"{full}."
            _collect(inner, UnknownText(below, full.reason) if isinstance(full, UnknownText) else below, found, texts, asks)
        return
    value = _value(full, source.value, asks)
    written = source.value.value if isinstance(source.value.value, Text) else source.value.value[0] if source.value.value else source.name
    for each in value if isinstance(value, list) else [value]:
        if isinstance(each, str):
            meant = source.value.type in ("str", "list_of_str") or each in LETTERS or _is_quoted(source.value)
            texts.append(TextValue(full, each, written.place, meant))
    found[full] = Unknown(full, name.reason) if isinstance(name, Unknown) else value


def _value(name: str, value: TypedValue, asks: Performs) -> Any:
    """A value by launch's rules (perform_typed_substitution)."""
    if isinstance(value.value, Text):
        if value.plain is not None:
            return value.plain
        return _converted(name, value.value, value.type, asks)
    plains = value.plain if isinstance(value.plain, tuple) else (None,) * len(value.value)
    item = None if value.type is None else value.type.removeprefix("list_of_")
    items = [_converted(name, text, item, asks) if plain is None else plain for text, plain in zip(value.value, plains, strict=True)]
    unknown = next((each for each in items if isinstance(each, Unknown)), None)
    if unknown is not None:
        return unknown
    if not is_uniform(items, value.type):
        place = value.value[0].place
        reason = "the items of a list must all be of one type"
        shown = ", ".join(str(each) for each in items[:20])
        asks.fail(ParameterValueType(origin=asks.where(place), refused=True, name=name, value=f"[{shown}]", type=value.type, reason=reason))
    return items


def _converted(name: str, text: Text, wanted: str | None, asks: Performs) -> Any:
    performed = asks.perform(text)
    if isinstance(performed, Unknown):
        if wanted is None:
            _note_command(name, text, performed, asks, typed=True)
        return performed
    try:
        return convert(performed, wanted, asks.digits_are_boolean)
    except TypeFault as fault:
        _refuse(name, text.place, performed, wanted, fault, asks)
    except YamlBeyond as beyond:
        return Unknown(performed[:100], beyond.message)


def _note_command(name: str, text: Text, performed: Unknown, asks: Performs, *, typed: bool) -> None:
    """Record that what a command prints is read as YAML, where that is a robot description: it prints XML."""
    if any(isinstance(piece, Substitution) and piece.name == "command" for piece in text.pieces) and _DESCRIBES.search(performed.text):
        named = _ROBOT.search(performed.text)
        file = "" if named is None else named[1]
        asks.notice(CommandReadAsYaml(origin=asks.where(text.place), name=name, typed=typed, file=file))


def _by_yaml_rules(name: str | Unknown, value: TypedValue, asks: Performs) -> Any:
    """A value as ``<set_parameter>`` and ``<extra_arg>`` read it."""
    text = value.value if isinstance(value.value, Text) else value.value[0]
    return by_rules(name.text if isinstance(name, Unknown) else name, text, asks)


def by_rules(name: str, text: Text, asks: Performs) -> Any:
    """The value of a text as ``evaluate_parameter_dict`` reads it; a list becomes a tuple. Raises where launch stops."""
    performed = asks.perform(text)
    if isinstance(performed, Unknown):
        _note_command(name, text, performed, asks, typed=False)
        return performed
    try:
        return by_yaml_rules(performed)
    except TypeFault as fault:
        _refuse(name, text.place, performed, None, fault, asks)
    except YamlBeyond as beyond:
        return Unknown(performed[:100], beyond.message)


def _is_quoted(value: TypedValue) -> bool:
    """Whether quotes stand around a value, or its first item, as it is written: those of YAML, not those of an attribute."""
    texts = (value.value,) if isinstance(value.value, Text) else value.value[:1]
    for text in texts:
        source, (start, _) = text.place
        if text.place.text.strip().strip("[").lstrip().startswith(_QUOTES):
            return True
        before = source.text[max(0, start - 40) : start]
        if before.endswith(_QUOTES) and not before[:-1].rstrip().endswith("="):
            return True
    return False


def _boolean(said: str, text: Text, asks: Performs) -> bool:
    try:
        return bool(convert(said, "bool", asks.digits_are_boolean))
    except TypeFault as fault:
        _refuse("allow_substs", text.place, said, "bool", fault, asks)
    except YamlBeyond:
        return False


def _refuse(name: str, place: Place, value: str, wanted: str | None, fault: TypeFault, asks: Performs) -> NoReturn:
    asks.fail(ParameterValueType(origin=asks.where(place), refused=True, name=name, value=value, type=wanted, reason=fault.reason))
