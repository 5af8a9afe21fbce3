"""What two rules tell of from two sides: an arg is read under a name that nothing declares, and declared under one that nothing reads."""

from __future__ import annotations


def never_declared(path: str, name: str) -> str:
    """The cause that LL201 and LL206 share: the launch file at ``path`` reads the arg ``name``, and does not declare it."""
    return f"undeclared {path} {name}"
