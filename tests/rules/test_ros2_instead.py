"""What is proposed in the place of a substitution that a distribution of ROS 2 does not have."""

from __future__ import annotations

import pytest

from launchlint.rules.judging.ros2_instead import instead_of
from launchlint.rules.ros2.remap_kills_node import _mended
from launchlint.source import Source, Span
from launchlint.syntax.ros2.description import Substitution
from launchlint.syntax.ros2.substitutions import parse
from launchlint.syntax.ros2.tables import distribution
from launchlint.syntax.ros2.written import InYaml


def proposed(name: str, written: str, before: str = "- name: ") -> str:
    value = InYaml(written, Source("main.launch.yaml", before + written), Span(len(before), len(before) + len(written)))
    piece = parse(value, distribution("rolling"), []).pieces[0]
    return instead_of(name, piece.arguments if isinstance(piece, Substitution) else (), value.place)


@pytest.mark.parametrize(
    ("name", "written", "expected"),
    [
        ("if", "$(if $(var sim) 10)", "$(eval \"'10' if '$(var sim)' == 'true' else ''\")"),
        ("equals", "$(equals $(env A 'b c') \"d e\")", "$(eval \"'$(env A 'b c')' == 'd e'\")"),
        ("not-equals", "$(not-equals a b)", "$(eval \"'a' != 'b'\")"),
        ("string-join", "$(string-join _ a b c)", "a_b_c"),
        ("path-join", "$(path-join $(dirname) config)", "$(dirname)/config"),
        ("file-content", "$(file-content a.txt)", "$(command 'cat a.txt')"),
        ("any", "$(any a b c)", "$(or a $(or b c))"),
        ("all", "$(all a b)", "$(and a b)"),
        ("equals", "$(equals a)", ""),
        ("unheard-of", "$(unheard-of a)", ""),
        ("equals", "equals", ""),
    ],
)
def test_what_does_the_same(name: str, written: str, expected: str) -> None:
    assert proposed(name, written) == expected


def test_quotes_in_xml_are_written_as_attributes_take_them() -> None:
    assert proposed("equals", "$(equals a b)", '<let name="x" value="') == "$(eval &quot;'a' == 'b'&quot;)"


@pytest.mark.parametrize(
    ("name", "expected"),
    [("~scan", "~/scan"), ("a-b//c__d/", "a_b/c_d"), ("{ns}/{node}/x", "/front/talker/x"), ("/2d", "/n2d"), ("fine/name", "fine/name")],
)
def test_names_that_rcl_takes(name: str, expected: str) -> None:
    assert _mended(name, "/front/talker") == expected
