"""Only the random names of temporary files become one name."""

from __future__ import annotations

import pytest

from launchlint.evaluate.session import WRITTEN
from tests.conformance.ros2.temporary_names import NAME, of_answer, of_model


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ('{"of": "/tmp/tmpk3x_9a1q"}', f'{{"of": "{NAME}"}}'),
        ('["-f /tmp/tmpk3x_9a1q -x"]', f'["-f {NAME} -x"]'),
        ('["/tmp/tmpk3x_9a1q.yaml", "/tmp/tmpk3x_9a1q/a", "/tmp/tmpshort", "/tmp/maps/a.yaml"]', None),
        ('["/tmp/<string>", "$(command x)"]', None),
    ],
)
def test_names_in_answers(line: str, expected: str | None) -> None:
    assert of_answer(line) == (line if expected is None else expected)


def test_names_in_models() -> None:
    line = f'{{"of": "{WRITTEN}0123456789abcdef", "file": "{WRITTEN}0123456789abcdef.yaml", "a": "/tmp/tmpk3x_9a1q"}}'
    assert of_model(line) == f'{{"of": "{NAME}", "file": "{WRITTEN}0123456789abcdef.yaml", "a": "/tmp/tmpk3x_9a1q"}}'
