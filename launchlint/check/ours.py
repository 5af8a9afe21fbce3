"""Which findings are about files that people asked for, and which about files that are merely installed on this machine.

Nobody can mend an installed launch file in a pull request. What is wrong there is told where one's own file includes it, if it stops
roslaunch; else not at all.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence

from launchlint.check.options import Options
from launchlint.finding import Finding, Related, Severity


class Ours:
    """The directories that are one's own: the directory paths are relative to, the workspaces, and what was asked for."""

    __slots__ = ("_known", "_roots")

    def __init__(self, options: Options, asked: Sequence[str] = ()) -> None:
        roots = (*options.workspaces, *(os.path.abspath(path) for path in asked))
        self._roots = tuple(root.rstrip(os.sep) for root in roots)
        self._known: dict[str, bool] = {}

    def holds(self, path: str) -> bool:
        """Whether ``path``, as findings show it, is in one of them; relative paths are."""
        known = self._known.get(path)
        if known is None:
            known = not os.path.isabs(path) or any(path == root or path.startswith(root + os.sep) for root in self._roots)
            self._known[path] = known
        return known

    def brought_home(self, findings: Iterable[Finding]) -> Iterator[Finding]:
        """The findings in one's own files, and the errors in other files at the include that leads there."""
        for finding in findings:
            if self.holds(finding.location.path):
                yield finding
            elif finding.severity is Severity.ERROR:
                inside = [step for step in finding.chain if self.holds(step.path)]
                if inside:
                    chain = finding.chain[: finding.chain.index(inside[-1])]
                    related = (Related(finding.location, finding.label or "here"), *finding.related)
                    topic = f"{finding.location.path}:{finding.location.start}:{finding.topic}"
                    yield finding._replace(
                        location=inside[-1], label="in what this includes", related=related, chain=chain, topic=topic, fix=None
                    )
