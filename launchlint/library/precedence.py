"""Which of the things that are said of one program are heard: a person's words, what was seen in a run, what was read from source."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.library.merge import DYNAMIC, MANUAL, STATIC, TRUST
from launchlint.library.terms import CATEGORIES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

Said = Mapping[str, "Any"]


def trust(said: Said) -> int:
    """That of the best entry of a program; of one without entries, that of a run where it says that it was run, else the least."""
    best = 0
    for variant in said.get("variants", {}).values():
        for category in CATEGORIES:
            for entry in variant.get(category, ()):
                evidence = entry.get("evidence", ())
                best = max(best, *(TRUST[each["by"]] for each in evidence)) if evidence else MANUAL
                if best == MANUAL:
                    return best
        if "run" in variant:
            best = max(best, DYNAMIC)
    return best or STATIC


def suffices(given: Sequence[Said]) -> bool:
    """Whether the sources of a program of the checked packages need not be read: in the user's libraries (``given``) somebody ran it, or
    a person described it. What launchlint ships was said of the public version; what lies here is a copy, and runs.
    """
    return any(trust(each) > STATIC for each in given)


def heard(given: Sequence[Said], own: Said, shipped: Sequence[Said]) -> list[Said]:
    """All that is heard beside ``own``, what the program's sources say here and now; the most trusted of equals first.

    What was read of them at another time counts no more: of the user's libraries, unless these sources leave something open; of the
    library that launchlint ships, in any case. What that has of a run or from a person counts as far as these sources leave something open
    (:mod:`.vendored`). Where they say nothing, it stands alone.
    """
    seen = [each for each in shipped if trust(each) > STATIC]
    if not any(variant.get(category) for variant in own.get("variants", {}).values() for category in CATEGORIES) and (given or seen):
        return [*given, *seen]
    is_open = any("open" in variant for variant in own.get("variants", {}).values())
    mine = [own]
    if seen:
        from launchlint.library.vendored import copy_first

        mine = copy_first(own, seen, by_hand=any(trust(each) == MANUAL for each in seen))
    return [mine[0], *(given if is_open else ()), *mine[1:]]
