"""Hostile text, made harmless: one line for each thing that has ever broken out."""

from __future__ import annotations

import subprocess

import pytest
from hypothesis import given
from hypothesis import strategies as some

from launchlint.report import escape


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("plain text, ümläut, 表示 😀", "plain text, ümläut, 表示 😀"),
        ("\u3000", "\u3000"),
        ("\x1b[31m\x9b", "\\x1b[31m\\x9b"),
        ("a\tb\nc\rd\x00", "a\\tb\\nc\\rd\\x00"),
        ("\u2028\u2029\x85\x0b\x0c", "\\u2028\\u2029\\x85\\x0b\\x0c"),
        ("\u202a\u202e\u2066\u2069\u200e\u200f\u061c", "\\u202a\\u202e\\u2066\\u2069\\u200e\\u200f\\u061c"),
        ("\xa0\xad\u200b\ufeff\U000e0041", "\\xa0\\xad\\u200b\\ufeff\\U000e0041"),
        ("\udcff\ud800", "\\xff\\ud800"),
        ("##[error]", "##\\x5berror]"),
    ],
)
def test_visible(text: str, expected: str) -> None:
    assert escape.visible(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [("::error::x", "./::error::x"), ("  ::error::x", "./  ::error::x"), ("a::b", "a::b"), ("a.launch", "a.launch")],
)
def test_line_start(text: str, expected: str) -> None:
    assert escape.line_start(text) == expected


def test_github() -> None:
    assert escape.github_message("50%\n::x\r,:") == "50%25%0A::x\\r,:"
    assert escape.github_property("a:b,c%\n") == "a%3Ab%2Cc%25\\n"


def test_html() -> None:
    assert escape.html("<a href=\"x\" o='y'>&\x1b\n") == "&lt;a href=&quot;x&quot; o=&#39;y&#39;&gt;&amp;\\x1b\n"


def test_xml() -> None:
    assert escape.xml('<a b="c">]]>&\x00\ufffe\n') == "&lt;a b=&quot;c&quot;&gt;]]&gt;&amp;\\x00\\ufffe\n"


def test_markdown() -> None:
    assert escape.markdown("plain-name_1/a.launch") == "plain-name&#95;1/a.launch"
    assert escape.markdown("[x](http://e) `c` |<b>&") == ("&#91;x&#93;&#40;http&#58;//e&#41; &#96;c&#96; &#124;&#60;b&#62;&#38;")
    assert escape.markdown("@user #1\nwww.x.org") == "&#64;&#8203;user &#35;&#8203;1&#92;nwww&#46;x.org"


@given(some.text())
def test_nothing_invisible_is_left(text: str) -> None:
    for function in (escape.visible, escape.line_start, escape.github_property, escape.markdown, escape.shell_word):
        assert all(character.isprintable() or character == "\u3000" for character in function(text))


@given(some.text(alphabet=some.characters(codec="utf-8")))
def test_no_surrogates_leaves_all_else(text: str) -> None:
    assert escape.no_surrogates(text) == text


@pytest.mark.parametrize(
    "word", ["plain", "", "two words", "it's", "$(x)", "a\nb", "\x1b[31m", "\u202e'\\n", "-x", "ü", "\udcff", "a\tb##[c"]
)
def test_a_shell_reads_the_word_it_was_given(word: str) -> None:
    given_bytes = word.encode("utf-8", "surrogateescape")
    script = f"printf '%s' {escape.shell_word(word)}"
    result = subprocess.run(["bash", "-c", script], capture_output=True, check=True, env={"LC_ALL": "C.UTF-8"})
    assert result.stdout == given_bytes
