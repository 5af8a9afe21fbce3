"""The packages that people copy into their workspaces, told by their names and whose they are.

No index has released many of them: drivers of makers, workspaces of courses, what comes with a paper. The data is ``copied_packages.txt``
beside this module, written by ``scripts/copied_packages.py``: the packages of public projects, and those that several owners have in their
repositories. Of the people it has a mark only, no address.
"""

from __future__ import annotations

import os
from collections.abc import Iterable

from launchlint.workspace.public_packages import PublicPackages

_COPIED = PublicPackages(os.path.join(os.path.dirname(os.path.abspath(__file__)), "copied_packages.txt"))
_LENGTH = 8
_SEVERAL = 3
"""Packages in the list that show that their people are those whose packages are copied: two more may have the name of another one."""


def mark(name: str, people: Iterable[str]) -> str:
    """What stands in the list for the package ``name`` of ``people``, who are addresses in small letters."""
    from hashlib import sha256  # most files are nobody's copy

    return sha256("\n".join((name, *sorted(people))).encode("utf-8", "replace")).hexdigest()[:_LENGTH]


def is_copied(name: str, people: Iterable[str]) -> bool:
    """Whether the package ``name`` of ``people`` is in the list; one of nobody is in none."""
    marks = _COPIED.get(name)
    return marks is not None and mark(name, people) in marks


def are_copied(people: frozenset[str]) -> bool:
    """Whether several packages in the list are of ``people``: then one under another name may be one of these, renamed."""
    if not people:
        return False
    found = 0
    for name, marks in _COPIED.items():
        found += mark(name, people) in marks
        if found >= _SEVERAL:
            return True
    return False
