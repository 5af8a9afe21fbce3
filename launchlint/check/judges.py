"""The judges: each looks at the findings of a whole run, and lowers the level of those that matter less than a single file shows, or gives
those one cause that single files show several of.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from launchlint.check.conventions import judged_by_conventions
from launchlint.check.copied import judged_by_origin
from launchlint.check.copied_block import judged_by_block
from launchlint.check.fragments import judged_by_inclusion
from launchlint.check.given_elsewhere import judged_by_givers
from launchlint.check.given_together import judged_by_callers
from launchlint.check.known import Known
from launchlint.check.left_behind import judged_by_build
from launchlint.check.lost_files import judged_by_loss
from launchlint.check.of_whole import judged_by_whole
from launchlint.check.overridden import judged_by_includers
from launchlint.check.retired import judged_by_place
from launchlint.check.same_name import judged_by_name
from launchlint.check.stray_remap import judged_by_remap
from launchlint.check.twins import judged_by_twins
from launchlint.check.unregistered import judged_by_marker, judged_by_registration
from launchlint.check.written_by_assistant import judged_by_assistant
from launchlint.finding import Finding

JUDGES: tuple[Callable[[Iterable[Finding], Known], Iterator[Finding]], ...] = (
    judged_by_conventions,
    judged_by_callers,
    judged_by_registration,
    judged_by_marker,
    judged_by_place,
    judged_by_origin,
    judged_by_inclusion,
    judged_by_includers,
    judged_by_build,
    judged_by_assistant,
    judged_by_whole,
    judged_by_givers,
    judged_by_loss,
    judged_by_name,
    judged_by_remap,
    judged_by_block,
    judged_by_twins,
)


def judged(findings: Iterable[Finding], known: Known) -> list[Finding]:
    """``findings`` in the same order, at the levels, and of the causes, that all judges leave them."""
    for judge in JUDGES:
        findings = judge(findings, known)
    return list(findings)
