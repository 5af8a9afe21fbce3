"""What becomes of a node when it is started: rcl reads its command line, and takes its params from it, or the node dies.

The words are put together as ``launch_ros.actions.Node`` does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, partial
from typing import Any

from launchlint.evaluate.ros2.parameters import PARAMETERS
from launchlint.evaluate.ros2.rcl_files import Content, add_content, add_file, content_of
from launchlint.model import Unknown, UnknownText
from launchlint.named_tuple import NamedTuple
from launchlint.rcl import arguments
from launchlint.rcl.names import Names
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import ANY, Table, winning
from launchlint.source import Origin, Place, Source
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.parameters import Passed, Performs
    from launchlint.rcl.arguments import CommandLine
    from launchlint.rcl.parameter_value import Type

_CONTENT = "/launch_params_"
_NAMELESS = "/launchlint_nameless"
"""Stands for the name of a node that only its program knows."""


class Value(NamedTuple):
    """A param's value by rcl's types; ``data`` may be Unknown. ``origin``: where it is written, None on the command line.

    ``shared``: it is given to whatever node matches a pattern, not to this one.
    """

    type: Type
    data: Any
    origin: Origin | None = None
    shared: bool = False


class Started(NamedTuple):
    """What becomes of a node.

    ``parameters``: what it starts with, None where that cannot be known. ``refused``: why it dies at its start, if it does. ``full_name``:
    the name that it has then, if launch gives it one. ``contents``: what launch wrote for it, with what rcl read. ``called``: what it
    starts with under the name that it gives itself, None where launch gives it one, or that cannot be known.
    """

    parameters: Mapping[str, Value] | None
    refused: Refused | None
    full_name: str | None = None
    command_line: CommandLine | None = None
    contents: tuple[tuple[Source, Passed], ...] = ()
    called: Callable[[str], Mapping[str, Value]] | None = None


def started(
    own_words: Sequence[str],
    ros_words: Sequence[str] | None,
    name: str | None,
    namespace: str | None,
    passed: Sequence[Passed],
    remaps: Iterable[tuple[str, str]],
    asks: Performs,
) -> Started:
    """What rcl makes of the command line of a node.

    Args:
        own_words: the words of ``args``.
        ros_words: those of ``ros_args``, None where there are none.
        name: the name that launch gives it.
        namespace: the namespace that launch gives it.
        passed: its params, as :func:`launchlint.evaluate.ros2.parameters.node_parameters` makes them.
        remaps: its remaps, in order.
        asks: whose files these are.
    """
    given = [*own_words, *([] if ros_words is None else [arguments.ROS_ARGUMENTS, *ros_words])]
    words = [word for word in given if not isinstance(word, UnknownText)]
    if len(words) < len(given) and arguments.ROS_ARGUMENTS in words:
        return Started(None, None, None if name is None else Names(name, namespace or "/").full_name)
    words.append(arguments.ROS_ARGUMENTS)
    if name is not None:
        words += ["-r", f"__node:={name}"]
    if namespace is not None:
        words += ["-r", f"__ns:={namespace}"]
    known = True
    contents: dict[str, tuple[Content, Passed]] = {}
    for place, each in enumerate(passed):
        if each.rule is not None:
            words += [] if isinstance(each.rule, UnknownText) else ["-p", each.rule]
            known = known and not each.unknown
        elif isinstance(each.content, Mapping) and not isinstance(each.content, Unknown):
            file = f"{_CONTENT}{place}"
            contents[file] = (_written(each, contents.values(), asks), each)
            words += [arguments.PARAMETERS_FILE, file]
        elif each.unknown:
            known = False
        elif each.file is not None:
            words += [arguments.PARAMETERS_FILE, each.file]
        elif each.text is not None:
            file = f"{_CONTENT}{place}"
            contents[file] = (_written(each, contents.values(), asks), each)
            words += [arguments.PARAMETERS_FILE, file]
    for source, target in remaps:
        words += ["-r", f"{source}:={target}"]
    beyond: list[YamlBeyond] = []

    def read(file: str, table: Table) -> Refused | None:
        table.tags = asks.tags_count
        try:
            content = contents.get(file)
            return add_file(file, table, asks) if content is None else add_content(content[0], table)
        except YamlBeyond as too_much:
            beyond.append(too_much)
            return None

    line = arguments.parse(words, read)
    if isinstance(line, Refused):
        return Started(None, line, None if name is None else Names(name, namespace or "/").full_name)
    full_name = None if name is None else Names(name, namespace or "/", line.rules).full_name
    sources = tuple((content.source, each) for content, each in contents.values())
    if beyond or not known:
        return Started(None, None, full_name, line, sources)
    called = partial(_found, line.parameters, contents=sources, passed=passed)
    found = called(full_name or _NAMELESS) if full_name is not None or _is_for_all(line.parameters) else None
    return Started(found, None, full_name, line, sources, called if full_name is None else None)


def _is_for_all(table: Table) -> bool:
    """Whether all params are for any node, so that the name of this one does not matter."""
    return all(key.name == ANY for key in table.keys.values() if key.parameters)


def _found(table: Table, full_name: str, *, contents: Sequence[tuple[Source, Passed]], passed: Iterable[Passed]) -> dict[str, Value]:
    """The params of a node; what launch wrote without knowing it is Unknown."""
    made = {id(source): each.origin for source, each in contents}
    shared = {id(each) for key in table.keys.values() if "*" in key.name for each in key.parameters}
    files = {each.file: each.origin.step for each in passed if each.file is not None}
    unknown = {
        (id(source), name): value
        for source, passed in contents
        if passed.unknown
        for values in passed.content.values()
        for name, value in values[PARAMETERS].items()
        if isinstance(value, Unknown)
    }
    found: dict[str, Value] = {}
    for name, parameter in winning(table, full_name).items():
        value = parameter.value
        source, _, span, _ = parameter.written
        origin = made.get(id(source))
        if origin is None and source is not None:
            origin = Origin(Place(source, span), files.get(source.file))
        found[name] = Value(
            value.type, unknown.get((id(source), name), value.data), origin, id(source) not in made and id(parameter) in shared
        )
    return found


def written(passed: Passed, asks: Performs) -> Content:
    """What stands in the file that launch writes."""
    text = passed.text if passed.text is not None else dumped(passed.content)
    return content_of(passed.of or "", text, asks)


def _written(passed: Passed, before: Iterable[tuple[Content, Passed]], asks: Performs) -> Content:
    """The same; its source is none of those ``before`` it on the command line, so that it can be told whose a param is."""
    content = written(passed, asks)
    if any(content is each for each, _ in before):
        return content._replace(source=Source(content.source.path, content.source.text), alone=None)
    return content


def dumped(content: Any) -> str:
    """A mapping as launch_ros writes it for rcl: PyYAML's style, texts without quotes where PyYAML reads them as texts."""
    import yaml

    return str(yaml.dump(_plain(content), Dumper=_dumper(), default_flow_style=False))


@cache
def _dumper() -> Any:
    """PyYAML's, by libyaml where that is there; what is said twice is written twice."""
    import yaml

    class Dumper(getattr(yaml, "CSafeDumper", yaml.SafeDumper)):  # type: ignore[misc]
        def ignore_aliases(self, data: Any) -> bool:
            return True

    return Dumper


def _plain(content: Any) -> Any:
    if isinstance(content, Mapping):
        return {str(key) if isinstance(key, str) else key: _plain(value) for key, value in content.items()}
    return content.text if isinstance(content, Unknown) else content
