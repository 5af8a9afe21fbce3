"""How nodes, names and configurations are put into words."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from launchlint.graph.topology import Connection, RemapStep
from launchlint.report.escape import visible

DOES = {
    "publisher": "publishes",
    "subscriber": "subscribes",
    "server": "serves",
    "client": "calls",
    "action server": "serves action",
    "action client": "calls action",
}
MISSED = {
    "publisher": "nobody subscribes",
    "subscriber": "nobody publishes",
    "server": "nobody calls",
    "client": "nobody serves",
    "action server": "nobody calls action",
    "action client": "nobody serves action",
}
"""What is said of a name that has nobody at its other end."""


def number(count: int, one: str, many: str = "") -> str:
    """``1 node``, ``2 nodes``."""
    return f"{count} {one if count == 1 else many or one + 's'}"


def listed(names: Iterable[str], total: int | None = None) -> str:
    """``/a, /b and 3 more``: names made visible, and how many of ``total`` are not among them."""
    shown = [visible(name) for name in names]
    more = 0 if total is None else total - len(shown)
    return ", ".join(shown) + (f" and {more} more" if more > 0 else "")


def place(text: str) -> str:
    """``path:line`` of ``path:line:column``."""
    return visible(text.rpartition(":")[0])


def remapped(steps: Sequence[RemapStep]) -> str:
    """``remapped from /a (robot.launch:3)``; empty where nothing was renamed."""
    real = [step for step in steps if step.source != step.target]
    said = [f"{visible(step.source)} ({place(step.place) if step.place else 'args'})" for step in real]
    return f"remapped from {', then from '.join(said)}" if said else ""


def when(only: Sequence[str], configurations: Sequence[str]) -> str:
    """In which configurations something is, the shorter way: ``only with sim:=true``, ``not with sim:=true``; empty for all."""
    if not only:
        return ""
    others = [each for each in configurations if each not in only]
    if others and len(others) < len(only):
        return f"not {_with(others)}"
    return f"only {_with(only)}"


def _with(configurations: Sequence[str]) -> str:
    words = [visible(each) for each in configurations if each]
    given = f"with {' or '.join(words)}" if words else ""
    return " or ".join(filter(None, ("by default" if "" in configurations else "", given)))


def does(connection: Connection) -> str:
    """``publishes /scan``."""
    return f"{DOES[connection.role]} {visible(connection.name)}"
