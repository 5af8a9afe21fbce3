"""What rules say in XML, said of launch files in Python."""

from __future__ import annotations

import pytest

from launchlint.rules.python_words import in_python


@pytest.mark.parametrize(
    ("said", "in_words_of_python"),
    [
        ("write $(var map) or $(var map a.yaml)", "write LaunchConfiguration('map') or LaunchConfiguration('map', default='a.yaml')"),
        (
            "start the path with $(find-pkg-share PACKAGE) or $(dirname)",
            "start the path with FindPackageShare('PACKAGE') or ThisLaunchFileDir()",
        ),
        ("$(eval …) fails", "PythonExpression(…) fails"),
        ("use $(eval \"'$(var mode)' == 'fast'\")", "use EqualsSubstitution(LaunchConfiguration('mode'), 'fast')"),
        ('put it into a <group> or <let name="a" value="b"/>', "put it into a GroupAction or SetLaunchConfiguration"),
        ("a < b and c > d costs $5", "a < b and c > d costs $5"),
    ],
)
def test_words(said: str, in_words_of_python: str) -> None:
    assert in_python(said) == in_words_of_python
