"""Programs that are no nodes by what the launch file says of them (``<executable>``, ``ExecuteProcess``), and yet may talk to nodes.

An agent of micro-ROS or of a flight controller brings the topics of another machine, a simulator those of its plugins.
"""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from launchlint.model import Executable
from launchlint.words import split_words

_QUIET = frozenset(
    (
        "cat",
        "chmod",
        "cp",
        "echo",
        "kill",
        "killall",
        "ls",
        "mkdir",
        "mv",
        "pkill",
        "printf",
        "rm",
        "sleep",
        "test",
        "touch",
        "true",
        "xacro",
    )
)
"""Commands of a shell that talk to no node."""
_ASKING = frozenset(
    ("action", "component", "control", "doctor", "interface", "lifecycle", "multicast", "node", "param", "pkg", "service", "wtf")
)
"""Verbs of ``ros2`` that ask nodes for something, once."""


def may_talk(program: Executable) -> bool:
    """Whether a process may publish, hear or serve anything: of most that are started so nothing is known."""
    words = _words(program.command)
    if not words:
        return True
    called = posixpath.basename(words[0])
    return called not in _QUIET and (called != "ros2" or _ASKING.isdisjoint(words[1:2]))


def spelled(program: Executable) -> str:
    """How people call it: the program that is started, with the verb where it is ``ros2``."""
    words = _words(program.command)
    called = posixpath.basename(words[0]) if words else "a program"
    return " ".join((called, *words[1:2])) if called == "ros2" else called


def _words(command: Sequence[str]) -> list[str]:
    """The words of a command; one that is left to a shell stands in one text."""
    text = " ".join(command)
    try:
        return split_words(text)
    except ValueError:
        return text.split()
