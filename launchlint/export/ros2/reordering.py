"""Whether a launch file of ROS 2 does the same when its args stand elsewhere in it."""

from __future__ import annotations

from launchlint.evaluate.session import Read, Session
from launchlint.export.ros2.comparing import launched
from launchlint.export.ros2.converting import disagreement

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.model import Launch


def refusal(session: Session, file: str, before: bytes, after: bytes) -> str:
    """Why args must not be moved, from ``before`` to ``after``, in one sentence without a full stop; empty where that changes nothing.

    All that is started, set, declared and included has been compared in every configuration; only args may come in another order.
    """
    first, second = session.with_text(file, before), session.with_text(file, after)
    for each in (first, second):
        reading = each.reading(file)
        if isinstance(reading, Read) or reading.refusal is not None:
            return "it is no launch file that ros2 launch can read"
    return disagreement((first, file), (second, file), (), _in_any_order)


def _in_any_order(launch: Launch) -> dict[str, list[Any]]:
    found = launched(launch, {})
    return {kind: sorted(items, key=repr) if kind in ("arg", "listed arg") else items for kind, items in found.items()}
