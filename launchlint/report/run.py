"""What a report needs to know besides the findings."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Mapping, Sequence

from launchlint.finding import Severity
from launchlint.named_tuple import NamedTuple
from launchlint.sight import NOTHING, Sight
from launchlint.verdict import Verdict

_LARGEST = 100_000_000
"""Bytes of the largest file that is read again for a report."""


class RuleMetadata(NamedTuple):
    """A rule as SARIF describes it: ``summary`` is one sentence, ``help_text`` and ``help_markdown`` are the whole page.

    ``precision`` is one of SARIF's words: ``very-high``, ``high``, ``medium`` or ``low``.
    """

    id: str
    name: str
    severity: Severity
    summary: str
    help_text: str
    help_markdown: str
    help_uri: str
    tags: tuple[str, ...] = ()
    precision: str = "very-high"


def no_rules() -> Mapping[str, RuleMetadata]:
    """Metadata of no rule at all."""
    return {}


def nothing(path: str) -> bytes | None:
    """The content of no file at all."""
    return None


class Run(NamedTuple):
    """One run of launchlint.

    ``rules`` gives the metadata of all rules by ID; it is a function because loading the pages takes time and only SARIF needs them.
    ``files_checked``: launch files looked at. ``entries_checked``: of these, how many were evaluated as entry files. ``color``: with ANSI
    colours. ``verbose``: show infos too. ``width``: columns of the terminal; longer source lines are cut around the caret. ``fail_on``:
    the severity from which the run fails, ``None`` for never. ``root``: absolute path of the directory that relative paths of findings
    start from. ``home``: the address of launchlint's own page, if any. ``notices``: things told about the run as a whole. ``successful``:
    false where a rule crashed. ``read``: the bytes of a file, by the path findings have, or ``None``; only SARIF asks for them (GitHub's
    fingerprint is made from the text around the line), :func:`files_below` is the usual one. ``verdicts``: what roslaunch makes of each
    entry file; none where only some rules were asked for. ``sight``: of how many nodes it is known what they do.
    """

    version: str
    rules: Callable[[], Mapping[str, RuleMetadata]] = no_rules
    files_checked: int = 0
    entries_checked: int = 0
    color: bool = False
    verbose: bool = False
    width: int = 120
    fail_on: Severity | None = Severity.ERROR
    root: str = "/"
    home: str = ""
    notices: tuple[str, ...] = ()
    successful: bool = True
    read: Callable[[str], bytes | None] = nothing
    verdicts: Sequence[tuple[str, Verdict]] = ()
    sight: Sight = NOTHING


def files_below(root: str) -> Callable[[str], bytes | None]:
    """A function for :attr:`Run.read` that reads regular files, relative paths starting at ``root``."""

    def read(path: str) -> bytes | None:
        try:
            file = os.path.join(root, path)
            status = os.stat(file)
            if not stat.S_ISREG(status.st_mode) or status.st_size > _LARGEST:
                return None
            with open(file, "rb") as opened:
                return opened.read(_LARGEST)
        except (OSError, ValueError):
            return None

    return read
