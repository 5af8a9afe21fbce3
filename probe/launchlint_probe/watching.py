"""Watching one node: until it is ready, then woken, then given what it waits for, then sent a first message on what it hears.

Each stage ends when nothing new has come for a while and the node is idle. What is there at the end of a stage is kept, so that the library
can say what a name appeared upon.
"""

import os
import time
from typing import Any, Dict, List, Optional, Set, Tuple

from launchlint_probe import processes
from launchlint_probe.answering import Answers
from launchlint_probe.bounds import Usage
from launchlint_probe.diagnose import MOST_PRINTED
from launchlint_probe.interface import is_infrastructure
from launchlint_probe.recorder import Recorder
from launchlint_probe.tcpros import Subscription

STEP = 0.05
"""Seconds between two looks at a node."""
MOST_WOKEN = 500
"""Publishers that are connected to."""
PATIENCE = 5
"""A node that has contacted the master but registered nothing of its own is given this many times ``quiet``: it may be slow to begin."""
HALF = 0.5
"""Where there is more than one stage, the silence at the end of each is this part of ``quiet``."""
RESTLESS = 4
"""What never rests is taken to be ready when nothing new has come for this many times as long."""
ANSWERING = 2.0
"""Seconds that publishers are given to answer after all else is quiet."""

Name = Tuple[str, str]
"""A kind of name and the name itself, as the recorder has it."""


class Seen:
    """What watching a node has shown.

    ``start`` are its names when it was ready, ``woken`` those when its publishers had been listened to, ``served`` those when it had been
    given what it waits for; each None where it did not come so far. ``ended``: it ended by itself. ``sent``: how much it had printed when
    it was sent messages, in bytes; None where it was not. ``excess``: code and words where it took more than it may. ``reached``: all names
    that were expected came, so that nobody waited any longer.
    """

    def __init__(self) -> None:
        self.start: Optional[Set[Name]] = None
        self.woken: Optional[Set[Name]] = None
        self.ended = False
        self.served: Optional[Set[Name]] = None
        self.sent: Optional[int] = None
        self.excess: Optional[Tuple[str, str]] = None
        self.reached = False


