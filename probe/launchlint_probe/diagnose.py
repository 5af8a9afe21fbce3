"""Why a node did not run, or not wholly: from what it printed, how it ended and what it waited for."""

import re
from typing import Dict, List, Optional, Tuple

from launchlint_probe.counterpart import Known

Problem = Dict[str, str]

DETAIL = 300
"""Characters of output that a problem quotes."""
LONGEST_LINE = 400
"""Characters of a line of output that are looked at."""
MOST_NAMES = 500
"""Topics and services; a node that has more, and is still at it when time is up, will never be done."""
MOST_PRINTED = 16 * 1024 * 1024
"""Bytes of output; what prints more is stopped."""


class Outcome:
    """What is known when a node has been stopped.

    Args:
        known: what it did.
        output: what it printed last.
        said: the same when it was told to stop: what it printed upon that says nothing of what it waits for.
        before: the same before it was sent messages: that it complains of those says nothing.
        code: its exit status; None where it did not end by itself.
        timed_out: it was stopped because its time was up.
        busy: it was computing then.
        devices: those that it had open.
        printed: bytes of output.
        sent: it was sent messages.
        excess: code and words where it took more than it may: memory, processes, room on the disk.
    """

    def __init__(
        self,
        known: Known,
        output: str,
        said: str,
        before: str,
        code: Optional[int],
        timed_out: bool,
        busy: bool,
        devices: List[str],
        printed: int,
        sent: bool,
        excess: Optional[Tuple[str, str]],
    ) -> None:
        self.known = known
        self.output = output
        self.said = said
        self.before = before
        self.code = code
        self.timed_out = timed_out
        self.busy = busy
        self.devices = devices
        self.printed = printed
        self.sent = sent
        self.excess = excess


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
    ("waits", r"(?im)^.*?(\bwaiting (?:for|until|on)\b[^\n]*|\b(?:will )?(?:retry(?:ing)?|try(?:ing)? again)\b[^\n]*)"),
    ("error-logged", r"(?m)^\[ ?(?:FATAL|ERROR)\] ?(?:\[[^\]\n]*\] ?)*:? ?([^\n]+)"),
)
LAST_LINES = 3
"""A node waits where it says so in its last lines; what it said earlier may have come."""
TELLING = {"exception", "error-logged", "device-missing", "waits", "module-missing", "file-missing", "network", "param-required"}
"""Signs after which a node that goes on running may lack names."""
_COLOUR = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")
_COMPILED = tuple((code, re.compile(pattern)) for code, pattern in _SIGNS)


def diagnose(outcome: Outcome) -> Tuple[str, List[Problem]]:
    """``ok``, ``failed`` or ``not-a-node``, and the problems: each with a code and what was printed.

    A node that registered names of its own is ok, however it went on: what is known is known. Its problems say why there may be more.
    One that was stopped before anything was seen of it is never said to be no node: it may just be slow to begin.
    """
    known = outcome.known
    if known.overflow or (outcome.timed_out and known.count > MOST_NAMES):
        return "failed", [_problem("too-many-names", "it made up names without end")]
    problems: List[Problem] = []
    if outcome.printed > MOST_PRINTED:
        problems.append(_problem("too-much-output", "it printed without end"))
    if outcome.excess is not None:
        problems.append(_problem(*outcome.excess))
        if outcome.code is None:
            return ("ok" if known.has_names else "failed"), problems
    signs = _signs(outcome.output, outcome.said)
    if outcome.code is None:
        if known.registered:
            return "ok", problems + _doubts(outcome, _signs(outcome.before, outcome.said))
        return "failed", problems + _not_registered(outcome, signs)
    if outcome.sent:
        problems.append(_problem("ended", _ended(outcome.code, True)))
        return "ok", problems
    problems.extend(signs[:1] + [sign for sign in signs[1:2] if signs[0]["detail"] not in sign["detail"]])
    if outcome.code or not signs:
        problems.append(_problem("ended", _ended(outcome.code, False)))
    if known.has_names:
        return "ok", problems
    if known.misses_nothing and not known.contacted and not signs and outcome.code == 0:
        return "not-a-node", problems
    return ("ok" if known.registered and outcome.code == 0 and not signs else "failed"), problems


def _doubts(outcome: Outcome, signs: List[Problem]) -> List[Problem]:
    """Why a node that ran until it was stopped may have more names than it showed."""
    problems: List[Problem] = []
    if outcome.timed_out and not outcome.printed > MOST_PRINTED:
        problems.append(_problem("never-quiet", "there was still something new when it was stopped: there may be more"))
    problems += [_problem("waits-for-service", name) for name in outcome.known.unanswered]
    if outcome.code is None:
        problems += [_problem("waits-for-message", name) for name in outcome.known.untold]
    problems += [_problem("waits-for-param", name) for name in outcome.known.missed]
    return problems + [sign for sign in signs if sign["code"] in TELLING][:1]


def _not_registered(outcome: Outcome, signs: List[Problem]) -> List[Problem]:
    """Why a node that was stopped had registered nothing."""
    problems = [_problem("waits-for-service", name) for name in outcome.known.unanswered]
    problems += signs[:1] or [_problem("waits-for-device", device) for device in outcome.devices]
    if outcome.busy and not problems and not outcome.printed > MOST_PRINTED:
        problems.append(_problem("busy", "it was still computing when it was stopped; a larger `limit` may help"))
    if outcome.timed_out:
        problems.append(
            _problem("timed-out", "it was stopped before it registered anything")
            if outcome.known.contacted
            else _problem("silent", outcome.known.silence)
        )
    return problems


def _ended(code: int, sent: bool) -> str:
    how = "it was ended by signal {}".format(-code) if code < 0 else "it ended by itself with status {}".format(code)
    return how + (" when it was sent empty messages" if sent else "")


def _signs(output: str, said: str) -> List[Problem]:
    """What the output says, the most telling first."""
    found = []
    shown = _shown(output)
    last = "\n".join(_shown(said).splitlines()[-LAST_LINES:])
    for code, pattern in _COMPILED:
        matches = pattern.findall(last if code == "waits" else shown)
        if matches:
            match = matches[-1]
            text = match if isinstance(match, str) else next((each for each in match if each), "")
            found.append(_problem(code, text))
    return found


def _shown(output: str) -> str:
    """The last of some output without colours; patterns take their time with long lines, so they are cut."""
    return "\n".join(line[:LONGEST_LINE] for line in _COLOUR.sub("", output[-20000:]).splitlines())


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
