"""The launch file itself in normal form: includes, args, conditions and comments stay, so that it can still be changed and started
with other args.
"""

from __future__ import annotations

from launchlint.evaluate.session import Session
from launchlint.export.written import CannotExport
from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.fix.guard import Caller, Guard

TYPE_CHECKING = False
if TYPE_CHECKING:
    Pairs = tuple[tuple[str, str], ...]


def plain(session: Session, file: str, given: Pairs, style: Style) -> bytes:
    """``file`` in normal form, proved to mean the same in every configuration, also when it is started with ``given``.

    Raises CannotExport.
    """
    data = session.read(file).data
    assert data is not None
    result = formatted(data, session.shown(file), style)
    if result.problem is not None:
        raise CannotExport(f"it cannot be read ({result.problem.kind.replace('-', ' ')})")
    refusal = result.refusal or Guard(session, lambda _: [Caller(file, given)]).refusal(file, data, result.data)
    if refusal:
        raise CannotExport(refusal)
    return result.data
