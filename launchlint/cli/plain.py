"""The options of ``check`` and ``report`` that are read without click, which takes longer to import than to check a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.cli.checking import CheckOptions
from launchlint.project.asked import EntryOptions

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.cli.reporting import ReportOptions

_BOTH_FLAGS = {"-q": "quiet", "--quiet": "quiet", "--no-extract": "no_extract"}
_BOTH_REPEATED = {"--select": "select", "--ignore": "ignore", "--severity": "severity"}
_BOTH_ONCE = {"--fail-on": "fail_on", "--jobs": "jobs"}
_CHECK_FLAGS = {
    **_BOTH_FLAGS,
    "-v": "verbose",
    "--verbose": "verbose",
    "--no-cache": "no_cache",
    "--exit-zero": "exit_zero",
    "--statistics": "statistics",
    "--staged": "staged",
    "--changed": "changed",
}
_CHECK_REPEATED = {**_BOTH_REPEATED, "--format": "formats"}
_CHECK_ONCE = {**_BOTH_ONCE, "--baseline": "baseline"}
_REPORT_FLAGS = {**_BOTH_FLAGS, "--separate-assets": "separate_assets"}
_REPORT_ONCE = {
    **_BOTH_ONCE,
    "-o": "output",
    "--output": "output",
    "--picture": "picture",
    "--source-url": "source_url",
    "--base": "base",
    "--title": "title",
}


def plain_check(words: Sequence[str]) -> tuple[EntryOptions, CheckOptions] | None:
    """What ``words`` say to ``check``, where they are paths and the commonest options; None where they have to be read by click.

    Raises LaunchlintError.
    """
    read = _read(words, _CHECK_FLAGS, _CHECK_REPEATED, _CHECK_ONCE)
    return None if read is None else (read[0], CheckOptions(**read[1]))


def plain_report(words: Sequence[str]) -> tuple[EntryOptions, ReportOptions] | None:
    """What ``words`` say to ``report``, as :func:`plain_check`."""
    from launchlint.cli.reporting import ReportOptions

    read = _read(words, _REPORT_FLAGS, _BOTH_REPEATED, _REPORT_ONCE)
    return None if read is None else (read[0], ReportOptions(**read[1]))


def _read(
    words: Sequence[str], flags: Mapping[str, str], repeated: Mapping[str, str], once: Mapping[str, str]
) -> tuple[EntryOptions, dict[str, Any]] | None:
    """What is asked for, and the other options by the names of their fields; None where ``words`` say anything else."""
    paths: list[str] = []
    given: dict[str, Any] = {}
    rest = iter(words)
    for word in rest:
        if not word.startswith("-"):
            paths.append(word)
            continue
        if word in flags:
            given[flags[word]] = True
            continue
        option, equals, value = word.partition("=")
        if not equals:
            value = next(rest, "")
        if not value or value.startswith("-") or (equals and not option.startswith("--")):
            return None
        if option in repeated:
            name = repeated[option]
            given[name] = (*given.get(name, ()), value)
        elif option in once:
            given[once[option]] = value
        else:
            return None
    jobs = given.pop("jobs", "0")
    if not (jobs.isascii() and jobs.isdecimal()):
        return None
    extract = not given.pop("no_extract", False)
    return EntryOptions(tuple(paths), extract=extract), {"jobs": int(jobs), **given}
