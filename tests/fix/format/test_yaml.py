"""Launch files in YAML in normal form: what changes, what never does."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.fix.format.yaml_file import yaml_normal_form
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

WRITTEN = """\


launch:
   -   arg: {name: a,
              default: "1"}   # why


   # about the node
   -   node:
          pkg: p   \n\
          # exec
          exec: |
             a
               b\x20\x20
          param:
             -    name: a
                  value: >-
                     x

                     y
             # end


"""

NORMAL = """\
launch:
- arg: {name: a,
         default: "1"}   # why

# about the node
- node:
    pkg: p
    # exec
    exec: |
       a
         b\x20\x20
    param:
    - name: a
      value: >-
         x

         y
    # end
"""


def normal(text: str) -> str:
    return yaml_normal_form(text, Style())


def test_indentation_blanks_and_blank_lines() -> None:
    assert normal(WRITTEN) == NORMAL
    assert normal(NORMAL) == NORMAL


@pytest.mark.parametrize(
    "text",
    [
        "launch:\n  ? node\n  : pkg\n",
        "launch:\n  - &a\n      node: {}\n",
        "launch:\n  -\n    node: {}\n",
        "launch:\n  - - a\n    - b\n",
        "{launch: [\n  {node:   {}}\n]}\n",
        "# nothing but a comment\n",
        "",
    ],
)
def test_unusual_forms_stay_as_they_are(text: str) -> None:
    assert normal(text).strip() == text.strip()


def test_aliases_and_merges_stay_what_they_are() -> None:
    text = "launch:\n   - node: &n {pkg: p, exec: e}\n   - node:\n       <<: *n\n       name: m\n"
    assert normal(text) == "launch:\n- node: &n {pkg: p, exec: e}\n- node:\n    <<: *n\n    name: m\n"


def test_line_ends_and_byte_order_mark_stay() -> None:
    result = formatted(b"\xef\xbb\xbflaunch:\r\n   - reset_env: {}\r\n", "a.launch.yaml", Style())
    assert result.data == b"\xef\xbb\xbflaunch:\r\n- reset_env: {}\r\n"


def test_what_is_no_launch_file_is_left_alone() -> None:
    for text in (b"launch: [", b"- a\n", b"\xff"):
        result = formatted(text, "a.launch.yaml", Style())
        assert result.data == text
        assert result.problem is not None


def test_xml_by_the_name_of_yaml_is_left_alone() -> None:
    assert formatted(b"<launch/>\n", "a.launch.yaml", Style()).refusal
    assert formatted(b"<launch>\n", "a.launch.yaml", Style()).problem is not None


PIECES = ("a:", "- ", "  ", "\n", "    ", "b", "'c'", "|", ">", "# d", "{e: f}", "[", "]", "&g ", "*g", '"h\n i"', "\t", ": ")


@given(st.lists(st.sampled_from(PIECES), max_size=30))
def test_words_and_their_order_never_change(pieces: list[str]) -> None:
    text = "".join(pieces)
    try:
        result = normal(text)
    except (YamlError, YamlBeyond):
        return
    assert "".join(result.split()) == "".join(text.split())
    assert normal(result) == result


@pytest.mark.parametrize("piece", ["# a\n", "- a: b\n", "\n", "- a: |\n    b\n", "   # a\n- a: 1\n"])
def test_great_files_take_linear_time(piece: str) -> None:
    began = time.process_time()
    normal(piece * 5_000)
    assert time.process_time() - began < 10


OFF = """\
launch:
    - arg:   {name: a}
    # launchlint: format off: a table
    - arg:   {name: bbb,   default: "0"}\x20


    - arg:   {name: c,     default: "0"}
    # launchlint: format on
    -   node:
         pkg: joy
         # launchlint: format off
         exec:   joy_node
    -   node:
         exec: |
             # launchlint: format off
             y
         pkg:   x
"""
OFF_NORMAL = """\
launch:
- arg:   {name: a}
# launchlint: format off: a table
- arg:   {name: bbb,   default: "0"}\x20


- arg:   {name: c,     default: "0"}
# launchlint: format on
- node:
    pkg: joy
    # launchlint: format off
    exec:   joy_node
- node:
    exec: |
        # launchlint: format off
        y
    pkg:   x
"""


def test_what_somebody_keeps_moves_as_a_whole() -> None:
    assert yaml_normal_form(OFF, Style()) == OFF_NORMAL
    assert yaml_normal_form(OFF_NORMAL, Style()) == OFF_NORMAL


def test_what_is_kept_ends_with_its_block() -> None:
    text = "launch:\n- node:\n    # launchlint: format off\n    pkg: p\n\n\n- node:\n    pkg: p\n\n\n    exec: x\n"
    assert yaml_normal_form(text, Style()) == text.replace("p\n\n\n    exec", "p\n\n    exec")


def test_all_of_a_file_is_kept() -> None:
    text = "# launchlint: format off\n\n\nlaunch:\n    -   node:   {pkg: p}  \n\n\n"
    assert yaml_normal_form(text, Style()) == text
