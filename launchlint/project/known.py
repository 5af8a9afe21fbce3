"""Leaving out what a baseline knows."""

from __future__ import annotations

from launchlint.check.file import INTERNAL_ERROR

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.baseline import Baseline
    from launchlint.check.merge import Outcome


def without_known(outcome: Outcome, known: Baseline) -> Outcome:
    """``outcome`` without the findings that a baseline knows; a crash is never known."""
    from launchlint.baseline import filter as unknown_ones
    from launchlint.order import ordered

    crashes = [finding for finding in outcome.findings if finding.rule == INTERNAL_ERROR]
    others = [finding for finding in outcome.findings if finding.rule != INTERNAL_ERROR]
    return outcome._replace(findings=tuple(ordered([*unknown_ones(others, known), *crashes])))
