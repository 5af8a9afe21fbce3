"""What the lower rooms noticed: facts, not yet words.

The syntax and evaluation rooms do not know any rule. Where roslaunch would stop, warn or silently
do something else, they record a :class:`Problem`: a kind from the list below, a place, and
the facts a rule needs for its message. One rule turns one kind (or a few) into findings.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from launchlint.source import Origin, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Problem(NamedTuple):
    """One noticed fact.

    ``kind`` is one of the names that ``rules/registry.py`` maps to rules. ``facts`` hold plain values, their keys are
    documented where the problem is recorded. ``refused`` says that roslaunch refuses to load (or launch) the file
    because of it; ``related`` are further places with a short label each. ``assumed`` says that it stands under a condition whose value is
    unknown, so that it may never come to pass.
    """

    kind: str
    origin: Origin
    facts: Mapping[str, Any]
    refused: bool = False
    related: tuple[tuple[Place, str], ...] = ()
    assumed: bool = False

    @property
    def place(self) -> Place:
        """Where it is written."""
        return self.origin.place
