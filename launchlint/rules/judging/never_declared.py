"""What several rules tell of from their sides: an arg is read under a name that nothing declares, and declared under one nothing reads."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.finding import Finding
from launchlint.plural import listed
from launchlint.rules.judging.joined import joined
from launchlint.rules.wording import words_of

_MOST_NAMED = 6


def never_declared(path: str, name: str = "") -> str:
    """The cause that LL201, LL206, LL914 and LL919 share: the launch file at ``path`` reads the arg ``name``, and does not declare it.

    Without ``name``: it reads several, which all come from those who include it.
    """
    return f"undeclared {path} {name}"


def all_undeclared(findings: Sequence[Finding]) -> Finding:
    """What one file reads and does not declare, by the names of the args: their findings have them as topics."""
    told = joined(findings)
    names = list(dict.fromkeys(each.topic for each in findings if each.topic))
    if len(names) < 2:
        return told
    return told._replace(
        message=f"{listed(names, _MOST_NAMED)} are not declared in {told.location.path}:"
        " only what includes it, or the command line, can give them",
        help=f"declare them: {words_of(told.location.path).declared(names[0])} …, and pass them in the include",
    )
