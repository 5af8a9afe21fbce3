"""A walk through all that a description holds."""

from __future__ import annotations

from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2.description import Description, Group, Let, Text
from launchlint.syntax.ros2.everything import everything
from launchlint.syntax.ros2.reading import read


def kinds(text: str) -> list[str]:
    return [type(each).__name__ for each in everything(read(text.encode(), "a.launch.xml").description)]


def test_each_comes_before_what_is_in_it_in_the_order_of_the_file() -> None:
    text = '<launch><group if="$(var x)"><node pkg="a" exec="b"><remap from="c" to="d"/></node></group><let name="e" value="f"/></launch>'
    found = [each for each in kinds(text) if each not in ("Text", "Process")]
    assert found == ["Description", "Group", "Node", "Remap", "Condition", "Substitution", "Let"]


def test_what_is_shared_comes_once_however_often_it_is_there() -> None:
    """Forty groups, each twice in the one around it, are more than a million million on the way."""
    place = Place(Source("a.launch.py", "x"), Span(0, 1))
    action: Group | Let = Let(Text(("a",), place), Text(("b",), place), place)
    for _ in range(40):
        action = Group((action, action), True, True, (), place)
    found = list(everything(Description((action,), place)))
    assert sum(isinstance(each, Group) for each in found) == 40
    assert sum(isinstance(each, Let) for each in found) == 1
