"""What there was where something looked around, and what is shared of it."""

from __future__ import annotations

from pathlib import Path

from launchlint.workspace.looking import ALL_BELOW, Looked, note, noted, state, watched
from launchlint.workspace.states import Looks, States, places_of


def test_what_many_look_at_is_kept_once(tmp_path: Path) -> None:
    whole = frozenset(str(tmp_path / str(number)) for number in range(100))
    states = States()
    noted()
    note(whole)
    note([str(tmp_path)])
    first = states.looks(noted())
    _, looked = watched(lambda: note(whole))
    second = states.looks(looked, [first])
    assert [path for path, _ in first.own] == [str(tmp_path)] == [path for path, _ in second.own]
    assert len(first.shared) == 1
    assert first.shared[0] is second.shared[0]
    assert dict(first.shared[0].looks) == dict.fromkeys(whole, "")
    noted()


def test_equal_looks_are_shared_once(tmp_path: Path) -> None:
    looked = Looked(frozenset(), (frozenset((str(tmp_path),)),))
    assert len(States().looks(looked, [States().looks(looked)]).shared) == 1


def test_equal_looks_have_one_name(tmp_path: Path) -> None:
    several = [States().looks(Looked(frozenset(), (frozenset((str(tmp_path),)),))).shared[0] for _ in range(2)]
    assert several[0] == several[1]
    assert several[0].name == several[1].name
    (tmp_path / "new").touch()
    other = States().looks(Looked(frozenset(), (frozenset((str(tmp_path),)),))).shared[0]
    assert other != several[0]
    assert other.name != several[0].name


def test_a_path_is_looked_at_once_until_it_changes(tmp_path: Path) -> None:
    file, whole = tmp_path / "a.yaml", frozenset((str(tmp_path / "a.yaml"), str(tmp_path / "b.yaml")))
    states = States()

    def seen() -> Looks:
        return states.looks(Looked(frozenset((str(file),)), (whole,)))

    before = seen()
    file.write_text("a: 1\n")
    assert seen() == before
    states.forget(places_of([str(tmp_path / "c.yaml")], listed=True))
    assert seen() == before
    states.forget(places_of([str(file)], listed=False))
    assert dict(seen().own) == {str(file): state(str(file))}
    assert dict(seen().shared[0].looks)[str(file)] == state(str(file)) != ""


def test_places_that_show_a_change(tmp_path: Path) -> None:
    file = str(tmp_path / "config" / "a.yaml")
    told = places_of([file], listed=False)
    assert file in told
    assert f"{file}//packages" in told
    assert str(tmp_path / "config") not in told
    listed = places_of([file], listed=True)
    assert told | {str(tmp_path / "config"), str(tmp_path / "config" / ALL_BELOW), str(tmp_path / ALL_BELOW), f"/{ALL_BELOW}"} <= listed
