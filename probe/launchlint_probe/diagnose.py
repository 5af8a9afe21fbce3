"""Why a node did not run, or not wholly: from what it printed, how it ended and what it waited for."""

import re
from typing import Dict, List, Optional, Tuple

from launchlint_probe.interface import spelled
from launchlint_probe.recorder import Facts

Problem = Dict[str, str]

DETAIL = 300
"""Characters of output that a problem quotes."""
LONGEST_LINE = 400
"""Characters of a line of output that are looked at."""
MOST_NAMES = 500
"""Topics and services; a node that has more, and is still at it when time is up, will never be done."""
MOST_PRINTED = 64 * 1024 * 1024
"""Bytes of output; what prints more is stopped."""


class Outcome:
    """What is known when a node has been stopped. ``code`` is its exit status, None where it did not end by itself."""

    def __init__(
        self, facts: Facts, output: str, code: Optional[int], timed_out: bool, busy: bool, devices: List[str], printed: int
    ) -> None:
        self.facts = facts
        self.output = output
        self.code = code
        self.timed_out = timed_out
        self.busy = busy
        self.devices = devices
        self.printed = printed


_CANNOT = r"(?:cannot|can't|could not|couldn't|failed to|unable to|error)"
_NO_PARAM = (
    r"(?im)^.*?((?:param(?:eter)?s?\b[^\n]*(?:not set|required|missing|must be|not found|undefined|not specified|is unset))"
    r"|(?:(?:no|missing|required) param(?:eter)?\b[^\n]*)|KeyError: '[~/][^']*'"
    r"|CANNOT (?:get|find|read|load|retrieve) (?:the )?param[^\n]*)"
)
_NO_DISPLAY = (
    r"(?im)^.*?(CANNOT (?:open|connect to) (?:X )?display[^\n]*|no display name[^\n]*"
    r"|could not load the Qt platform plugin[^\n]*|GLX[^\n]*|TclError[^\n]*)"
)
_NO_DEVICE = (
    r"(?im)^.*?(CANNOT ?(?:open|connect|access)[^\n]*(?:/dev/[^\s'\"]+|port|device|camera|usb)[^\n]*|wait[^\n]*/dev/[^\n]*"
    r"|no such file or directory:? ?'?/dev/[^\n]*|no (?:devices?|cameras?) [^\n]*found[^\n]*)"
)
_NO_NETWORK = (
    r"(?im)^.*?((?:connection refused|network is unreachable|name or service not known|temporary failure in name resolution)[^\n]*)"
)
_SIGNS = (
    ("module-missing", r"(?:ModuleNotFoundError|ImportError): (.+)"),
    ("library-missing", r"error while loading shared libraries: ([^:\n]+)"),
    ("arguments-required", r"(?im)^(?:.*?\b)?(usage:.*|.*the following arguments are required.*|.*too few arguments.*)$"),
    ("param-required", _NO_PARAM.replace("CANNOT", _CANNOT)),
    ("display-required", _NO_DISPLAY.replace("CANNOT", _CANNOT)),
    ("device-missing", _NO_DEVICE.replace("CANNOT", _CANNOT)),
    ("file-missing", r"(?im)^.*?((?:no such file or directory|file not found|could not (?:open|load) file)[^\n]*)"),
    ("network", _NO_NETWORK),
    ("exception", r"(?m)^(?:terminate called[^\n]*\n\s*what\(\):\s*([^\n]+)|(\w*(?:Error|Exception): [^\n]+))"),
    ("error-logged", r"(?m)^\[ ?(?:FATAL|ERROR)\] ?(?:\[[^\]\n]*\] ?)*:? ?([^\n]+)"),
)
_COLOUR = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")
_COMPILED = tuple((code, re.compile(pattern)) for code, pattern in _SIGNS)


def diagnose(outcome: Outcome) -> Tuple[str, List[Problem]]:
    """``ok``, ``failed`` or ``not-a-node``, and the problems: each with a code and what was printed.

    A node that registered something and did not end is ok, whatever it printed. One that ended with status 0 and a usage text has failed.
    """
    facts = outcome.facts
    contacted = bool(facts.nodes or facts.reads or facts.lookups or facts.searches)
    registered = bool(facts.nodes)
    problems: List[Problem] = []
    waits = sorted(name for name in facts.lookups if not any(name == served for _, served in facts.services))
    names = len(facts.publishers) + len(facts.subscribers) + len(facts.services)
    if facts.overflow or (outcome.timed_out and names > MOST_NAMES):
        return "failed", [_problem("too-many-names", "it made up names without end")]
    if outcome.printed > MOST_PRINTED:
        problems.append(_problem("too-much-output", "it printed without end"))
    if outcome.code is None:
        waiting = [_problem("waits-for-service", spelled(name)) for name in waits]
        if registered:
            if outcome.timed_out and not outcome.printed > MOST_PRINTED:
                problems.append(_problem("never-quiet", "there was still something new when it was stopped: there may be more"))
            return "ok", problems + waiting
        problems.extend(waiting)
        signs = _signs(outcome.output)[:1]
        if not signs:
            signs = [_problem("waits-for-device", device) for device in outcome.devices]
        problems.extend(signs)
        if outcome.busy and not problems:
            problems.append(_problem("busy", "it was still computing when it was stopped; a larger `limit` may help"))
        known = bool(problems)
        if outcome.timed_out:
            problems.append(
                _problem("timed-out", "it was stopped before it registered anything")
                if contacted
                else _problem("silent", "it never contacted the master")
            )
        return ("failed" if contacted or known else "not-a-node"), problems
    signs = _signs(outcome.output)
    problems.extend(signs[:1] + [sign for sign in signs[1:2] if signs[0]["detail"] not in sign["detail"]])
    if outcome.code:
        problems.append(_problem("ended", _ended(outcome.code)))
    elif not signs:
        problems.append(_problem("ended", "it ended by itself with status 0"))
    if registered and outcome.code == 0 and not signs:
        return "ok", problems
    if not contacted and not signs and outcome.code == 0:
        return "not-a-node", problems
    return "failed", problems


def _ended(code: int) -> str:
    return "it was ended by signal {}".format(-code) if code < 0 else "it ended by itself with status {}".format(code)


def _signs(output: str) -> List[Problem]:
    """What the output says, the most telling first."""
    found = []
    plain = _COLOUR.sub("", output[-20000:])
    shown = "\n".join(line[:LONGEST_LINE] for line in plain.splitlines())  # patterns take their time with long lines
    for code, pattern in _COMPILED:
        matches = pattern.findall(shown)
        if matches:
            last = matches[-1]
            text = last if isinstance(last, str) else next((each for each in last if each), "")
            found.append(_problem(code, text))
    return found


_PASSING = (
    (re.compile(r"\b0x[0-9a-f]{4,}"), "0x…"),
    (re.compile(r"\b1[5-9]\d{8}(?:\.\d+)?\b"), "…"),
    (re.compile(r"launchlint_(?:ns|node)\b/?"), ""),
    (re.compile(r"(?<=127\.0\.0\.1:)\d+|(?<=localhost:)\d+|(?<=pid )\d+|(?<=\[)\d{9,}[.\d]*(?=\])"), "…"),
)
"""What is different each time: addresses, times, ports."""


def _problem(code: str, detail: str) -> Problem:
    for pattern, stand_in in _PASSING:
        detail = pattern.sub(stand_in, detail)
    shown = "".join(each if each.isprintable() else " " for each in detail.strip())
    return {"code": code, "detail": shown[:DETAIL]}
