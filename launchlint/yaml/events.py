"""YAML text to events with places, as libyaml gives them, for readers that build no tree (rcl reads its parameter files so).

The text may hold several documents, and aliases stay events. Where there is no libyaml, PyYAML's own parser stands in: it differs in a few
signs only (see :mod:`launchlint.yaml.tree`).
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.named_tuple import NamedTuple
from launchlint.yaml.refusals import YamlError, explain, too_deep
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

SCALAR, ALIAS, SEQUENCE_START, SEQUENCE_END, MAPPING_START, MAPPING_END = range(6)


class Event(NamedTuple):
    """One event: ``value`` is a scalar's text or an alias's name, ``quoted`` says that the scalar stands in quotes."""

    kind: int
    start: int
    end: int
    value: str = ""
    quoted: bool = False
    tag: str | None = None


def read(text: str, reader: str, longest: int = 8_000_000, deepest: int = 1_000) -> Iterator[Event]:
    """The events of ``text``, without those of stream and documents; ``reader`` names in messages who cannot load it.

    Raises YamlError when it comes to what is no YAML, and YamlBeyond.
    """
    import yaml

    if len(text) > longest:
        raise YamlBeyond(f"the YAML text is longer than {longest} characters")
    depth = 0
    parser = (yaml.CSafeLoader if getattr(yaml, "__with_libyaml__", False) else yaml.SafeLoader)(text.encode("utf-8", "replace").decode())
    kinds = {
        yaml.ScalarEvent: SCALAR,
        yaml.AliasEvent: ALIAS,
        yaml.SequenceStartEvent: SEQUENCE_START,
        yaml.SequenceEndEvent: SEQUENCE_END,
        yaml.MappingStartEvent: MAPPING_START,
        yaml.MappingEndEvent: MAPPING_END,
    }
    try:
        while True:
            event: Any = parser.get_event()
            kind = kinds.get(type(event))
            if kind is None:
                if isinstance(event, yaml.StreamEndEvent):
                    return
                continue
            start, end = event.start_mark.index, event.end_mark.index
            if kind == SCALAR:
                if event.style in ("|", ">"):
                    end = start + len(text[start:end].rstrip())
                yield Event(SCALAR, start, end, event.value, event.style in ("'", '"'), event.tag)
                continue
            if kind in (SEQUENCE_START, MAPPING_START):
                depth += 1
                if depth > deepest:
                    raise YamlBeyond(f"the YAML text is nested more than {deepest} deep", start)
            elif kind in (SEQUENCE_END, MAPPING_END):
                depth -= 1
            yield Event(kind, start, end, event.anchor if kind == ALIAS else "")
    except yaml.YAMLError as error:
        if (offset := too_deep(error)) is not None:
            raise YamlBeyond(f"the YAML text is nested more than {deepest} deep", offset) from None
        raise explain(error, text, reader) from None
    finally:
        parser.dispose()


class Recorded:
    """The events of one text, which are read once and can be gone through again, up to the error that ended them."""

    __slots__ = ("_error", "_events")

    def __init__(self, text: str, reader: str) -> None:
        self._events: list[Event] = []
        self._error: YamlError | YamlBeyond | None = None
        try:
            for event in read(text, reader):
                self._events.append(event)
        except (YamlError, YamlBeyond) as error:
            self._error = error

    def __iter__(self) -> Iterator[Event]:
        yield from self._events
        if self._error is not None:
            raise self._error
