"""What several commands say and ask: a line for people, whether to colour, a severity by its word."""

from __future__ import annotations

import os
import sys

from launchlint.errors import UsageError
from launchlint.finding import Severity


def use_color(choice: str) -> bool:
    """Whether to colour: as asked, else as NO_COLOR and FORCE_COLOR say, else where standard output is a terminal."""
    if choice != "auto":
        return choice == "always"
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return sys.stdout.isatty()


def parse_severity(word: str, what: str) -> Severity:
    """``error``, ``warning`` or ``info``. Raises UsageError."""
    try:
        return Severity[word.upper()]
    except KeyError:
        raise UsageError(f"{what}: {word} is no severity; write error, warning or info") from None


def tell(message: str) -> None:
    """One line for people, on standard error."""
    from launchlint.report.escape import visible
    from launchlint.report.formats import emit

    emit(f"launchlint: {visible(message)}\n", sys.stderr)
