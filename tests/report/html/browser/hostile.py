"""A robot in which every name tries to become markup, a script, or a surprise."""

from __future__ import annotations

import json
from pathlib import Path
from xml.sax.saxutils import quoteattr

NAMES = (
    "</script><script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    '"><svg onload=alert(1)>',
    "javascript:alert(1)",
    "__proto__",
    "constructor",
    "{{7*7}}${7*7}",
    "<!--",
    "]]>",
    "\u202egnp.exe",
    "line\u2028break",
    "&lt;b&gt;&#60;",
    "#node=/x&hide=%",
    "a,b=c&d",
    "style=position:fixed",
    "n" * 3_000,
    "/".join("d" * 60),
    "😀é漢",
)


def write_hostile(directory: Path) -> None:
    """``hostile.launch``, what it includes, and ``library.json``, in a new directory."""
    directory.mkdir()
    included = "<b>bold<b>.launch"
    (directory / included).write_text('<launch><node pkg="p" type="t" name="inner"/></launch>')
    groups = "\n".join(_group(number, name) for number, name in enumerate(NAMES))
    include = f"<include file={quoteattr('$(dirname)/' + included)}/>"
    launch = f'<launch>\n<arg name="x" default="true"/>\n{groups}\n{include}\n</launch>\n'
    (directory / "hostile.launch").write_text(launch, encoding="utf-8")
    executables = {f"e{number}": _program(name) for number, name in enumerate(NAMES)}
    library = {"format": "launchlint-library", "version": 1, "packages": {"p": {"executables": executables}}}
    (directory / "library.json").write_text(json.dumps(library))


def _group(number: int, name: str) -> str:
    quoted = quoteattr(name)
    names = (("out", name), ("in", NAMES[number - 1]), ("serve", name))
    remaps = (f"<remap from={quoteattr(source)} to={quoteattr(target)}/>" for source, target in names)
    return (
        f'<group ns={quoted} if="$(arg x)"><node pkg="p" type="e{number}" name={quoted}>'
        f"<param name={quoted} value={quoted}/>{''.join(remaps)}</node></group>"
        f"<node pkg={quoted} type={quoted} name={quoteattr(f'u{number}{name}')} args={quoted}/>"
    )


def _program(name: str) -> dict[str, object]:
    """A library says only names that may be ones of ROS, but where they are from is any text."""
    evidence = [{"by": "manual", "at": name[:900]}]
    endpoints = {
        "publishers": [{"name": "out", "type": "a_msgs/A", "evidence": evidence}],
        "subscribers": [{"name": "in", "type": "b_msgs/B", "evidence": evidence}],
        "services": [{"name": "serve", "type": "c_srvs/C"}],
    }
    return {"class": "roscpp", "variants": {"default": endpoints}}
