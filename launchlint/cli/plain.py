"""The options of ``check`` that are read without click, which takes longer to import than to check a file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from launchlint.cli.checking import CheckOptions
from launchlint.project.asked import EntryOptions

_FLAGS = {
    "-q": "quiet",
    "--quiet": "quiet",
    "-v": "verbose",
    "--verbose": "verbose",
    "--no-cache": "no_cache",
    "--no-extract": "no_extract",
    "--exit-zero": "exit_zero",
    "--statistics": "statistics",
    "--staged": "staged",
    "--changed": "changed",
}
_REPEATED = {"--select": "select", "--ignore": "ignore", "--severity": "severity", "--format": "formats"}
_ONCE = {"--fail-on": "fail_on", "--baseline": "baseline", "--jobs": "jobs"}


def plain_check(words: Sequence[str]) -> tuple[EntryOptions, CheckOptions] | None:
    """What ``words`` say, where they are paths and the commonest options; None where they have to be read by click.

    Raises LaunchlintError.
    """
    paths: list[str] = []
    given: dict[str, Any] = {}
    rest = iter(words)
    for word in rest:
        if not word.startswith("-"):
            paths.append(word)
            continue
        if word in _FLAGS:
            given[_FLAGS[word]] = True
            continue
        option, equals, value = word.partition("=")
        if not equals:
            value = next(rest, "")
        if not value or value.startswith("-"):
            return None
        if option in _REPEATED:
            name = _REPEATED[option]
            given[name] = (*given.get(name, ()), value)
        elif option in _ONCE:
            given[_ONCE[option]] = value
        else:
            return None
    jobs = given.pop("jobs", "0")
    if not (jobs.isascii() and jobs.isdecimal()):
        return None
    extract = not given.pop("no_extract", False)
    return EntryOptions(tuple(paths), extract=extract), CheckOptions(jobs=int(jobs), **given)
