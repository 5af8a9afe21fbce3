"""Parts of texts: what something hangs on that does not hang on all of a text, so that a change of the rest changes nothing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from functools import cache

from launchlint.late import late
from launchlint.workspace import given_args
from launchlint.workspace.reading import read_bytes

LARGEST = 200_000
"""Bytes of a file that are looked through."""
_LONGEST_LINE = 2_000
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
_NAMES = "(ardent|bouncy|crystal|dashing|eloquent|foxy|galactic|humble|iron|jazzy|kilted|rolling)"
_DISTRIBUTION = late(rf"(?<![A-Za-z]){_NAMES}(?![A-Za-z])")
_SEVERAL = late(rf"(?<![A-Za-z]){_NAMES}[\s`'\"*]{{0,9}}(?:[,/&+|]|and|or)[\s`'\"*]{{0,9}}{_NAMES}(?![A-Za-z])")
# All of them are plain words, too: one counts in a line that is about ROS, or as all that stands in a line or cell.
_OF_ROS = late(r"ros|distro|branch|version|docker|image|ubuntu|tree/|ridley|hawksbill|jalisco")
_AROUND = " \t\r#>*|-[](){}'\",:_`"
# Or written as a name, after a word before which somebody says for what: "runs on Dashing".
_PROPER = late(
    r"\b(?:for|on|under|with) (Ardent|Bouncy|Crystal|Dashing|Eloquent|Foxy|Galactic|Humble|Iron|Jazzy|Kilted|Rolling)(?![A-Za-z])"
)
_OTHER_BRANCH = late(
    r"\b(?:if|for)\b.{0,100}(?:check|see|use|switch|go to|visit|refer|look).{0,200}\bbranch(?![a-z])|"
    r"(?:check|see|use|switch|go to|visit|refer|look).{0,200}\bbranch(?![a-z]).{0,100}\b(?:if|for)\b"
)
"""In small letters: where those find what they want who have another distribution."""
_DOCUMENTS = late(r"\b(?:docs|index|design|wiki|discourse|answers)\.ros\.org/\S*")
_READ = late(r"""\$\(var\s+['"]?([^\s()'"$]+)|\bLaunchConfiguration\(\s*(?:variable_name\s*=\s*)?["']([^"'$]+)""")


_TOPICS = late(
    r"""\b(?:(advertise\w*|Publisher)|(subscribe|Subscriber))\s*(?:<[^<>()]{0,100}(?:<[^<>()]{0,100}>[^<>()]{0,100})?>)?[\s\w]{0,40}\(\s*"""
    r"""(?:\w+\s*,\s*)?["']([\w/~]{1,100})["']"""
)

_MANAGES = late(
    r"lifecycle\s+set|lifecycle_bringup|node_names|[cC]hange_?[sS]tate|TRANSITION_|trigger_(?:transition|configure|activate)|"
    r"lifecycle_manager"
)
_IN_CODE = late(r"[cC]hange_?[sS]tate|TRANSITION_|trigger_(?:transition|configure|activate)")
_MANAGES_ANY = late(r"lifecycle\s+(?:set|nodes)\s+(?:[$\"'{]|[/\w]*\$)")
"""Where the node is a variable of a script."""
_LISTED = late(r"""\[([\s"'/\w,]{1,4000})\]|(?m:^[ \t]*-[ \t]+["']?([/\w]+)["']?[ \t\r]*$)|(?:value|args)=["']([^"'<>]{1,600})""")
_QUOTED = late(r"""["'](?:[/\w]*/)?(\w{2,80})(?:/change_state)?["']""")
_NODE_NAME = late(r"[A-Za-z_]\w{1,80}")

_ATTRIBUTE = late(r"""\b(pkg|type|args|from|to)\s*=\s*(?:"([^"<>\t\r\n]{0,300})"|'([^'<>\t\r\n]{0,300})')""")
_LONGEST_TAG = 2_000
_LOADING = ("load", "standalone")

_ENV = late(r"\$\(\s*env\s+([A-Za-z_]\w*)\s*\)")
_COMMENT = late(r"(?s)<!--.*?(?:-->|\Z)")
_OPTIONAL = late(r"\$\(\s*(?:optenv\s+([A-Za-z_]\w*)|env\s+([A-Za-z_]\w*)\s+[^\s)])")
"""Read with a default, in ROS 1 or in ROS 2."""
_MACHINE = late(r"<machine\b[^<>]{0,1000}?\bname\s*=\s*[\"']([^\"'$<>]{1,200})[\"']")

GIVEN, GIVEN_IN_LAUNCH = "given", "given in launch"

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.contents import Contents


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


def _topics(text: str) -> Sequence[str]:
    """The last parts of the names of topics in the code of a node of ROS 1, with ``+`` where it publishes and ``-`` where it hears."""
    found = _TOPICS.findall(text)
    return sorted({f"{'+' if gives else '-'}{name.rstrip('/').rpartition('/')[2].lstrip('~')}" for gives, _, name in found})


def _remaps(text: str) -> Sequence[str]:
    """The remaps inside the nodes of a launch file of ROS 1: program (the class of a nodelet), ``from`` and ``to``, parted by tabs."""
    if "<launch" not in text:
        return ()
    found: set[str] = set()
    for piece in _without_comments(text).split("<node")[1:]:
        head, _, inside = piece.partition("</node")[0].partition(">")
        if head.endswith("/") or "<remap" not in inside:
            continue
        node = _attributes(head)
        program = f"{node.get('pkg', '')}/{node.get('type', '')}"
        words = node.get("args", "").split()
        if program == "nodelet/nodelet" and len(words) > 1 and words[0] in _LOADING:
            program = words[1]
        for remap in map(_attributes, inside.split("<remap")[1:]):
            if "from" in remap and "to" in remap:
                found.add(f"{program}\t{remap['from']}\t{remap['to']}")
    return sorted(found)


def _without_comments(text: str) -> str:
    kept = []
    first, *others = text.split("<!--")
    for piece in others:
        _, end, after = piece.partition("-->")
        kept.append(after if end else "")
    return "".join((first, *kept))


def _attributes(text: str) -> Mapping[str, str]:
    """Those in the tag that ``text`` begins in."""
    return {name: one or other for name, one, other in _ATTRIBUTE.findall(text[:_LONGEST_TAG].partition(">")[0])}


def _lifecycle(text: str) -> Sequence[str]:
    """The names in a text that takes lifecycle nodes of ROS 2 from one state to the next, or says how people do; ``*`` where it may be any.

    They stand in the same line as a command, in a list where there is a lifecycle manager, and in quotes where the states are changed.
    """
    if not _MANAGES.search(text):
        return ()
    found = {name for line in text.split("\n") if "lifecycle" in line for name in _NODE_NAME.findall(line[:_LONGEST_LINE])}
    for listed in _LISTED.findall(text):
        found.update(name for each in listed for name in _NODE_NAME.findall(each))
    if _IN_CODE.search(text):
        found.update(_QUOTED.findall(text))
    return sorted({*found, *(("*",) if _MANAGES_ANY.search(text) else ())})


def _distributions(text: str) -> Sequence[str]:
    """The distributions of ROS 2 that a text says it is for; what links to documents hold is none.

    Nor is one for which it sends its readers to another branch, where it names others: these are what this branch is for.
    """
    small = text.lower()
    if not _DISTRIBUTION.search(small):
        return ()
    found = {name.lower() for name in _PROPER.findall(text)}
    elsewhere: set[str] = set()
    for line in small.split("\n"):
        if _DISTRIBUTION.search(line):
            line = _DOCUMENTS.sub("", line)[:_LONGEST_LINE]
            listed = _DISTRIBUTION.findall(line)
            if _SEVERAL.search(line) or _OF_ROS.search(line) or any(cell.strip(_AROUND) in listed for cell in line.split("|")):
                (elsewhere if _OTHER_BRANCH.search(line) else found).update(listed)
    return sorted(found or elsewhere)


def _variables(text: str) -> Sequence[str]:
    """The environment variables that a launch file reads: after ``!`` those without a default, after ``+`` those of them that are read
    again, comments left out, after ``?`` those with a default.
    """
    if "env" not in text:
        return ()
    read = set(_ENV.findall(text))
    again = {name for name, times in Counter(_ENV.findall(_COMMENT.sub("", text))).items() if times > 1} if read else set()
    optional = {one or other for one, other in _OPTIONAL.findall(text)}
    return sorted(kind + name for kind, names in (("!", read), ("+", again), ("?", optional)) for name in names)


def _machines(text: str) -> Sequence[str]:
    """The names of the machines that a launch file defines, without those that are computed."""
    return sorted({name.strip() for name in _MACHINE.findall(text)})


PARTS: Mapping[str, Callable[[str], Sequence[str]]] = {
    "packages": _packages,
    "writing": _writing,
    "args": _args,
    "topics": _topics,
    "remaps": _remaps,
    "lifecycle": _lifecycle,
    "distributions": _distributions,
    GIVEN: given_args.elsewhere,
    GIVEN_IN_LAUNCH: given_args.in_launch_file,
    "variables": _variables,
    "machines": _machines,
}
"""What of a text something may hang on, where it does not hang on all of it: a change of the rest changes nothing."""
_LONG = frozenset(("writing",))
"""Parts that may be all of a text: only their states are kept."""


def part_of(file: str, part: str, held: Contents | None = None) -> Sequence[str]:
    """The ``part`` of the text of ``file`` (absolute); nothing where it cannot be read. What it hangs on is not noted.

    ``held`` may know what the file holds.
    """
    try:
        return _part(read_bytes(file), part) if held is None or part in _LONG else _known(file, part, held)
    except (OSError, ValueError):
        return ()


def _known(file: str, part: str, held: Contents) -> list[str]:
    return held.fact(file, f"lines {part}", lambda data: list(_part(data, part)), list, _texts)


def _texts(known: Sequence[str]) -> list[str]:
    """What was kept. Raises TypeError where it is nothing of that kind."""
    if not isinstance(known, list) or not all(isinstance(each, str) for each in known):
        raise TypeError
    return known


def part_state(data: bytes, part: str) -> str:
    """Equal for texts of which the ``part`` is the same; ``data`` is what the file holds."""
    return _state(_part(data, part))


def known_state(file: str, part: str, held: Contents) -> str:
    """As :func:`part_state`, of what ``held`` knows of a file (absolute). Raises OSError where it cannot be read."""
    if part in _LONG:
        return held.fact(file, f"part {part}", lambda data: part_state(data, part), str, str)
    lines = _known(file, part, held)
    return _state(lines) if lines else _nothing()


@cache
def _nothing() -> str:
    return _state(())


def _state(lines: Sequence[str]) -> str:
    from hashlib import sha1

    return f"part {sha1(chr(0).join(lines).encode('utf-8', 'surrogateescape'), usedforsecurity=False).hexdigest()}"


def _part(data: bytes, part: str) -> Sequence[str]:
    return PARTS[part](data[:LARGEST].decode("utf-8", "replace"))
