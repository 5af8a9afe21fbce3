"""The bytes of a launch file in normal form, proved to say the same."""

from __future__ import annotations

from launchlint.fix.format.line_ends import prevailing_line_end, with_line_feeds
from launchlint.fix.format.printer import TooLarge, printed
from launchlint.fix.format.same import says_the_same
from launchlint.fix.format.style import Style
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.syntax.parse import parse


class Formatted(NamedTuple):
    """``data``: the file in normal form, or as it was where it must be left alone.

    ``problem``: what keeps the file from being read as a launch file, ``refusal``: what else does, in one sentence without a full stop.
    """

    data: bytes
    problem: Problem | None = None
    refusal: str = ""


def formatted(data: bytes, path: str, style: Style) -> Formatted:
    """Bring the content of a launch file into normal form.

    Encoding, byte order mark and the prevailing kind of line end stay. ``path`` is the name that people see. A file that roslaunch could
    not read, and one that the result would not say the same as, is left alone.
    """
    if is_yaml(path):
        return _yaml(data, path, style)
    document = parse(data, path)
    if document.problems:
        return Formatted(data, problem=document.problems[0])
    text = document.source.text
    try:
        lossless = document.bom + text.encode(document.encoding) == data
    except UnicodeEncodeError:
        lossless = False
    if not lossless:
        return Formatted(data, refusal=f"its encoding {document.encoding} cannot be written back as it was read")
    try:
        result = document.bom + normal_form(text, style).encode(document.encoding)
        same = result == data or says_the_same(data, result)
    except TooLarge:
        return Formatted(data, refusal="its normal form would be far larger than the file")
    except ValueError:
        same = False
    if not same:
        return Formatted(data, refusal="its normal form would not say the same")
    return Formatted(result)


def normal_form(text: str, style: Style, *, yaml: bool = False) -> str:
    """A well-formed document in normal form, with the kind of line end that prevails in it; ``yaml``: it is YAML, and no XML.

    Raises:
        TooLarge: it would be far larger than the text.
        ValueError: the text is not well-formed.
    """
    if not yaml:
        return printed(with_line_feeds(text), style).replace("\n", prevailing_line_end(text))
    from launchlint.fix.format.yaml_file import yaml_normal_form

    return yaml_normal_form(with_line_feeds(text), style).replace("\n", prevailing_line_end(text))


def is_yaml(path: str) -> bool:
    """Whether a launch file of this name is written in YAML."""
    return path.endswith((".yaml", ".yml"))


def _yaml(data: bytes, path: str, style: Style) -> Formatted:
    """The same for a launch file of ROS 2 in YAML."""
    from launchlint.syntax.ros2.reading import read

    reading = read(data, path)
    unread = next(
        (each for each in reading.problems if each.kind in ("malformed-yaml", "malformed-xml2", "unreadable-file", "wrong-root")), None
    )
    if unread is not None:
        return Formatted(data, problem=unread)
    if reading.document is not None:
        return Formatted(data, refusal="it holds XML, and has the name of a file in YAML")
    text = reading.source.text
    mark = data[: len(data) - len(text.encode())]
    return Formatted(mark + normal_form(text, style, yaml=True).encode())
