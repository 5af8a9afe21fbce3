"""Hostile files: bounded time and memory, a plain answer, nothing opened."""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import pytest

from launchlint.syntax import parse as parser
from launchlint.syntax.parse import MAX_BYTES, MAX_DEPTH, parse
from launchlint.syntax.ros1.validate import validate


def bomb(levels: int, width: int) -> bytes:
    entities = ['<!ENTITY e0 "ha">', *(f'<!ENTITY e{n} "{f"&e{n - 1};" * width}">' for n in range(1, levels))]
    return f"<!DOCTYPE launch [{''.join(entities)}]><launch a='&e{levels - 1};'>&e{levels - 1};</launch>".encode()


def chain(length: int) -> bytes:
    entities = "".join(f'<!ENTITY e{n} "&e{n + 1};">' for n in range(length))
    return f'<!DOCTYPE launch [{entities}<!ENTITY e{length} "x">]><launch>&e0;</launch>'.encode()


def quadratic(size: int, times: int) -> bytes:
    return f"<!DOCTYPE launch [<!ENTITY e '{'x' * size}'>]><launch a='{'&e;' * times}'/>".encode()


@pytest.mark.parametrize(
    ("data", "kind", "words"),
    [
        (bomb(10, 10), "malformed-xml", "the entities of this file expand to far more than is written"),
        (bomb(10, 10).replace(b"&e8;", b"&#38;e8;"), "malformed-xml", "the entities of this file expand to far more than is written"),
        (quadratic(200_000, 2_000), "malformed-xml", "the entities of this file expand to far more than is written"),
        (quadratic(20_000, 1_000), "malformed-xml", "the entities of this file expand to far more than is written"),
        (quadratic(2_000_000, 6), "unreadable-file", "its entities expand to more than 8 MiB"),
        (chain(100_000), "unreadable-file", "its entities refer to each other more than 50 deep"),
        (b"<launch>" + b"<a/>" * 300_000 + b"</launch>", "unreadable-file", "it has more than 250,000 elements, attributes and comments"),
        (
            b"<launch>" + b"<!---->" * 300_000 + b"</launch>",
            "unreadable-file",
            "it has more than 250,000 elements, attributes and comments",
        ),
        (
            b"<launch " + b" ".join(b"a%d=''" % n for n in range(300_000)) + b"/>",
            "unreadable-file",
            "it has more than 250,000 elements, attributes and comments",
        ),
        (b"<launch>" + b" " * MAX_BYTES + b"</launch>", "unreadable-file", "the file has more than 32 MiB"),
    ],
    ids=["laughs", "laughs in disguise", "quadratic", "quadratic, small", "large", "chain", "elements", "comments", "attributes", "bytes"],
)
def test_refused_without_much_memory(data: bytes, kind: str, words: str) -> None:
    tracemalloc.start()
    try:
        document = parse(data, "a.launch")
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    (problem,) = document.problems
    assert problem.kind == kind
    assert words in (getattr(problem, "message", ""), getattr(problem, "reason", ""))
    assert problem.refused == (kind == "malformed-xml")
    assert document.launch is None
    assert peak < 200 * 1024 * 1024


def test_small_entities_are_expanded() -> None:
    document = parse(bomb(4, 3), "a.launch")
    assert document.problems == []
    assert document.elements[0].text == "ha" * 27
    assert document.elements[0].get("a") == "ha" * 27


@pytest.mark.parametrize(
    "head",
    ["<!DOCTYPE launch [<!ENTITY e SYSTEM '{}'>]>", "<!DOCTYPE launch SYSTEM '{}'>", "<!DOCTYPE launch [<!ENTITY % p SYSTEM '{}'> %p;]>"],
    ids=["entity", "dtd", "parameter entity"],
)
def test_nothing_external_is_opened(tmp_path: Path, head: str) -> None:
    secret = tmp_path / "secret"
    secret.write_text("<!ENTITY e 'secret'>")
    document = parse(f"{head.format(secret.as_uri())}<launch>&e;</launch>".encode(), "a.launch")
    assert [element.text for element in document.elements] == [""]
    assert document.problems == []


@pytest.mark.parametrize("depth", [MAX_DEPTH, MAX_DEPTH + 1, 10_000, 100_000])
def test_deep_nesting(depth: int) -> None:
    data = b"<launch>" + b"<group>" * (depth - 1) + b"</group>" * (depth - 1) + b"</launch>"
    document = parse(data, "a.launch")
    assert document.max_depth == depth - 1
    if depth <= MAX_DEPTH:
        assert document.problems == []
        assert [problem.kind for problem in validate(document)] == ["ineffective-attribute"]
        return
    (problem,) = document.problems
    assert (problem.kind, problem.refused, document.launch) == ("malformed-xml", True, None)
    assert problem.message == f"{depth} elements stand inside each other"
    assert problem.hint == "roslaunch walks the file by recursion and stops with: maximum recursion depth exceeded"
    assert validate(document) == []


def test_deep_and_never_closed() -> None:
    document = parse(b"<launch>" + b"<group>" * 100_000, "a.launch")
    (problem,) = document.problems
    assert problem.message == "<group> is never closed"


@pytest.mark.parametrize(
    "data",
    [
        b"<launch a='" + b"x" * 2_000_000,
        b"<launch " + b"a " * 500_000,
        b"<launch>" + b"<" * 1_000_000,
        b"<launch>" + b"&" * 1_000_000,
        b"<launch>" + b"\n" * 1_000_000 + b"<node>\n</launch>",
        b"<!-- " + b"- " * 1_000_000,
        b"<launch>" + b"<group>\n" * 20_000 + b"</launch>",
        b"<launch " + b"a='" * 300_000,
        b"<?xml version='1.0' " + b"encoding " * 200_000,
        b"<launch a='" + b"a=" * 300_000 + b"' b",
        b"<!DOCTYPE launch [" + b"<!ENTITY " * 100_000,
    ],
    ids=["value", "names", "less", "ampersands", "lines", "hyphens", "tags", "quotes", "declaration", "equals", "entities"],
)
def test_broken_and_large(data: bytes) -> None:
    (problem,) = parse(data, "a.launch").problems
    assert problem.kind in ("malformed-xml", "unreadable-file")


def test_limits_are_what_the_messages_say() -> None:
    assert (parser.MAX_BYTES, parser.MAX_PIECES, parser.MAX_DEPTH) == (33_554_432, 250_000, 988)
