"""Files with placeholders, which a generator fills in before anybody launches them."""

from __future__ import annotations

import re

_PLACEHOLDER = re.compile(r"\[[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+\]")


def has_placeholder(text: str) -> bool:
    """Whether ``text`` holds something like ``[ROBOT_NAME]``, as the templates of the MoveIt setup assistant do."""
    return _PLACEHOLDER.search(text) is not None
