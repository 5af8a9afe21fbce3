"""A word of a launch file that means something: which arg, package, file, name on the graph."""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    Kind = Literal["arg", "package", "executable", "file", "node", "topic", "param", "machine", "variable", "namespace"]
    Role = Literal["declares", "reads", "passes"]


class Mention(NamedTuple):
    """A word at ``span``, of a ``kind``, which ``declares``, ``reads`` or ``passes`` (to an included file) what has this ``name``.

    ``item`` is where the element (in YAML the key, in Python the call) begins in which it stands; of what is passed, the include. ``whole``
    is all that has the value, with its substitutions: a file is named by all of it. ``package`` is that of an executable, where it is
    written out.
    """

    kind: Kind
    name: str
    span: Span
    role: Role
    item: int
    whole: Span
    package: str = ""


def at(mentions: tuple[Mention, ...], offset: int) -> Mention | None:
    """The narrowest word at ``offset``."""
    found = [each for each in mentions if each.span.start <= offset <= each.span.end]
    return min(found, key=lambda each: each.span.end - each.span.start, default=None)
