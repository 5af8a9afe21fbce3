"""From what a library says of frames to those of one node: which it publishes, asks for and writes into its messages."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.graph.names import Namer, absolute
from launchlint.graph.situation import Start
from launchlint.library.condition import holds
from launchlint.library.program import Program
from launchlint.library.template import Slot, Template, Undetermined, fill, parse
from launchlint.named_tuple import NamedTuple


class Frame(NamedTuple):
    """A coordinate frame of one node.

    Args:
        role: ``child`` of a transform that it publishes, ``used`` (asked for), or ``label`` (written into its messages).
        name: as the node has it, a ``/`` before it included; empty where it cannot be known.
        parent: of a child, the parent of that transform; empty where it is not known.
        parameter: full name of the param that says the name; empty where none does.
        through: ``tf`` or ``tf2`` where the name goes there just as it is.
        urdf: full name of the param whose URDF says the names; then ``name`` is empty.
        certain: whether it is so whenever the node runs.
        upon: of a child, the topic (full name, before remapping) after whose messages alone the transform is published; else empty.
    """

    role: str
    name: str
    parent: str = ""
    parameter: str = ""
    through: str = ""
    urdf: str = ""
    certain: bool = True
    upon: str = ""


def frames(program: Program, start: Start, namer: Namer, *, certain: bool) -> Iterator[Frame]:
    """The frames of ``program`` when it is started so."""
    variants = program.variant(start)
    for variant in variants:
        for declared in variant.frames:
            known = holds(declared.condition, start) if declared.condition is not None else True
            if known is False:
                continue
            parts = parse(declared.name)
            name = fill(parts, start)
            if name is None:
                continue
            parent = fill(parse(declared.parent), start) if declared.parent else None
            yield Frame(
                declared.role,
                "" if isinstance(name, Undetermined) else name,
                parent if isinstance(parent, str) else "",
                _parameter(parts, start, namer),
                declared.through,
                namer.resolve(declared.urdf).name if declared.urdf else "",
                certain and known is True and len(variants) == 1,
                absolute(declared.upon, namer.namespace, namer.node) if declared.upon else "",
            )


def _parameter(parts: Template, start: Start, namer: Namer) -> str:
    """The param that says the name, where nothing else does."""
    while len(parts) == 1 and isinstance(parts[0], Slot) and parts[0].kind == "param":
        if start.param(parts[0].key) is not None:
            return namer.resolve(parts[0].key).name
        parts = parts[0].default or ()
    return ""
