"""The output formats by name, and where their output goes."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib import import_module

from launchlint.atomic import write_text
from launchlint.errors import UsageError
from launchlint.finding import Finding
from launchlint.named_tuple import NamedTuple
from launchlint.report.run import Run
from launchlint.spelling import did_you_mean

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TextIO

FORMATS = {
    "text": "launchlint.report.text",
    "concise": "launchlint.report.concise",
    "json": "launchlint.report.json",
    "jsonl": "launchlint.report.jsonl",
    "sarif": "launchlint.report.sarif",
    "github": "launchlint.report.github",
    "gitlab": "launchlint.report.gitlab",
    "junit": "launchlint.report.junit",
    "markdown": "launchlint.report.markdown",
}
"""Name of a format: the module whose ``render(findings, run)`` makes it. Modules are imported when first needed."""


class Output(NamedTuple):
    """One ``--format F[:FILE]``: ``file`` is ``None`` for standard output."""

    format: str
    file: str | None


def parse(format_spec: str) -> Output:
    """``F`` or ``F:FILE``. Raises :class:`UsageError` for a format that does not exist and for an empty file name."""
    name, colon, file = format_spec.partition(":")
    if name not in FORMATS:
        near = did_you_mean(name, FORMATS)
        raise UsageError(f"there is no format {name!r}: {near or 'the formats are ' + ', '.join(FORMATS)}")
    if colon and not file:
        raise UsageError(f"--format {format_spec}: the name of a file belongs after the colon")
    return Output(name, file if colon and file != "-" else None)


def render(name: str, findings: Sequence[Finding], run: Run) -> str:
    """``findings`` in the format ``name`` (one of :data:`FORMATS`)."""
    text: str = import_module(FORMATS[name]).render(findings, run)
    return text


def write(format_spec: str, findings: Sequence[Finding], run: Run, stream: TextIO | None = None) -> None:
    """Write ``findings`` as ``--format F`` or ``--format F:FILE`` says.

    ``F`` alone goes to ``stream`` (default: standard output). A file is written wholly or not at all, and without colours. Raises
    :class:`UsageError` for an unknown format and where the file cannot be written.
    """
    output = parse(format_spec)
    if output.file is not None:
        write_text(output.file, render(output.format, findings, run._replace(color=False)), what=f"the {output.format} report")
        return
    emit(render(output.format, findings, run), stream or sys.stdout)


def emit(text: str, stream: TextIO) -> None:
    """Write ``text`` to ``stream``; characters that its encoding lacks become escapes, so that any terminal will do."""
    encoding = stream.encoding or "utf-8"
    stream.write(text.encode(encoding, "backslashreplace").decode(encoding))
    stream.flush()
