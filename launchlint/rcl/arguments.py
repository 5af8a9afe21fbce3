"""A node's command line: what is for ROS in it, and what that means.

Source: ``rcl/src/rcl/arguments.c`` (``rcl_parse_arguments``). Outside of ``--ros-args … --`` a word that reads like a remap rule is one,
too; whatever else stands there is the program's own. A word that rcl does not know among the ROS arguments is left over: rclcpp and rclpy
end with an error for it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.rcl import lexer, parameter_rule, remap
from launchlint.rcl.lexer import Lexemes
from launchlint.rcl.refused import Refused
from launchlint.rcl.remap import Rule
from launchlint.rcl.table import Table
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

ParameterFiles: TypeAlias = "Callable[[str, Table], Refused | None]"
"""Reads the file of that name into the table, or says why rcl does not."""

ROS_ARGUMENTS, ROS_ARGUMENTS_END = "--ros-args", "--"
PARAMETER = ("-p", "--param")
REMAP = ("-r", "--remap")
PARAMETERS_FILE = "--params-file"
LOG_LEVEL = "--log-level"
ENCLAVE = ("-e", "--enclave")
LOG_CONFIGURATION = "--log-config-file"
LOG_FILE_NAME = "--log-file-name"
SWITCHES = frozenset(f"--{way}-{what}-logs" for way in ("enable", "disable") for what in ("stdout", "rosout", "external-lib"))
SEVERITIES = ("unset", "debug", "info", "warn", "error", "fatal")


class CommandLine(NamedTuple):
    """What rcl makes of a command line. ``own`` are the program's words, ``unknown`` the ROS arguments that rcl does not know."""

    rules: tuple[Rule, ...]
    parameters: Table
    files: tuple[str, ...]
    enclave: str | None
    log_levels: tuple[str, ...]
    own: tuple[str, ...]
    unknown: tuple[str, ...]


def parse(words: Sequence[str], files: ParameterFiles) -> CommandLine | Refused:
    """What ``words`` (without the program itself) mean, or why a node that is given them ends when it starts."""
    rules: list[Rule] = []
    names: list[str] = []
    levels: list[str] = []
    own: list[str] = []
    unknown: list[str] = []
    table = Table()
    enclave: str | None = None
    for_ros = False
    at = 0
    while at < len(words):
        word = words[at]
        at += 1
        if not for_ros:
            if word == ROS_ARGUMENTS:
                for_ros = True
            elif isinstance(rule := remap.parse(word), Rule):
                rules.append(rule)
            else:
                own.append(word)
            continue
        if word == ROS_ARGUMENTS:
            continue
        if word == ROS_ARGUMENTS_END:
            for_ros = False
            continue
        if word not in _WITH_VALUE:
            if word not in SWITCHES:
                unknown.append(word)
            continue
        if at == len(words):
            return Refused(f"{word} is the last word, and what it is about must follow", Span(0, len(word)), word=at - 1)
        value = words[at]
        refused: Refused | None = None
        if word in PARAMETER:
            refused = parameter_rule.add(value, table)
        elif word in REMAP:
            read = remap.parse(value)
            if isinstance(read, Refused):
                refused = read
            else:
                rules.append(read)
        elif word == PARAMETERS_FILE:
            refused = files(value, table)
            names.append(value)
        elif word == LOG_LEVEL:
            refused = _log_level(value)
            levels.append(value)
        elif word in ENCLAVE:
            enclave = value
        if refused is not None:
            return refused._replace(word=at)
        at += 1
    return CommandLine(tuple(rules), table, tuple(names), enclave, tuple(levels), tuple(own), tuple(unknown))


_WITH_VALUE = frozenset((*PARAMETER, *REMAP, PARAMETERS_FILE, LOG_LEVEL, *ENCLAVE, LOG_CONFIGURATION, LOG_FILE_NAME))


def _log_level(text: str) -> Refused | None:
    """``level`` or ``logger:=level``."""
    lexemes = Lexemes(text)
    while lexemes.kind not in (lexer.SEPARATOR, lexer.END):
        lexemes.take()
    level, start = text, 0
    if lexemes.kind == lexer.SEPARATOR:
        if lexemes.at == 0:
            return Refused("the name of the logger is empty", Span(0, len(text)))
        lexemes.take()
        start = lexemes.at
        level = lexemes.take() if lexemes.kind == lexer.TOKEN else ""
        if lexemes.kind != lexer.END:
            level = ""
    if level.lower() in SEVERITIES:
        return None
    return Refused(f"the log levels are {', '.join(SEVERITIES)}", Span(start, len(text)))
