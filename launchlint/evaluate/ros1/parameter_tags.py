"""``<param>`` and ``<rosparam>`` (roslaunch.xmlloader._param_tag and _rosparam_tag, roslaunch.loader.Loader)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator

from launchlint.evaluate.block import MoreParameters, PrivateParameter, RunStep, Value
from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.names import canonical, join
from launchlint.evaluate.problems import (
    GlobalParamInNode,
    InvalidParamName,
    ParamReplaced,
    ParamValueType,
    ParamYamlInvalid,
    Ros2Parameters,
    UnexpandedSubstitution,
    YamlDuplicateKey,
)
from launchlint.evaluate.ros1.file import FileEvaluation
from launchlint.evaluate.ros1.scope import Context, PrivateParameters, set_private
from launchlint.evaluate.ros1.scope_tags import check_quotes
from launchlint.evaluate.ros1.substitution import resolve
from launchlint.evaluate.ros1.typed_values import PARAMETER_TYPES, convert_value
from launchlint.late import late
from launchlint.model import Binary, Command, ParameterSetting, Unknown
from launchlint.problem import Problem
from launchlint.source import Origin, Place, Source, Span
from launchlint.syntax.parts import Malformed, Substitution
from launchlint.syntax.ros1.problems import conflicting_attributes, missing_attribute
from launchlint.syntax.ros1.substitutions import COMMANDS, opens, parse, parse_again
from launchlint.syntax.tree import Attribute, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Literal

    from launchlint.evaluate.ros1.rosparam import Loaded
    from launchlint.evaluate.session import Session

LONGEST_KEPT = 1 << 20
"""Characters of a YAML text whose parameters are kept for the next time."""
SOURCES = ("value", "textfile", "binfile", "command")
STEPS = ("load", "dump", "delete")
_ANCHOR = late(r"[ \t]*:[ \t]+&([^\s,\[\]{}]+)")
_ALIAS = late(r"\*([^\s,\[\]{}]+)")
ROS2_KEY = "ros__parameters"
"""Below it stand the params of a node in a parameter file of ROS 2."""


def param(file: FileEvaluation, element: Element, context: Context, namespace: str) -> None:
    """A ``<param>`` outside nodes: a global setting, or for ``~x`` one for each node that follows in the scope."""
    read = _read(file, element, context)
    if read is None:
        return
    name, value = read
    if name.startswith("~"):
        setting = _setting(file, canonical(name), value, element, "param")
        replaced = context.set_private(PrivateParameter(setting.name, setting))
        place = None if replaced is None else replaced.setting.origin.place
        file.open_setting(context, "param", setting.name, value, setting.origin, place)
    else:
        _notice_name(file, element, name)
        file.effect(_setting(file, canonical(join(namespace, name)), value, element, "param"))


def private_param(file: FileEvaluation, element: Element, values: Context, own: PrivateParameters) -> None:
    """A ``<param>`` inside a node: private to it, whatever its name looks like."""
    read = _read(file, element, values)
    if read is None:
        return
    name, value = read
    if name.startswith("/"):
        origin = file.at(element.attributes["name"].value_span)
        file.record(GlobalParamInNode(origin=origin, name=name, namespace=values.namespace))
    else:
        _notice_name(file, element, name)
    setting = _setting(file, canonical(name), value, element, "param")
    replaced = set_private(own, PrivateParameter(setting.name, setting))
    if replaced is not None:
        old = replaced.setting
        file.record(ParamReplaced(origin=setting.origin, related=((old.origin.place, "set here first"),), name=name,
                                  always=set(file.conditions) <= set(old.conditions), old=old.value, new=value))  # fmt: skip


def _notice_name(file: FileEvaluation, element: Element, name: str) -> None:
    """Record a parameter name that is no ROS name: roslaunch sets it, most readers cannot ask for it."""
    written = element.attributes["name"]
    legal = all(part.replace("_", "a").isalnum() and part.isascii() for part in name.strip("~/").split("/") if part)
    bare = name.lstrip("~/")
    if not legal or not bare or not (bare[0].isalpha() or bare[0] == "_"):
        file.record(InvalidParamName(origin=file.at(written.value_or_name_span), name=name))


def _setting(file: FileEvaluation, name: str, value: Any, element: Element, tag: str) -> ParameterSetting:
    return ParameterSetting(name, value, Origin(file.place(element.start_span)), tag, None, file.conditions)


def _read(file: FileEvaluation, element: Element, context: Context) -> tuple[str, Any] | None:
    """Name (as written, stripped) and value of a ``<param>``; None where roslaunch refuses it."""
    type_ = (element.get("type") or "auto").lower().strip()
    given, reads = file.traced(
        lambda: [(source, file.optional(element, source, context)) for source in SOURCES if source in element.attributes]
    )
    if len(given) != 1:
        file.record(conflicting_attributes(file.document, element, "param-sources", tuple(source for source, _ in given)))
    name_attribute = element.attributes.get("name")
    if name_attribute is None:
        file.required(element, "name", context)
        return None
    name = file.value(name_attribute, context, name_attribute.value.strip())
    if isinstance(name, Unknown) or len(given) != 1:
        file.effect(MoreParameters(context.namespace))
        return None
    source, written = given[0]
    assert written is not None
    return name, _value(file, element, source, written, type_, reads)


def _value(file: FileEvaluation, element: Element, source: str, written: Value, type_: str, reads: frozenset[str]) -> Any:
    """The value a ``<param>`` sets (roslaunch.loader.Loader.param_value)."""
    if isinstance(written, Unknown):
        return written
    attribute = element.attributes[source]
    if source == "command":
        return _command(file, element, written, type_)
    if source == "value":
        return _convert(file, attribute, written.strip(), type_, element)
    content = file.session.read(written)
    if content.data is None:
        _missing(file, element, source, written, content.reason, reads)
        return Unknown(written, "the file is not here")
    if source == "binfile":
        return Binary(content.digest, len(content.data))
    try:
        text = content.data.decode("utf-8").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError as error:
        _missing(file, element, source, written, f"it is not UTF-8 text (byte {error.start})", reads)
        return Unknown(written, "the file is not text")
    return _convert(file, attribute, text, type_, element)


def _command(file: FileEvaluation, element: Element, line: str, type_: str) -> Command:
    """What can be told of a command without running it: roslaunch splits it as a shell does, and converts what it prints."""
    if not line.strip():
        file.invalid(element, "command", line, "a command to run")
    else:
        check_quotes(file, element, "command", line)
    if type_ not in PARAMETER_TYPES:
        _convert(file, element.attributes["command"], "", type_, element)
    return Command(line)


def _missing(file: FileEvaluation, element: Element, attribute: str, name: str, reason: str, reads: frozenset[str]) -> None:
    """Record a file that cannot be read."""
    from launchlint.evaluate.missing_file import missing_file  # only a file that is not there pays for it

    written = element.attributes[attribute]
    file.record(missing_file(file.session, file.at(written.shown_span), attribute, name, reason, environment=file.from_environment(reads)))


def _convert(file: FileEvaluation, attribute: Attribute, text: str, type_: str, element: Element) -> Any:
    try:
        return convert_value(text, type_, angles=file.progress.angles)
    except ValueError as error:
        written = element.attributes.get("type")
        known = type_ in PARAMETER_TYPES
        at = attribute if known or written is None else written
        file.record(ParamValueType(origin=file.at(at.value_or_name_span), refused=True, value=text[:200], type=type_,
                                   known=known, reason=str(error)))  # fmt: skip
        return Unknown(text, "the value does not fit its type")
    except UnknownValue as unknown:
        return Unknown(text[:200], str(unknown))


def rosparam(file: FileEvaluation, element: Element, context: Context, namespace: str, *, in_node: bool = False) -> None:
    """A ``<rosparam>``: load YAML, or remember a dump or delete step (roslaunch.loader.Loader.load_rosparam)."""
    command, ns = file.optional(element, "command", context), file.optional(element, "ns", context)
    name, reads = file.traced(lambda: file.optional(element, "file", context))
    param_name = file.optional(element, "param", context)
    substitute = file.flag(element, "subst_value", context)
    if isinstance(command, Unknown) or isinstance(ns, Unknown) or isinstance(param_name, Unknown):
        file.effect(MoreParameters(namespace))
        return
    command = command or "load"
    below = join(ns or "", param_name or "")
    full = join(namespace, below) if below else namespace
    if command not in STEPS:
        file.invalid(element, "command", command, "load, dump or delete")
        return
    if command == "delete" and name is not None:
        file.record(conflicting_attributes(file.document, element, "delete-with-file", ("command", "file")))
        return
    if command != "load":
        if command == "dump" and name is None:
            file.record(missing_attribute(file.document, element, "file", refused=False))
        file.effect(RunStep(command, full, "" if name is None or isinstance(name, Unknown) else name))
        return
    text = None if isinstance(name, Unknown) else _yaml_text(file, element, name, reads)
    if text is None or isinstance(name, Unknown):
        file.effect(MoreParameters(full))
        return
    if name is None and not substitute and opens(text[0]):
        _notice_unsubstituted(file, element, text[0])
    written = None
    if substitute:
        resolved = resolve(file, parse(text[0]), _in_text(element, name), context)
        if isinstance(resolved, Unknown):
            file.effect(MoreParameters(full))
            return
        written = text[1]
        text = (resolved, None if resolved != text[0] else text[1])
    _load(file, element, text, below, full, in_node=in_node, written=written)


def _notice_unsubstituted(file: FileEvaluation, element: Element, text: str) -> None:
    for part in parse_again(text).parts:
        if not isinstance(part, (Substitution, Malformed)) or not part.text.startswith("$(") or not part.words:
            continue
        line = text[text.rfind("\n", 0, part.start) + 1 : part.start]
        if part.words[0].text in (*COMMANDS, "eval") and re.search(r"(?:^|\s)#", line) is None:  # else it stands in a comment of the YAML
            written = part.text.partition("\n")[0]
            span = _in_text(element, None)(part.start, part.start + len(written))
            file.record(UnexpandedSubstitution(origin=file.at(span), text=written, extra=False, rosparam=True))
            return


def _in_text(element: Element, name: str | None) -> Any:
    """A function that gives the span in the launch file for offsets into the YAML text."""

    def where(start: int, end: int) -> Span:
        if name is not None:
            return element.attributes["file"].value_span
        return Span(element.text_offset(start), max(element.text_offset(max(end - 1, start)) + 1, element.text_offset(start) + 1))

    return where


def _anchored(content: str, ends: Iterable[int]) -> Iterator[bool]:
    """Of each key, by where in ``content`` it ends, whether its value has an anchor that is used somewhere."""
    used: frozenset[str] | None = None
    for end in ends:
        found = _ANCHOR.match(content, end)
        if found is not None and used is None:
            used = frozenset(_ALIAS.findall(content))  # once, however many keys there are
        yield found is not None and used is not None and found[1] in used


def _line(written: Source | None, content: str, start: int, end: int) -> Place | None:
    """The place in the file ``written`` of what stands at ``start`` to ``end`` of ``content``, in which substitutions are replaced.

    That is the key itself where nothing before it in its line was replaced, else the line; None where replacing changed the lines.
    """
    if written is None or written.text.count("\n") != content.count("\n"):
        return None
    number = content.count("\n", 0, start)
    before = content[content.rfind("\n", 0, start) + 1 : start]
    begin = written.line_starts[number]
    line = written.line(number + 1)
    if line.startswith(before + content[start:end]):
        return Place(written, Span(begin + len(before), begin + len(before) + end - start))
    return Place(written, Span(begin + len(line) - len(line.lstrip()), begin + len(line.rstrip())))


def _yaml_text(file: FileEvaluation, element: Element, name: str | None, reads: frozenset[str]) -> tuple[str, Source | None] | None:
    """The YAML text, and the file it is from (None: the element itself)."""
    if name is None:
        return element.text, None
    attribute = element.attributes["file"]
    content = file.session.read(name)
    if content.data is None:
        _missing(file, element, "file", name, content.reason, reads)
        return None
    try:
        text = content.data.decode("utf-8").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError as error:
        reason = f"it is not UTF-8 text (byte {error.start})"
        origin = file.at(attribute.value_or_name_span)
        file.record(ParamYamlInvalid(origin=origin, refused=True, file=name, reason=reason, in_file=True, hint=""))
        return None
    source = file.session.sources.get(name)
    if source is None or source.text != text:
        source = file.session.sources[name] = Source(file.session.shown(name), text, name)
    return source.text, source


def _loaded(session: Session, content: str) -> Loaded:
    """The parameters of a YAML text. Raises YamlError and YamlUnknown; the same files are loaded over and over in one run."""
    from launchlint.evaluate.ros1.rosparam import YamlError, YamlUnknown, load

    known = session.loaded.get(content)
    if known is None:
        try:
            known = load(content)
        except (YamlError, YamlUnknown) as error:
            known = error
        if len(content) <= LONGEST_KEPT:
            session.loaded[content] = known
    if isinstance(known, Exception):
        raise known.with_traceback(None)
    result: Loaded = known
    return result


def _load(
    file: FileEvaluation, element: Element, text: tuple[str, Source | None], below: str, full: str, *, in_node: bool, written: Source | None
) -> None:
    from launchlint.evaluate.ros1.rosparam import YamlError, YamlUnknown

    file.progress.angles = True
    content, source = text
    is_as_written = source is None and "file" not in element.attributes and bool(element.texts) and content == element.text

    def place(start: int, end: int) -> Place:
        if source is not None:
            return Place(source, Span(start, end))
        if not is_as_written:
            return file.place(element.start_span)
        return file.place(_in_text(element, None)(start, end))

    def invalid(at: Place, reason: str, hint: Literal["", "colon", "scalar"], related: tuple[tuple[Place, str], ...] = ()) -> None:
        named = "" if source is None else source.path
        file.record(ParamYamlInvalid(origin=Origin(at), refused=True, related=related, reason=reason, hint=hint,
                                     in_file=source is not None, file=named))  # fmt: skip

    try:
        loaded = _loaded(file.session, content)
    except YamlUnknown as unknown:
        value = Unknown("", str(unknown))
        file.effect(ParameterSetting(canonical(full), value, Origin(file.place(element.start_span)), "rosparam", None, file.conditions))
        return
    except YamlError as error:
        end = content.find("\n", error.offset) if error.kind == "colon" else -1
        at = place(error.offset, min(error.offset + 1, len(content)) if end < 0 else end)
        named = element.attributes.get("file")
        related: tuple[tuple[Place, str], ...] = ()
        if source is not None and named is not None:
            related = ((file.place(named.value_span), "loaded here"),)
        invalid(at, str(error), "colon" if error.kind == "colon" else "", related)
        return
    is_dictionary = isinstance(loaded.data, dict) or loaded.data is None
    if (not below or full == "/") and not is_dictionary:
        at = place(*loaded.scalar_colon[0]) if loaded.scalar_colon else file.place(element.name_span)
        reason = "a value that is no dictionary needs the param attribute to say which parameter it is for"
        invalid(at, reason, "colon" if loaded.scalar_colon else "scalar")
        return
    anchored = _anchored(content, (duplicate.first[1] for duplicate in loaded.duplicates))
    for duplicate, is_anchored in zip(loaded.duplicates, anchored, strict=True):
        first, second = (_line(written, content, *span) or place(*span) for span in (duplicate.first, duplicate.second))
        related = ((first, "the first one"),)
        key = "/".join(map(str, duplicate.path))
        file.record(YamlDuplicateKey(origin=Origin(second), related=related, key=key, same=duplicate.same_value, anchored=is_anchored))
    _notice_ros2(file, element, loaded, content, full, place)
    same = (file.document, element.index, "" if source is None else source.path, content, full, file.conditions)
    known = file.session.settings.get(same)
    if known is not None:  # the same in another configuration
        file.block.effects.extend(known)
        return
    before = len(file.block.effects)
    for path, value, key_start, key_end, *_ in loaded.entries:
        target = full
        for step in path:
            target = join(target, step)
        if target == "/":
            reason = "an empty key in the global namespace names no parameter"
            invalid(place(key_start, key_end), reason, "")
            continue
        if isinstance(value, UnknownValue):
            value = Unknown("", str(value))
        where = Origin(place(key_start, key_end)) if path else Origin(file.place(element.start_span))
        file.effect(ParameterSetting(canonical(target), value, where, "rosparam", None, file.conditions))
    made = file.block.effects[before:]
    if len(content) <= LONGEST_KEPT and not any(isinstance(each, Problem) for each in made):
        file.session.settings[same] = made


def _notice_ros2(
    file: FileEvaluation, element: Element, loaded: Loaded, content: str, full: str, place: Callable[[int, int], Place]
) -> None:
    """Record that the YAML is made for ROS 2, once, at the first of its keys that say so."""
    if ROS2_KEY not in content:
        return
    below = [entry for entry in loaded.entries if ROS2_KEY in entry.path[:-1]]
    if not below:
        return
    first = below[0]
    start = content.rfind(ROS2_KEY, 0, first.key_start)
    name = full
    for key in first.path:
        name = join(name, key)
    written = element.attributes.get("file")
    related = () if written is None else ((file.place(written.value_span), "loaded here"),)
    at = place(start, start + len(ROS2_KEY)) if start >= 0 else place(first.key_start, first.key_end)
    file.record(Ros2Parameters(origin=Origin(at), related=related, name=canonical(name), count=len(below)))