class Watch:
    """One node that is watched. Times in seconds, as in the plan.

    Args:
        recorder: its master.
        answers: the stand-in for what it waits for; None where it shall be given nothing.
        process: what was started.
        mark: of its processes.
        output: the file that it prints into.
        quiet: see :class:`launchlint_probe.session.Plan`.
        limit: likewise.
        usage: measures what it takes.
        expected: names at which it need not be watched any longer. To have them soon it is woken and given everything at once.
    """

    def __init__(
        self,
        recorder: Recorder,
        answers: Optional[Answers],
        process: Any,
        mark: str,
        output: str,
        quiet: float,
        limit: float,
        usage: Usage,
        expected: Optional[Set[Name]] = None,
    ) -> None:
        self.subscriptions: Dict[Tuple[str, str], Subscription] = {}
        self.seen = Seen()
        self._recorder = recorder
        self._answers = answers
        self._process = process
        self._mark = mark
        self._output = output
        self._quiet = quiet
        self._end = time.monotonic() + limit
        self._usage = usage
        self._expected = expected
        self._idle_since = time.monotonic()
        self._last_busy = 0.0
        self._wants = False
        self._gone = 0

    def run(self) -> Seen:
        """Watch it until it is ready in every stage, or has ended, or must be stopped."""
        facts = self._recorder.facts
        seen = self.seen
        if not self._until_quiet():
            return seen
        seen.start = names(self._recorder)
        self._finish_stage()
        seen.woken = names(self._recorder)
        answers = self._answers
        if answers is None or seen.ended or seen.reached:
            return seen
        while self._goes_on() and (answers.needs_serving() or answers.finish_goals(self.subscriptions)):
            answers.serve()
            facts.touch()
            if not self._until_quiet():
                return seen
            self._finish_stage()
        if not self._goes_on():
            return seen
        seen.served = names(self._recorder)
        while self._goes_on() and (answers.needs_sending() or answers.needs_serving() or answers.finish_goals(self.subscriptions)):
            if seen.sent is None:
                seen.sent = os.path.getsize(self._output)
            answers.serve()
            answers.send()
            facts.touch()
            if not self._until_quiet():
                return seen
            self._finish_stage()
        return seen

    def close(self) -> None:
        """Hang up all that was connected."""
        for each in self.subscriptions.values():
            each.close()

    def _goes_on(self) -> bool:
        return not self.seen.ended and not self.seen.reached and self.seen.excess is None and time.monotonic() < self._end

    def _finish_stage(self) -> None:
        """Subscribe to what is published now, until nothing more follows from that."""
        while self._goes_on() and len(self.subscriptions) < MOST_WOKEN:
            new = self._unheard()
            if not new:
                return
            for api, name in new[:MOST_WOKEN]:
                self.subscriptions[(api, name)] = Subscription(api, name)
            self._recorder.facts.touch()
            if not self._until_quiet():
                return

    def _hurry(self) -> None:
        """All stages at once."""
        for api, name in self._unheard()[: MOST_WOKEN - len(self.subscriptions)]:
            self.subscriptions[(api, name)] = Subscription(api, name)
        if self._answers is not None:
            self._answers.serve()
            self._answers.finish_goals(self.subscriptions)
            self._answers.send()

    def _unheard(self) -> List[Tuple[str, str]]:
        """The publishers that have not been listened to. To /rosout nobody needs to listen."""
        return [
            (api, name)
            for (_, name), (_, api) in list(self._recorder.facts.publishers.copy().items())
            if (api, name) not in self.subscriptions and not name.startswith("/rosout")
        ]

    def _until_quiet(self) -> bool:
        """Wait until nothing new has come for a while. Returns whether the node is still there, and may be."""
        facts = self._recorder.facts
        while True:
            now = time.monotonic()
            if now >= self._end or facts.overflow or os.path.getsize(self._output) > MOST_PRINTED:
                return False
            alive = processes.belonging(self._mark, self._process.pid)
            self._gone = self._gone + 1 if not alive and self._process.poll() is not None else 0
            if self._gone > 1:  # once is not enough: a daemon forks between two looks
                self.seen.ended = True
                return False
            self.seen.excess = self._usage.excess(alive)
            if self.seen.excess is not None:
                return False
            if self._expected is not None and self._expected <= names(self._recorder):
                self.seen.reached = True
                return False
            if self._expected is not None:
                self._hurry()
            self._note_work(alive, now)
            if self._is_quiet(now):
                return True
            time.sleep(STEP)

    def _note_work(self, alive: List[int], now: float) -> None:
        busy = processes.busy_time(alive)
        wanted, self._wants = self._wants, processes.want_to_run(alive)
        if busy > self._last_busy + 1 or (wanted and self._wants):  # on a busy machine it may want to and not be let
            self._last_busy, self._idle_since = busy, now

    def _is_quiet(self, now: float) -> bool:
        facts = self._recorder.facts
        registered = any(not is_infrastructure(name) for _, name in names(self._recorder))
        more = self.seen.start is not None or bool(self._unheard()) or bool(facts.lookups)
        needed = self._quiet * (HALF if more else 1.0) * (1 if registered or facts.lookups else PATIENCE)
        silence = now - facts.changed
        if not (facts.nodes or facts.lookups) or silence < needed:
            return False
        if now - self._idle_since < min(self._quiet, 0.5) and silence < RESTLESS * needed:
            return False
        settled = all(each.is_settled for each in list(self.subscriptions.values()))
        return settled or silence >= needed + ANSWERING


def names(recorder: Recorder) -> Set[Name]:
    """All topics and services that a node has registered so far, with their kind."""
    facts = recorder.facts
    tables = (("publishers", facts.publishers), ("subscribers", facts.subscribers), ("services", facts.services))
    return {(category, name) for category, table in tables for _, name in list(table)}
