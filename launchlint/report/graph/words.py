"""How nodes, names and configurations are put into words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from launchlint.graph.doubts import MayBe
from launchlint.graph.topology import Connection, RemapStep, Topology
from launchlint.report.escape import visible

WIDTH = 110
"""Columns after which a list of names goes on in the next line."""
DOES = {
    "publisher": "publishes",
    "subscriber": "subscribes",
    "server": "serves",
    "client": "calls",
    "action server": "serves action",
    "action client": "calls action",
}
OTHERS = {
    "publisher": "subscribes",
    "subscriber": "publishes",
    "server": "calls",
    "client": "serves",
    "action server": "calls action",
    "action client": "serves action",
}
"""What is done at the other end of a name."""
MOST_DOUBTED = 3
"""Those who may be at an empty end that are named."""


def listed(names: Iterable[str], total: int | None = None) -> str:
    """``/a, /b and 3 more``: names made visible, and how many of ``total`` are not among them."""
    shown = [visible(name) for name in names]
    more = 0 if total is None else total - len(shown)
    return ", ".join(shown) + (f" and {more} more" if more > 0 else "")


def wrapped(start: str, words: Sequence[str]) -> Iterator[str]:
    """``words`` after ``start``, with commas, in as many lines as it takes; a word is never broken."""
    line = start + words[0]
    indented = " " * (len(start) - len(start.lstrip()) + 4)
    for word in words[1:]:
        if len(line) + len(word) + 2 > WIDTH:
            yield f"{line},"
            line = indented + word
        else:
            line += f", {word}"
    yield line


def missed(connection: Connection, topology: Topology) -> str:
    """What is said of a name that has nobody at its other end: ``nobody publishes``, with the doubt that is there."""
    who = doubted(topology.doubts.get((connection.kind, connection.name, not connection.offers), ()))
    others = OTHERS[connection.role]
    return f"nobody here {others}, but {visible(who)} may" if who else f"nobody {others}"


def doubted(who: Iterable[MayBe]) -> str:
    """``/driver (not known) and /rviz (not all of it is known)``: those who may be at an empty end; empty where there are none."""
    all_ = [f"{each.node or 'another one'} ({_why(each)})" for each in who]
    shown = list(dict.fromkeys(all_))
    if len(shown) > MOST_DOUBTED:
        shown = [*shown[:MOST_DOUBTED], "others"]
    return " and ".join(filter(None, (", ".join(shown[:-1]), *shown[-1:])))


def _why(who: MayBe) -> str:
    """Why it is not known, in few words: of what is no node the reason without its details."""
    return who.reason.partition(":")[0] if not who.node else "not known" if who.unknown else "not all of it is known"


def loading(topology: Topology) -> str:
    """Why roslaunch does not load all that is shown; empty where it does, or where that was not asked."""
    verdict = topology.verdict
    if verdict is None or not verdict.notice:
        return ""
    if verdict.word == "loads":
        return verdict.notice
    refused = verdict.word == "refused" or verdict.rule
    return f"{verdict.notice}; shown is {'what it would start otherwise' if refused else 'what is known of it'}"


def place(text: str) -> str:
    """``path:line`` of ``path:line:column``."""
    return visible(text.rpartition(":")[0])


def remapped(steps: Sequence[RemapStep], near: str = "") -> str:
    """``remapped from /a (robot.launch:3)``; empty where nothing was renamed. In the file of the place ``near`` only the line is told."""
    real = [step for step in steps if step.source != step.target]
    said = [f"{visible(step.source)} ({_written(step.place, near)})" for step in real]
    return f"remapped from {', then from '.join(said)}" if said else ""


def _written(at: str, near: str) -> str:
    file, _, line = at.rpartition(":")[0].rpartition(":")
    return f"line {line}" if file and near.startswith(f"{file}:") else place(at) if at else "args"


def when(only: Sequence[str], configurations: Sequence[str]) -> str:
    """In which configurations something is, the shorter way: ``only with sim:=true``, ``not with sim:=true``; empty for all."""
    if not only:
        return ""
    others = [each for each in configurations if each not in only]
    if others and len(others) < len(only):
        return f"not {_with(others)}"
    return f"only {_with(only)}"


def _with(configurations: Sequence[str]) -> str:
    """``by default or with sim:=true``; of configurations that only give more args than another one the latter is enough."""
    given = {each: frozenset(each.split(" ")) for each in configurations if each}
    words = [visible(each) for each, args in given.items() if not any(other < args for other in given.values())]
    shown = f"with {' or '.join(words)}" if words else ""
    return " or ".join(filter(None, ("by default" if "" in configurations else "", shown)))


def does(connection: Connection) -> str:
    """``publishes /scan``."""
    return f"{DOES[connection.role]} {visible(connection.name)}"
