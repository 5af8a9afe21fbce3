"""A value as the exported file will say it, beside what it comes to here."""

from __future__ import annotations

from launchlint.evaluate.block import Value
from launchlint.model import Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros1.substitutions import only_arg, parse


class Written(NamedTuple):
    """``text`` is what the exported file says, ``value`` what that comes to in the configuration that is exported.

    ``sources`` are what can still change it when the file is started: names of kept args, and environment variables as ``$NAME``.
    ``anonymous``: a name made up by ``$(anon)`` is in it.
    """

    text: str
    value: Value
    sources: frozenset[str] = frozenset()
    anonymous: bool = False

    @property
    def known(self) -> str:
        """The value, which is known wherever something is exported; the text as written on a side that is not taken here."""
        return self.value.text if isinstance(self.value, Unknown) else self.value

    @property
    def only_arg(self) -> str | None:
        """The name of the arg that the text consists of, if it is ``$(arg name)`` and nothing else."""
        return only_arg(parse(self.text)) or None


class Condition(NamedTuple):
    """An ``if`` or ``unless`` that the exported file keeps; ``taken`` says whether its element is evaluated here."""

    attribute: str
    written: Written
    taken: bool


class Setting(NamedTuple):
    """A ``remap``, ``env`` or ``~param`` of a scope, to be repeated in each node it acts on.

    ``key`` is what a later one of the same spelling replaces; empty where that is decided only when the file is started.
    """

    tag: str
    attributes: tuple[tuple[str, str], ...]
    key: str
    condition: Condition | None = None


class Fixed(Exception):
    """``sources`` cannot stay open: the export starts again with their values of this configuration. ``reason`` is in plain words."""

    def __init__(self, sources: frozenset[str], reason: str) -> None:
        super().__init__(reason)
        self.sources = sources
        self.reason = reason


class CannotExport(Exception):
    """There is no faithful export; ``reason`` in plain words, ``place`` (path, line) where that is known."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason
