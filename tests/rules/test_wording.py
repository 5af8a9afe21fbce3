"""What rules call the same thing in launch files of ROS 2 that are written in XML, YAML and Python."""

from __future__ import annotations

import pytest

from launchlint.rules.wording import Words, words_of
from launchlint.source import Place, Source, Span

XML, YAML, PYTHON = Words("xml"), Words("yaml"), Words("python")


@pytest.mark.parametrize(("path", "words"), [("a.launch", XML), ("a.launch.xml", XML), ("a.yaml", YAML), ("a.yml", YAML), ("a.py", PYTHON)])
def test_the_language_of_a_file(path: str, words: Words) -> None:
    assert words_of(path) == words


def test_substitutions() -> None:
    assert XML.call("var", "map", "a.yaml") == YAML.call("var", "map", "a.yaml") == "$(var map a.yaml)"
    assert PYTHON.call("var", "map") == "LaunchConfiguration('map')"
    assert PYTHON.call("var", "map", "a.yaml") == "LaunchConfiguration('map', default='a.yaml')"
    assert (PYTHON.call("dirname"), PYTHON.call("eval", "…")) == ("ThisLaunchFileDir()", "PythonExpression(…)")


def test_paths_and_comparisons() -> None:
    assert XML.under("find-pkg-share", "maps", "a/b.yaml") == "$(find-pkg-share maps)/a/b.yaml"
    assert PYTHON.under("find-pkg-share", "maps", "a/b.yaml") == "PathJoinSubstitution([FindPackageShare('maps'), 'a', 'b.yaml'])"
    assert XML.equals("mode", "fast") == "$(eval \"'$(var mode)' == 'fast'\")"
    assert PYTHON.equals("mode", "fast") == "EqualsSubstitution(LaunchConfiguration('mode'), 'fast')"


def test_actions() -> None:
    assert [words.tag("group") for words in (XML, YAML, PYTHON)] == ["<group>", "group", "GroupAction"]
    assert [words.declared("map") for words in (XML, YAML, PYTHON)] == [
        '<arg name="map"/>',
        "arg: {name: map}",
        "DeclareLaunchArgument('map')",
    ]
    assert [words.passed_on("map") for words in (XML, YAML, PYTHON)] == [
        '<arg name="map" value="$(var map)"/>',
        "arg: {name: map, value: $(var map)}",
        "('map', LaunchConfiguration('map'))",
    ]


def test_what_would_be_no_text_in_yaml_stands_in_quotes() -> None:
    assert YAML.set_to("value", "true") == "value: 'true'"
    assert YAML.set_to("value", "10") == "value: '10'"
    assert YAML.set_to("value", "") == "value: ''"
    assert YAML.set_to("value", "fast") == "value: fast"


def test_a_text_in_a_message_is_never_rewritten() -> None:
    """What people wrote stands in messages as they wrote it, also where it looks like a tag or a substitution of XML."""
    from launchlint.finding import Severity
    from launchlint.rules.rule import Rule

    place = Place(Source("a.launch.py", "x = 1\n"), Span(0, 1))
    finding = Rule("LL999", "some-rule", Severity.INFO).at(place, "the text $(var map) and <group> stay", help="$(dirname)")
    assert (finding.message, finding.help) == ("the text $(var map) and <group> stay", "$(dirname)")
