"""``launchlint.named_tuple`` is ``typing.NamedTuple`` in all that we use of it."""

from __future__ import annotations

import pickle
import typing

import pytest

from launchlint.named_tuple import NamedTuple


class Ours(NamedTuple):
    """A place."""

    line: int
    column: int = 1
    names: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """As people write it."""
        return f"{self.line}:{self.column}"

    @classmethod
    def first(cls) -> Ours:
        """The first place of a file."""
        return cls(1)


class Theirs(typing.NamedTuple):
    """A place."""

    line: int
    column: int = 1
    names: tuple[str, ...] = ()


def test_is_a_tuple_with_the_same_fields() -> None:
    ours, theirs = Ours(3, names=("a",)), Theirs(3, names=("a",))
    assert ours == theirs == (3, 1, ("a",))
    assert Ours._fields == Theirs._fields
    assert Ours._field_defaults == Theirs._field_defaults
    assert list(Ours.__annotations__) == list(Theirs.__annotations__)
    assert repr(ours) == repr(theirs).replace("Theirs", "Ours")
    assert Ours.__bases__ == Theirs.__bases__ == (tuple,)


def test_has_its_methods_and_its_own_words() -> None:
    assert Ours.first().text == "1:1"
    assert Ours(2)._replace(column=4).text == "2:4"
    assert (Ours.__doc__, Ours.__module__, Ours.__qualname__) == ("A place.", __name__, "Ours")


def test_is_made_again_with_other_values() -> None:
    assert Ours._make([1, 2, ("a",)]) == Ours(1, 2, ("a",))
    assert Ours(1)._asdict() == Theirs(1)._asdict()
    for wrong in (lambda made: made._make([1]), lambda made: made(1)._replace(row=2), lambda made: made(1, row=2), lambda made: made()):
        said = []
        for each in (Ours, Theirs):
            with pytest.raises((TypeError, ValueError)) as failed:
                wrong(each)
            said.append(str(failed.value).replace("Theirs", "Ours"))
        assert said[0] == said[1]


def test_travels_between_processes() -> None:
    there = pickle.loads(pickle.dumps(Ours(7)))  # noqa: S301 (what it reads is written here)
    assert there == Ours(7)
    assert type(there) is Ours


def test_has_no_room_for_anything_else() -> None:
    with pytest.raises(AttributeError):
        Ours(1).more = 2  # type: ignore[attr-defined]
    with pytest.raises(TypeError):
        Ours()  # type: ignore[call-arg]
