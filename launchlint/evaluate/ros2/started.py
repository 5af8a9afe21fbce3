"""What becomes of a node when it is started: rcl reads its command line, and takes its params from it, or the node dies.

The words are put together as ``launch_ros.actions.Node`` does.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from launchlint.evaluate.ros2.parameters import source_of
from launchlint.model import Unknown
from launchlint.rcl import arguments, parameter_files
from launchlint.rcl.names import Names
from launchlint.rcl.parameter_value import Value
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import Table, overrides
from launchlint.source import Source, Span
from launchlint.yaml import events
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.parameters import Passed, Performs

_CONTENT = "/launch_params_"


class Started(NamedTuple):
    """``parameters`` is what the node starts with, None where that cannot be known; ``refused`` why it dies at its start, if it does."""

    parameters: Mapping[str, Value] | None
    refused: Refused | None
    command_line: arguments.CommandLine | None = None


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
    words = list(own_words)
    if ros_words is not None:
        words += [arguments.ROS_ARGUMENTS, *ros_words]
    words.append(arguments.ROS_ARGUMENTS)
    if name is not None:
        words += ["-r", f"__node:={name}"]
    if namespace is not None:
        words += ["-r", f"__ns:={namespace}"]
    known = True
    for place, each in enumerate(passed):
        if each.unknown:
            known = False
        elif each.rule is not None:
            words += ["-p", each.rule]
        else:
            words += [arguments.PARAMETERS_FILE, each.file or f"{_CONTENT}{place}"]
    for source, target in remaps:
        words += ["-r", f"{source}:={target}"]
    beyond: list[YamlBeyond] = []

    def read(file: str, table: Table) -> Refused | None:
        try:
            if file.startswith(_CONTENT):
                return parameter_files.add(_written(passed[int(file.removeprefix(_CONTENT))]), table)
            return _add_file(file, table, asks)
        except YamlBeyond as too_much:
            beyond.append(too_much)
            return None

    line = arguments.parse(words, read)
    if isinstance(line, Refused):
        return Started(None, line)
    if name is None or beyond or not known:
        return Started(None, None, line)
    full_name = Names(name, namespace or "/", line.rules).full_name
    return Started(overrides(line.parameters, full_name), None, line)


def _add_file(file: str, table: Table, asks: Performs) -> Refused | None:
    read = asks.session.read(file)
    if read.data is None:
        return Refused(f"the file {file} cannot be read: {read.reason}", Span(0, 0))
    source = source_of(file, read.data, asks)
    kept = asks.session.loaded.get(f"events {file}")
    if kept is None:
        kept = asks.session.loaded[f"events {file}"] = events.Recorded(source.text, "rcl")
    return parameter_files.add_events(kept, source, table)


def _written(passed: Passed) -> Source:
    """What stands in the file that launch writes."""
    text = passed.text if passed.text is not None else dumped(passed.content)
    return Source(passed.of or "", text)


def dumped(content: Any) -> str:
    """A mapping as launch_ros writes it for rcl: PyYAML's style, texts without quotes where PyYAML reads them as texts."""
    import yaml

    class Dumper(getattr(yaml, "CSafeDumper", yaml.SafeDumper)):  # type: ignore[misc]
        def ignore_aliases(self, data: Any) -> bool:
            return True

    return str(yaml.dump(_plain(content), Dumper=Dumper, default_flow_style=False))


def _plain(content: Any) -> Any:
    if isinstance(content, Mapping):
        return {key: _plain(value) for key, value in content.items()}
    return content.text if isinstance(content, Unknown) else content
