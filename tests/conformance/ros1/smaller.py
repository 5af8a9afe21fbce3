"""Launch trees with a little less in them: what a difference is made small with."""

from __future__ import annotations

from collections.abc import Iterator

from lxml import etree

from tests.evaluate.comparison import MAIN, Case


def smaller(case: Case) -> Iterator[Case]:
    """The tree without one file, without one element, with its children in its place, without one attribute, arg or variable, each in
    turn; the largest cuts come first.
    """
    for name in case.files:
        if name != MAIN:
            yield case._replace(files={key: text for key, text in case.files.items() if key != name})
    for name in case.arguments:
        yield case._replace(arguments={key: value for key, value in case.arguments.items() if key != name})
    for name in case.environment:
        yield case._replace(environment={key: value for key, value in case.environment.items() if key != name})
    for name, text in case.files.items():
        if name.endswith(".launch"):
            data = text.encode() if isinstance(text, str) else text
            for cut in _cuts(data):
                yield case._replace(files={**case.files, name: cut})


def _cuts(data: bytes) -> Iterator[bytes]:
    """The document with one thing less; nothing if it is no XML."""
    try:
        count = sum(1 for _ in etree.fromstring(data).iter())
    except etree.XMLSyntaxError:
        return
    for number in range(1, count):
        yield _without(data, number)
    for number in range(1, count):
        element = list(etree.fromstring(data).iter())[number]
        if len(element):
            yield _with_children_instead(data, number)
    for number in range(count):
        for key in list(etree.fromstring(data).iter())[number].attrib:
            yield _without_attribute(data, number, str(key))


def _without(data: bytes, number: int) -> bytes:
    root = etree.fromstring(data)
    element = list(root.iter())[number]
    parent = element.getparent()
    if parent is not None:
        parent.remove(element)
    return etree.tostring(root)


def _with_children_instead(data: bytes, number: int) -> bytes:
    root = etree.fromstring(data)
    element = list(root.iter())[number]
    parent = element.getparent()
    if parent is not None:
        place = parent.index(element)
        parent[place : place + 1] = list(element)
    return etree.tostring(root)


def _without_attribute(data: bytes, number: int, key: str) -> bytes:
    root = etree.fromstring(data)
    del list(root.iter())[number].attrib[key]
    return etree.tostring(root)
