"""When Python looks for garbage in circles."""

from __future__ import annotations

import gc
import weakref

import pytest

from launchlint import garbage


class Circle:
    """Holds itself."""

    def __init__(self) -> None:
        self.own = self


def test_what_is_left_to_quiet_moments_is_looked_for_then(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(garbage, "WORTH_A_LOOK", 100)
    before = gc.get_threshold()
    with garbage.left_to_quiet_moments():
        assert gc.get_threshold()[0] == garbage.MOST_OBJECTS
        gone = weakref.ref(Circle())
        garbage.look(thoroughly=False)
        assert gone() is not None, "too few objects are new for a look"
        kept = [Circle() for _ in range(200)]
        garbage.look(thoroughly=False)
        assert gone() is None
        old = weakref.ref(kept.pop())
        garbage.look(thoroughly=True)
        assert old() is None
    assert gc.get_threshold() == before
    assert gc.get_freeze_count() == 0


def test_what_is_made_to_stay_is_not_looked_through() -> None:
    with garbage.made_to_stay():
        assert not gc.isenabled()
        kept = [[number] for number in range(1_000)]
    assert gc.isenabled()
    assert gc.get_freeze_count() >= len(kept)
    garbage.let_go()
    assert gc.get_freeze_count() == 0
