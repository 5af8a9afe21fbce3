"""Known findings, kept in a file, so that only new ones are told.

The file is JSON: for each fingerprint (:mod:`launchlint.fingerprint`) how many findings have it, with rule and path for the people who
read the diff. It has no line numbers, so that editing other lines of a file changes nothing.
"""

from __future__ import annotations

import json
import os
import re
import stat
from collections.abc import Iterable
from typing import Any

from launchlint.atomic import write_text
from launchlint.errors import ConfigurationError
from launchlint.finding import Finding
from launchlint.fingerprint import fingerprint
from launchlint.named_tuple import NamedTuple
from launchlint.order import ordered

_VERSION = 1
_LARGEST = 100_000_000
_FINGERPRINT = re.compile(r"[0-9a-f]{64}")


class Baseline(NamedTuple):
    """How many findings of each fingerprint are known."""

    counts: dict[str, int]


def write(path: str, findings: Iterable[Finding]) -> None:
    """Write all ``findings`` to the baseline file ``path``, the whole file or nothing.

    The same findings in any order give the same bytes. Raises :class:`~launchlint.errors.UsageError` where it cannot be written.
    """
    entries: dict[str, tuple[str, str, str]] = {}
    counts: dict[str, int] = {}
    for finding in findings:
        mark = fingerprint(finding)
        entries[mark] = (finding.location.path, finding.rule, finding.name)
        counts[mark] = counts.get(mark, 0) + 1
    lines = [
        json.dumps({"path": where, "rule": rule, "name": name, "fingerprint": mark, "count": counts[mark]})
        for mark, (where, rule, name) in sorted(entries.items(), key=lambda item: (item[1], item[0]))
    ]
    body = "[\n    " + ",\n    ".join(lines) + "\n  ]" if lines else "[]"
    write_text(path, f'{{\n  "version": {_VERSION},\n  "findings": {body}\n}}\n', what="the baseline")


def load(path: str) -> Baseline:
    """Read the baseline file ``path``. Raises :class:`ConfigurationError` where it cannot be read or is not what :func:`write` makes."""
    try:
        document = json.loads(_text(path))
    except json.JSONDecodeError as error:
        raise ConfigurationError(
            f"{path}:{error.lineno}:{error.colno}: this baseline is no JSON: {error.msg}; --write-baseline makes a new one"
        ) from error
    except (ValueError, RecursionError) as error:  # a number with thousands of digits, brackets nested thousands deep
        raise ConfigurationError(f"{path}: this baseline cannot be read as JSON: {error}; --write-baseline makes a new one") from error
    if not isinstance(document, dict) or not isinstance(document.get("findings"), list):
        raise ConfigurationError(f'{path}: this is no baseline: it has no list "findings"; --write-baseline makes a new one')
    if type(document.get("version")) is not int or document["version"] != _VERSION:
        raise ConfigurationError(
            f"{path}: this baseline has version {_shown(document.get('version'))}, not {_VERSION}; --write-baseline makes a new one"
        )
    counts: dict[str, int] = {}
    for number, entry in enumerate(document["findings"], 1):
        mark, count = _entry(path, number, entry)
        counts[mark] = counts.get(mark, 0) + count
    return Baseline(counts)


def filter(findings: Iterable[Finding], baseline: Baseline) -> list[Finding]:
    """The findings that ``baseline`` does not know, in report order.

    Of several with one fingerprint, the first ones of the file count as known.
    """
    left = dict(baseline.counts)
    new: list[Finding] = []
    for finding in ordered(findings):
        mark = fingerprint(finding)
        if left.get(mark, 0) > 0:
            left[mark] -= 1
        else:
            new.append(finding)
    return new


def _text(path: str) -> str:
    try:
        status = os.stat(path)
        if not stat.S_ISREG(status.st_mode):
            raise ConfigurationError(f"{path}: the baseline must be a file")
        if status.st_size > _LARGEST:
            raise ConfigurationError(f"{path}: the baseline is too large ({status.st_size:,} bytes; {_LARGEST:,} are allowed)")
        with open(path, encoding="utf-8-sig") as file:
            return file.read()
    except FileNotFoundError as error:
        raise ConfigurationError(f"{path}: there is no such baseline file; --write-baseline makes one") from error
    except OSError as error:
        raise ConfigurationError(f"{path}: the baseline cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise ConfigurationError(f"{path}: the baseline is no UTF-8 text (byte {error.start}); --write-baseline makes a new one") from error
    except ValueError as error:  # a null byte in the name
        raise ConfigurationError(f"{path!r}: this is no name of a file") from error


def _entry(path: str, number: int, entry: Any) -> tuple[str, int]:
    mark = entry.get("fingerprint") if isinstance(entry, dict) else None
    if not isinstance(mark, str) or not _FINGERPRINT.fullmatch(mark):
        raise ConfigurationError(f"{path}: finding {number} of this baseline has no fingerprint of 64 hexadecimal digits")
    count = entry.get("count", 1)
    if type(count) is not int or count < 1:
        raise ConfigurationError(
            f"{path}: finding {number} of this baseline has the count {_shown(count)}; a count is a whole number from 1"
        )
    return mark, count


def _shown(value: Any) -> str:
    text = json.dumps(value)
    return text if len(text) <= 40 else f"{text[:40]} …"
