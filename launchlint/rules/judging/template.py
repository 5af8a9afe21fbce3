"""Placeholders: what a generator fills in before anybody launches the file, and what each user is asked to fill in."""

from __future__ import annotations

import re

from launchlint.late import late

_PLACEHOLDER = late(r"\[[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+\]")
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
_PATH_TO_FILL_IN = late(r"(?:^|/)(?:path[/_]to[/_]|your[_-]?\w+/|<[^<>/]+>(?:/|$))|/(?:home|Users)/user_?name/", re.IGNORECASE)


def has_placeholder(text: str) -> bool:
    """Whether ``text`` holds something like ``[ROBOT_NAME]``, as the templates of the MoveIt setup assistant do."""
    return _PLACEHOLDER.search(text) is not None


def is_to_fill_in(value: str) -> bool:
    """Whether ``value`` as a whole asks its reader for another: ``your app id here``, ``<id>``, ``CHANGEME``, ``xxx``.

    Only for values that are no good as they are: a name or a text may read like that and be meant.
    """
    return len(value) <= _LONGEST and _TO_FILL_IN.fullmatch(value) is not None


def is_path_to_fill_in(path: str) -> bool:
    """Whether ``path`` asks its reader for another: ``/path/to/map.yaml``, ``/home/username/…``, ``your_package/…``."""
    return _PATH_TO_FILL_IN.search(path[:_LONGEST]) is not None
