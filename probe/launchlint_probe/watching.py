"""Watching one node: until it is ready, then woken, then given what it waits for, then sent a first message on what it hears.

Each stage ends when nothing new has come for a while and the node is idle. What is there at the end of a stage is kept, so that the library
can say what a name appeared upon.
"""

import os
import time
from typing import Any, List, Optional, Set

from launchlint_probe import processes
from launchlint_probe.bounds import Usage
from launchlint_probe.counterpart import Counterpart, Name, Seen
from launchlint_probe.diagnose import MOST_PRINTED

STEP = 0.05
"""Seconds between two looks at a node."""
PATIENCE = 5
"""A node that has been in touch but registered nothing of its own is given this many times ``quiet``: it may be slow to begin."""
HALF = 0.5
"""Where there is more than one stage, the silence at the end of each is this part of ``quiet``."""
RESTLESS = 4
"""What never rests is taken to be ready when nothing new has come for this many times as long."""
SETTLED = 0.4
"""Seconds without news after which a node in a hurry has begun, so that it is known whether it has states."""
ANSWERING = 2.0
"""Seconds that publishers are given to answer after all else is quiet."""


class Watch:
    """One node that is watched. Times in seconds, as in the plan.

    Args:
        counterpart: what it talks to.
        process: what was started.
        mark: of its processes.
        output: the file that it prints into.
        quiet: see :class:`launchlint_probe.plan.Plan`.
        limit: likewise.
        usage: measures what it takes.
        expected: names at which it need not be watched any longer. To have them soon it is woken and given everything at once.
    """

    def __init__(
        self,
        counterpart: Counterpart,
        process: Any,
        mark: str,
        output: str,
        quiet: float,
        limit: float,
        usage: Usage,
        expected: Optional[Set[Name]] = None,
    ) -> None:
        self.seen = Seen()
        self._counterpart = counterpart
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
        counterpart, seen = self._counterpart, self.seen
        if not self._until_quiet():
            return seen
        while self._goes_on() and counterpart.advance():
            counterpart.touch()
            if not self._until_quiet():
                return seen
        seen.start = counterpart.names()
        self._finish_stage()
        seen.woken = counterpart.names()
        while self._goes_on() and counterpart.serve():
            if not self._settle():
                return seen
        if not self._goes_on():
            return seen
        seen.served = counterpart.names()
        while self._goes_on():
            printed = os.path.getsize(self._output)
            served = counterpart.serve()
            if not counterpart.send() and not served:
                return seen
            if seen.sent is None:
                seen.sent = printed
            if not self._settle():
                return seen
        return seen

    def _settle(self) -> bool:
        """After it was given something: wait, then listen to what is new. Returns whether it is still there, and may be."""
        self._counterpart.touch()
        if not self._until_quiet():
            return False
        self._finish_stage()
        return True

    def _goes_on(self) -> bool:
        return not self.seen.ended and not self.seen.reached and self.seen.excess is None and time.monotonic() < self._end

    def _finish_stage(self) -> None:
        """Subscribe to what is published now, until nothing more follows from that."""
        while self._goes_on() and self._counterpart.listen():
            self._counterpart.touch()
            if not self._until_quiet():
                return

    def _hurry(self) -> None:
        """All stages at once."""
        if time.monotonic() - self._counterpart.news() >= SETTLED:
            self._counterpart.advance()
        self._counterpart.listen()
        self._counterpart.serve()
        self._counterpart.send()

    def _until_quiet(self) -> bool:
        """Wait until nothing new has come for a while. Returns whether the node is still there, and may be."""
        counterpart = self._counterpart
        while True:
            now = time.monotonic()
            if now >= self._end or counterpart.overflows() or os.path.getsize(self._output) > MOST_PRINTED:
                return False
            alive = processes.belonging(self._mark, self._process.pid)
            self._gone = self._gone + 1 if not alive and self._process.poll() is not None else 0
            if self._gone > 1:  # once is not enough: a daemon forks between two looks
                self.seen.ended = True
                return False
            self.seen.excess = self._usage.excess(alive) or counterpart.refusal()
            if self.seen.excess is not None:
                return False
            if self._expected is not None:
                if self._expected <= counterpart.names() and counterpart.is_there():
                    self.seen.reached = True
                    return False
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
        counterpart = self._counterpart
        asks = counterpart.asks()
        more = self.seen.start is not None or counterpart.has_unheard() or asks
        needed = self._quiet * (HALF if more else 1.0) * (1 if asks or counterpart.has_registered() else PATIENCE)
        silence = now - counterpart.news()
        if not counterpart.is_there() or silence < needed:
            return False
        if now - self._idle_since < min(self._quiet, 0.5) and silence < RESTLESS * needed:
            return False
        return counterpart.is_settled() or silence >= needed + ANSWERING
