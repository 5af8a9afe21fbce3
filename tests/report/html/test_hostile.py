"""Names that try to become markup, scripts or surprises: in the page they are text."""

from __future__ import annotations

import shlex
import unicodedata
from pathlib import Path
from xml.sax.saxutils import quoteattr

import pytest

from tests.report.html.browser.hostile import NAMES, write_hostile
from tests.report.html.pages import Elements, data_of, page


@pytest.fixture
def directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    write_hostile(tmp_path / "hostile")
    relays = (
        f'<node pkg="topic_tools" type="relay" name="relay{number}" args={quoteattr(shlex.quote(name) + " out")}>'
        f'<remap from="out" to={quoteattr(name)}/></node>'
        for number, name in enumerate(NAMES)
    )
    (tmp_path / "hostile" / "relays.launch").write_text(f"<launch>{''.join(relays)}</launch>", encoding="utf-8")
    monkeypatch.chdir(tmp_path / "hostile")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "hostile"


WORDS = ("--title", NAMES[0], "--source-url", "https://example.org/x")


def test_no_name_becomes_an_element_or_an_attribute(directory: Path) -> None:
    hostile = Elements(page(*WORDS))
    tags = {tag for tag, _ in hostile.found}
    assert tags.isdisjoint({"img", "b:evil", "iframe", "object", "embed", "form", "base"})
    assert len(hostile.scripts) == 3
    known = {
        "lang", "charset", "http-equiv", "content", "name", "class", "href", "id", "aria-label", "scope", "colspan", "tabindex", "role",
        "open", "data-index", "data-entry", "type", "title", "viewbox", "aria-hidden", "d",
    }  # fmt: skip
    assert sorted({name for _, attributes in hostile.found for name in attributes} - known) == []


def test_links_lead_to_the_page_or_to_the_forge(directory: Path) -> None:
    targets = {str(attributes["href"]) for _, attributes in Elements(page(*WORDS)).found if "href" in attributes}
    assert {target for target in targets if not target.startswith(("https://example.org/x/", "#entry=", "#finding="))} == {
        "#tables",
        "#library",
    }
    assert any(target.startswith("https://example.org/x/%3Cb%3Ebold%3Cb%3E.launch#L") for target in targets)


def test_nothing_invisible_is_in_the_page(directory: Path) -> None:
    html = page(*WORDS)
    own = html[html.index("</style>") : html.rindex('<script type="application/json"')] + str(data_of(html))
    assert (
        sorted({f"U+{ord(each):04X}" for each in own if unicodedata.category(each) in ("Cc", "Cf", "Cs", "Zl", "Zp") and each != "\n"})
        == []
    )


def test_endless_names_do_not_make_an_endless_page(directory: Path) -> None:
    inner = '<param name="{name}" value="{name}"/><remap from="{name}" to="{name}"/>'
    text = f'<launch><node pkg="p" type="t" name="{{name}}">{inner}</node></launch>'
    (directory / "endless.launch").write_text(text.format(name="n" * 1_000_000), encoding="utf-8")
    small, large = len(page("hostile.launch")), len(page("endless.launch"))
    assert large < small


def test_a_command_is_one_that_can_be_typed(directory: Path) -> None:
    package = "<package><name>demo</name><version>1.0.0</version><description/><maintainer email='a@b.c'>a</maintainer></package>"
    (directory / "demo").mkdir()
    (directory / "demo" / "package.xml").write_text(package, encoding="utf-8")
    (directory / "demo" / "run.sh").write_text("#!/bin/sh\n", encoding="utf-8")
    (directory / "demo" / "run.sh").chmod(0o755)
    commands = {"$(touch x).launch": "launchlint probe --unknown '$(touch x).launch'", "a\u202eb.launch": "launchlint probe --unknown"}
    for name, command in commands.items():
        nodes = '<node pkg="demo" type="run.sh" name="a"/><node pkg="&lt;img src=x&gt;" type="&lt;script&gt;alert(1)" name="b"/>'
        (directory / name).write_text(f"<launch>{nodes}</launch>", encoding="utf-8")
        html = page(name)
        (entry,) = data_of(html)["entries"]
        assert entry["mend"]["command"] == command
        assert "<img" not in html
        assert html.count("<script") == 3
