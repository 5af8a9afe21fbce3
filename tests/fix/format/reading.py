"""What must still be there after formatting, read by other means than the formatter's own."""

from __future__ import annotations

import io
import re
from collections import Counter
from typing import NamedTuple

import yaml
from lxml import etree

_SPACE = re.compile(r"\s+")


class Held(NamedTuple):
    """The comments and attributes of a file (each as often as it is there), and its references as written."""

    comments: Counter[tuple[str, ...]]
    attributes: Counter[tuple[str, str, str]]
    references: Counter[str]


def held(data: bytes) -> Held:
    """What lxml finds in a launch file; references are counted in the text."""
    root = _parsed(data)
    found = [each for each in (*root.iter(), *_around(root)) if isinstance(each, etree._Comment)]
    comments = Counter(tuple(line.strip() for line in str(each.text).split("\n")) for each in found)
    attributes = Counter((str(each.tag), str(name), str(value)) for each in root.iter(etree.Element) for name, value in each.attrib.items())
    return Held(comments, attributes, Counter(re.findall(rb"&[^;\s]+;", data)))  # type: ignore[arg-type]  # bytes count as well


def canonical(data: bytes) -> bytes:
    """C14N of a launch file without the white space that means nothing, and with what PyYAML reads in place of YAML that it can read."""
    root = _parsed(data)
    for element in (*root.iter(), *_around(root)):
        if element.tag == "rosparam" and not len(element) and not _kept(element):
            element.text = _yaml(element.text or "")
        if isinstance(element.tag, str) and element.tag.lower() != "rosparam" and not _kept(element):
            element.text = _SPACE.sub("", element.text or "")
        if not isinstance(element.tag, str) and isinstance(element, etree._Comment):
            element.text = "\n".join(line.strip(" \t") for line in (element.text or "").split("\n"))
        parent = element.getparent()
        if parent is not None and not _kept(parent) and str(parent.tag).lower() != "rosparam":
            element.tail = _SPACE.sub("", element.tail or "")
    out = io.BytesIO()
    root.getroottree().write_c14n(out, with_comments=True)
    return out.getvalue()


def _yaml(text: str) -> str:
    try:
        return repr(yaml.safe_load(text)).encode("ascii", "backslashreplace").decode("ascii").replace("\0", "")
    except (yaml.YAMLError, ValueError):
        return text


def _around(root: etree._Element) -> list[etree._Element]:
    """The comments and processing instructions before and after the document element."""
    return [*root.itersiblings(preceding=True), *root.itersiblings()]


def _kept(element: etree._Element) -> bool:
    return "preserve" in element.xpath("ancestor-or-self::*/@xml:space")


def _parsed(data: bytes) -> etree._Element:
    parser = etree.XMLParser(resolve_entities=True, no_network=True, load_dtd=False, strip_cdata=False, huge_tree=True)
    return etree.fromstring(data, parser)
