"""Pages of small repositories, and what is in them."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

from launchlint.cli.commands import run as run_command
from launchlint.report.html.pack import DIGITS
from tests.cli.running import PACKAGE, write

LIBRARY: dict[str, Any] = {
    "format": "launchlint-library",
    "version": 1,
    "packages": {
        "demo": {
            "executables": {
                "talk.py": {
                    "class": "rospy",
                    "variants": {
                        "default": {
                            "publishers": [
                                {"name": "chatter", "type": "std_msgs/String", "evidence": [{"by": "static", "at": "scripts/talk.py:4"}]}
                            ],
                            "params": [{"name": "~rate", "default": 10}],
                        }
                    },
                },
                "listen.py": {
                    "class": "rospy",
                    "variants": {"default": {"subscribers": [{"name": "chatter", "type": "std_msgs/Int32"}]}},
                },
            }
        }
    },
}
NAV = """\
<launch>
  <arg name="sim" default="false"/>
  <group ns="robot">
    <node name="talker" pkg="demo" type="talk.py">
      <param name="rate" value="5"/>
      <remap from="chatter" to="news"/>
    </node>
    <node if="$(arg sim)" name="listener" pkg="demo" type="listen.py">
      <remap from="chatter" to="news"/>
    </node>
  </group>
  <include file="$(find demo)/launch/more.launch"/>
</launch>
"""
MORE = """\
<launch>
  <node name="driver" pkg="demo" type="unknown.py"/>
</launch>
"""


def repository(directory: Path) -> Path:
    """A package of two known programs and one that nobody knows, with a launch file that includes another one."""
    write(
        directory,
        {
            ".git/HEAD": "ref: refs/heads/main\n",
            "demo/package.xml": PACKAGE.format(name="demo"),
            "demo/scripts/talk.py": "#!/usr/bin/env python3\n",
            "demo/scripts/listen.py": "#!/usr/bin/env python3\n",
            "demo/scripts/unknown.py": "#!/bin/sh\n",
            "demo/launch/nav.launch": NAV,
            "demo/launch/more.launch": MORE,
            "library.json": json.dumps(LIBRARY),
        },
    )
    return directory


def page(*words: str) -> str:
    """The page that ``launchlint report WORDS`` writes in the current directory."""
    assert run_command(["report", "--quiet", "-o", "page.html", *words]) == 0
    return Path("page.html").read_text(encoding="utf-8")


def data_of(html: str) -> Any:
    """The data of a page, as ``js/unpack.js`` reads it."""
    found = re.findall(r'<script type="application/json" id="launchlint-data">(.*?)</script>', html, re.DOTALL)
    assert len(found) == 1
    head, *lines, last = found[0].split("\n")
    data = unpacked(json.loads(head))
    data["library"] = unpacked(json.loads(last))
    for entry, line in zip(data["entries"], lines, strict=True):
        entry.update(unpacked(json.loads(line)))
    return data


def unpacked(value: Any) -> Any:
    """The reverse of :func:`launchlint.report.html.pack.packed`, as ``js/unpack.js`` does it."""
    if isinstance(value, list):
        return [unpacked(each) for each in value]
    if not isinstance(value, dict):
        return value
    if "$rows" not in value:
        return {key: unpacked(each) for key, each in value.items()}
    rows: list[dict[str, Any]] = [{} for _ in range(value["$rows"])]
    for key, column in value["columns"].items():
        for row, cell in zip(rows, _cells(len(rows), column), strict=True):
            if cell is not _MISSING:
                row[key] = cell
    return rows


_MISSING = object()


def _cells(count: int, column: Any) -> list[Any]:
    if isinstance(column, dict) and "$all" in column:
        return [unpacked(column["$all"])] * count
    if not isinstance(column, dict) or "$of" not in column:
        return _list(column)
    distinct = _list(column["$of"])
    at = column["$at"] if isinstance(column["$at"], list) else [DIGITS.find(digit) for digit in column["$at"]]
    return [_MISSING if index < 0 else distinct[index] for index in at]


def _list(value: Any) -> list[Any]:
    if isinstance(value, list):
        return [unpacked(each) for each in value]
    texts: list[str] = []
    before = ""
    for text in value["$front"]:
        before = before[: DIGITS.index(text[0])] + text[1:]
        texts.append(before)
    return texts


class Elements(HTMLParser):
    """All elements of a page with their attributes, and the text of its cells and paragraphs."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.found: list[tuple[str, Mapping[str, str | None]]] = []
        self.scripts: list[str] = []
        self.styles: list[str] = []
        self._inside = ""
        self.feed(html)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))
        self._inside = tag
        if tag == "script":
            self.scripts.append("")
        if tag == "style":
            self.styles.append("")

    def handle_endtag(self, tag: str) -> None:
        self._inside = ""

    def handle_data(self, data: str) -> None:
        if self._inside == "script":
            self.scripts[-1] += data
        if self._inside == "style":
            self.styles[-1] += data

    def ids(self) -> list[str]:
        """All ids, in order."""
        return [str(attributes["id"]) for _, attributes in self.found if "id" in attributes]
