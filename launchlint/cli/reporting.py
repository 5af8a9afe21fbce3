"""What ``launchlint report`` does: survey the entry files, compare them with a revision, make the page, write it."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from pathlib import Path

from launchlint import __version__
from launchlint.check.causes import told_with_theirs
from launchlint.check.file import INTERNAL_ERROR
from launchlint.check.graphs import Revision, revision
from launchlint.check.merge import Outcome, merge, without_parts
from launchlint.check.options import EntryRequest, Options
from launchlint.check.run import default_directory
from launchlint.check.survey import Surveyed, Surveyor, survey_entries
from launchlint.cli.entries import parse_severity, tell
from launchlint.cli.since import Since, since
from launchlint.errors import UsageError
from launchlint.finding import Severity
from launchlint.fingerprint import fingerprints
from launchlint.named_tuple import NamedTuple
from launchlint.project.asked import EntryOptions, leave_others_out
from launchlint.project.material import (
    base_only,
    beside_base,
    entry_materials,
    known_programs,
    learnable,
    probe_command,
    reader,
    roots,
    source_prefix,
    usual_title,
)
from launchlint.report.html.material import EntryMaterial, Material
from launchlint.report.text import summary

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class ReportOptions(NamedTuple):
    """The options of ``report`` that are not about entries, as written."""

    output: str = "report.html"
    separate_assets: bool = False
    source_url: str | None = None
    base: str | None = None
    title: str | None = None
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    severity: tuple[str, ...] = ()
    fail_on: str | None = None
    jobs: int = 0
    quiet: bool = False
    picture: str | None = None


def run_report(entry: EntryOptions, given: ReportOptions) -> int:
    """Write the page. Returns the exit status; raises LaunchlintError."""
    from launchlint.atomic import check_target
    from launchlint.project.selection import per_file_ignores

    threshold = None if given.fail_on is None else parse_severity(given.fail_on, "--fail-on")
    if given.separate_assets and given.output == "-":
        raise UsageError("--separate-assets writes files beside the page; name the page with -o")
    if given.output != "-":
        check_target(given.output, what="the page")
    if given.picture is not None:
        if not given.picture.endswith((".svg", ".png")):
            raise UsageError(f"--picture {given.picture}: a picture is an .svg or a .png file")
        check_target(given.picture, what="the picture")
    prefix = source_prefix(given.source_url)
    options = entry.options(select=given.select, ignore=given.ignore, severity=given.severity, cache=default_directory())
    per_file = per_file_ignores(entry.configuration, options.root)
    requests, overlay = entry.requests()
    surveyor = Surveyor(options, overlay)
    if options.library:
        _ = surveyor.library  # an unusable one is told before any work is done
    requests, notices = leave_others_out(entry, requests, surveyor.session)
    surveyed = _survey(requests, surveyor, given)
    with nullcontext() if given.base is None else revision(options, given.base) as old:
        befores: list[Any] = [None] * len(surveyed)
        plain = surveyed
        if old is not None and given.base is not None:
            surveyed, befores = beside_base(surveyed, surveyor, old, given.base)
        results = [each.result for each in surveyed]
        outcome = merge(results, options, surveyor.packages, per_file, asked=entry.paths)
        told = told_with_theirs(outcome.findings)
        outcome = outcome._replace(findings=tuple(each.finding for each in told))
        kept = {id(result) for result in without_parts(results)}
        pairs = [(each, before) for each, before in zip(surveyed, befores, strict=True) if id(each.result) in kept]
        entries = entry_materials(told, pairs, surveyor.packages)
        changed = Since()
        if old is not None:
            gone = base_only(entry, requests, old)
            entries += [each for each, _ in gone]
            changed = since(plain, [request for _, request in gone], surveyor, old, told, per_file, entry.paths)
            entries = [
                each._replace(verdict_before=changed.verdicts.get(each.path), fixed=changed.fixed_in.get(each.path, ())) for each in entries
            ]
        material = _material(entry, given, options, surveyor, outcome, entries, old)
        material = material._replace(source_url=prefix, notices=notices, new=changed.new, fixed=changed.fixed)
        _write(material, given)
    if not given.quiet:
        for notice in notices:
            tell(notice)
        if given.output != "-":
            tell(f"wrote {given.output}: {summary(outcome.findings, _run(outcome))}")
    return _status(outcome, threshold)


def _survey(requests: Sequence[EntryRequest], surveyor: Surveyor, given: ReportOptions) -> list[Surveyed]:
    bar = reading = None
    if surveyor.options.extract and not given.quiet and sys.stderr.isatty():
        from launchlint.cli.progress import LateBar

        reading = LateBar("programs read")
    if not given.quiet and len(requests) > 1 and sys.stderr.isatty():
        from launchlint.cli.progress import ProgressBar

        bar = ProgressBar(len(requests))
    try:
        return survey_entries(
            requests,
            surveyor,
            jobs=given.jobs,
            progress=None if bar is None else bar.show,
            reading=None if reading is None else reading.show,
        )
    finally:
        for each in (bar, reading):
            if each is not None:
                each.clear()


def _material(
    entry: EntryOptions, given: ReportOptions, options: Options, surveyor: Surveyor, outcome: Outcome, entries: list[EntryMaterial],
    old: Revision | None,
) -> Material:  # fmt: skip
    programs, left_out = known_programs(entries, surveyor.library, options)
    return Material(
        title=given.title or usual_title(entry),
        version=__version__,
        roots=roots(options, old),
        source_url="",
        base=given.base or "",
        findings=fingerprints(outcome.findings),
        entries=entries,
        source=reader(surveyor),
        base_source=reader(surveyor if old is None else old.checker),
        programs=programs,
        learn=learnable(entries, surveyor.packages),
        left_out=left_out,
        sight=outcome.sight,
        probe=probe_command(entry.paths),
    )


def _write(material: Material, given: ReportOptions) -> None:
    from launchlint.atomic import check_target, write_text
    from launchlint.report.formats import emit
    from launchlint.report.html.cards import groups
    from launchlint.report.html.data import in_order, report_data
    from launchlint.report.html.late import mark_late
    from launchlint.report.html.page import render

    name = os.path.splitext(os.path.basename(given.output))[0] if given.separate_assets else ""
    data, entries = report_data(material), in_order(material)
    mark_late(data, _former(given.output))
    if given.picture is not None:
        _write_picture(given.picture, data, entries)
    page = render(data, groups(data, entries), separate=name)
    if given.output == "-":
        emit(page.html, sys.stdout)
        return
    beside = {os.path.join(os.path.dirname(given.output), asset): text for asset, text in page.assets.items()}
    for file in beside:
        check_target(file, what="a part of the page")
    for file, text in beside.items():
        write_text(file, text, what="a part of the page")
    write_text(given.output, page.html, what="the page")


def _former(output: str) -> str:
    """The page that stands where the new one goes; empty where there is none that can be read."""
    try:
        return Path(output).read_text(encoding="utf-8") if Path(output).is_file() else ""
    except (OSError, ValueError):
        return ""


def _write_picture(file: str, data: Mapping[str, Any], entries: Sequence[EntryMaterial]) -> None:
    from launchlint.atomic import write_bytes, write_text
    from launchlint.report.picture.change import picture

    drawn = picture(data, entries)
    if file.endswith(".png"):
        from launchlint.report.picture.browser import png

        write_bytes(file, png(drawn), what="the picture")
    else:
        write_text(file, drawn, what="the picture")


def _run(outcome: Outcome) -> Any:
    from launchlint.report.run import Run

    return Run(__version__, files_checked=outcome.files, verbose=True, verdicts=outcome.verdicts, sight=outcome.sight)


def _status(outcome: Outcome, threshold: Severity | None) -> int:
    if any(finding.rule == INTERNAL_ERROR for finding in outcome.findings):
        return 2
    return int(threshold is not None and any(finding.severity >= threshold for finding in outcome.findings))
