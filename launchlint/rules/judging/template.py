"""Placeholders: what a generator fills in before anybody launches the file, and what each user is asked to fill in."""

from __future__ import annotations

import posixpath
import re

from launchlint.late import late

FILLED_IN = "it looks like a template that is filled in before anybody launches it"
"""What a finding says of a file that holds something to be replaced."""
_PLACEHOLDER = late(
    r"""\[[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+\]              # of MoveIt's Setup Assistant
    | (?<![^\W_])__[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)*__(?![^\W_]) | @[A-Za-z]\w*@
    | \{\{-?\s*\w[^{}\n]{0,100}\}\} | \{%-?\s*[a-z][^%\n]{0,200}%\}    # of Jinja
    | ["'/)\s]<(?:[Yy]our|[Mm]y|[Tt]he|[Ss]ome|YOUR|MY|THE|SOME)[ _-][\w -]+> | ="<[A-Za-z][\w -]*>"
    """,
    re.VERBOSE,
)
_TO_FILL_IN = late(
    r"""\s*(?:
        <[^<>]+> | \[[A-Za-z][\w -]*\] | \{\{[^{}]+\}\}         # in brackets, as a whole
        | your[ _-]\w.* | .*\s(?:goes|comes)?\s?here
        | (?:enter|insert|put|fill[ ]in|replace|specify)[ _-]\w.*
        | change[ _-]?me | replace[ _-]?me | fill[ _-]?me(?:[ _-]?in)? | todo\b.* | fixme\b.* | tbd | x{3,} | \?{2,}
    )\s*""",
    re.VERBOSE | re.IGNORECASE,
)
_LONGEST = 200
_ASKS = late(
    r"\A\W{0,20}(?:please\s+)?(?:add|enter|insert|put(?:\s+in)?|fill\s+in|replace|specify|change|choose|select|give)\s+(?:here\s+)?(?:(?:the|your|an?|this)\s+)?",
    re.IGNORECASE,
)
_LETTERS = late(r"[a-z]+")
_PATH_TO_FILL_IN = late(
    r"""(?:^|/)(?:path[/_]to[/_] | your[_-]?\w+/ | <[^<>/]+>(?:/|$) | \{[A-Z][A-Z\d]*(?:_[A-Z\d]+)*\}(?:[./]|$))
    | /(?:home|Users)/user_?name/
    | /home/livox/                                           # in Livox's own launch files""",
    re.VERBOSE | re.IGNORECASE,
)


def has_placeholder(text: str) -> bool:
    """Whether ``text`` holds something that a tool or a reader replaces: ``[ROBOT_NAME]``, as in what MoveIt's Setup Assistant starts from,
    ``__robot__``, ``@ROBOT@`` of CMake, ``{{ robot }}`` and ``{% if robot %}`` of Jinja, ``<your-robot>``.
    """
    return _PLACEHOLDER.search(text) is not None


def is_called_template(path: str) -> bool:
    """Whether a launch file is called a template: people copy it, and start the copy."""
    return "template" in _LETTERS.findall(posixpath.basename(path).lower())


def is_among_templates(directory: str) -> bool:
    """Whether ``directory`` lies in a folder of templates: what stands there is copied before anybody launches it."""
    return any(part == "template" or _LETTERS.findall(part)[-1:] == ["templates"] for part in directory.lower().split("/"))


def is_template(path: str) -> bool:
    """Whether a launch file is called a template, or lies among such."""
    return is_called_template(path) or is_among_templates(posixpath.dirname(path))


def is_to_fill_in(value: str) -> bool:
    """Whether ``value`` as a whole asks its reader for another: ``your app id here``, ``<id>``, ``CHANGEME``, ``xxx``.

    Only for values that are no good as they are: a name or a text may read like that and be meant.
    """
    return len(value) <= _LONGEST and _TO_FILL_IN.fullmatch(value) is not None


def asks_for(comment: str, name: str) -> bool:
    """Whether a comment asks its reader to put something in the place of ``name``: ``Add waypoints file (…)`` of ``waypoints file``."""
    asked = _ASKS.match(comment)
    return bool(name) and asked is not None and comment[asked.end() : asked.end() + _LONGEST].lower().startswith(name.lower())


def is_path_to_fill_in(path: str) -> bool:
    """Whether ``path`` asks its reader for another: ``/path/to/map.yaml``, ``/home/username/…``, ``your_package/…``."""
    return _PATH_TO_FILL_IN.search(path[:_LONGEST]) is not None
