"""Parts of texts: what something hangs on that does not hang on all of a text, so that a change of the rest changes nothing."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from launchlint.late import late
from launchlint.workspace.reading import read_bytes

LARGEST = 200_000
"""Bytes of a file that are looked through."""
WRITES = late(r"(?:^|[_\-/~])(?:out|output|save|saver|record|recorder|write|writer|dump|export|exporter|generate|generator)(?![a-z])")
"""What the name of a program, an option or a param has in it that writes a file."""
# No grammar: comments and what never runs count, too, since a name too many only costs a fix its safety.
_USES = late(r"""\bpkg\s*=\s*["']\s*([\w.-]+)|\bfind\(\s*["']([\w.-]+)|\bfind\s+([\w.-]+)\s*\)""")
_WRITTEN = late(r"(?<![a-z])(?!output\s*=)(?:out|sav|record|writ|dump|export|generat)")

_DECLARED = late(
    r"""<arg\b[^<>]{0,300}?\bname\s*=\s*["']([^"'$<>]+)|\barg\s*:\s{0,200}name\s*:\s*["']?([^\s"'$]+)|"""
    r"""\bDeclareLaunchArgument\(\s*(?:name\s*=\s*)?["']([^"'$]+)"""
)
_LAUNCH_FILES = late(r"/([\w.-]{1,100}\.(?:launch|xml|ya?ml|py))\b")
_READ = late(r"""\$\(var\s+['"]?([^\s()'"$]+)|\bLaunchConfiguration\(\s*(?:variable_name\s*=\s*)?["']([^"'$]+)""")


def _packages(text: str) -> Sequence[str]:
    """The packages that a launch file names."""
    return sorted({one or other or third for one, other, third in _USES.findall(text)}) if "<launch" in text else ()


def _writing(text: str) -> Sequence[str]:
    """The whole text, where anything in it may say that it writes."""
    return (text,) if _WRITTEN.search(text) else ()


def _args(text: str) -> Sequence[str]:
    """The args that a launch file of ROS 2 declares and reads, whatever it is written in, and the names of launch files, with a slash.

    Comments count, too.
    """
    declared = {one or other or third for one, other, third in _DECLARED.findall(text)}
    files = {f"/{name}" for name in _LAUNCH_FILES.findall(text)} if declared else set()
    return sorted({*declared.intersection(one or other for one, other in _READ.findall(text)), *files})


PARTS: Mapping[str, Callable[[str], Sequence[str]]] = {"packages": _packages, "writing": _writing, "args": _args}
"""What of a text something may hang on, where it does not hang on all of it: a change of the rest changes nothing."""


def part_of(file: str, part: str) -> Sequence[str]:
    """The ``part`` of the text of ``file``; nothing where it cannot be read. What it hangs on is not noted."""
    try:
        data = read_bytes(file)
    except (OSError, ValueError):
        return ()
    return PARTS[part](data[:LARGEST].decode("utf-8", "replace"))
