"""The namespace that a node gets: its own one, below the pushed one."""

from __future__ import annotations

from launchlint.evaluate.ros2.context import Value
from launchlint.evaluate.ros2.leaving import note_namespace
from launchlint.evaluate.ros2.names import absolute, prefixed
from launchlint.evaluate.ros2.processes import text_of
from launchlint.evaluate.ros2.walk import Walk
from launchlint.model import Unknown, shown_text
from launchlint.source import Place
from launchlint.syntax.ros2.description import Text


def namespace_of(walk: Walk, written: Text | None, place: Place) -> Value | None:
    """The namespace that something at ``place`` gets: below the pushed one, with a slash in front; None where there is none."""
    own, base = walk.optional(written), walk.context.namespace
    note_namespace(walk, own, place)
    if isinstance(own, str) and own.startswith("/"):
        base = None
    if isinstance(own, Unknown) or isinstance(base, Unknown):
        unknown = own if isinstance(own, Unknown) else base
        text = "/".join(text_of(part).strip("/") for part in (base, own) if part is not None)
        patterns = [(part if isinstance(part, str) else part.pattern).strip("/") for part in (base, own) if part is not None]
        return Unknown("/" + text, unknown.reason if isinstance(unknown, Unknown) else "", "/" + "/".join(patterns))
    return absolute(prefixed(base, own))


def namespace_with_slash(namespace: Value | None) -> str:
    """As the model has it: with a slash at its end, ``/`` where launch gives none."""
    if isinstance(namespace, Unknown):
        return shown_text(Unknown(namespace.text.rstrip("/") + "/", namespace.reason))
    return "/" if namespace is None else namespace.rstrip("/") + "/"
