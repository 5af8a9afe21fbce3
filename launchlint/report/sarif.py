"""Findings as SARIF 2.1.0, as GitHub code scanning reads it."""

from __future__ import annotations

import os
import re
import zlib
from collections.abc import Sequence
from typing import Any
from urllib.parse import quote

from launchlint.finding import Edit, Finding, Fix, Location, Severity
from launchlint.fingerprint import fingerprints
from launchlint.report.escape import no_surrogates, visible
from launchlint.report.json import dump
from launchlint.report.line_hash import line_hashes
from launchlint.report.run import RuleMetadata, Run
from launchlint.report.text import command

_SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"

_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
_PROBLEM_SEVERITIES = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "recommendation"}

_MOST_RESULTS = 25_000
_MOST_BYTES = 10_000_000
"""GitHub refuses a log with more results, or with more bytes after gzip (whose frame is 12 bytes longer than that of zlib)."""
_MOST_RELATED = 100
_MOST_STEPS = 100


def render(findings: Sequence[Finding], run: Run) -> str:
    """The SARIF log; where GitHub would refuse it for its size, the most severe findings that fit, and a notification that says so."""
    marked = fingerprints(findings)
    keep = min(len(marked), _MOST_RESULTS)
    while True:
        log = _log(marked, keep, run)
        size = len(log)  # all of it is ASCII
        if size > _MOST_BYTES:
            size = len(zlib.compress(log.encode("ascii"))) + 12
        if size <= _MOST_BYTES or keep == 0:
            return log
        keep = min(keep - 1, keep * _MOST_BYTES * 9 // (size * 10))


def _log(marked: Sequence[tuple[Finding, str]], keep: int, run: Run) -> str:
    import sarif_om

    notifications = [_notification(notice, "note") for notice in run.notices]
    if keep < len(marked):
        left_out = f"{len(marked) - keep} of {len(marked)} findings are left out, the least severe first: GitHub takes no larger log"
        notifications.append(_notification(left_out, "warning"))
        best = sorted(range(len(marked)), key=lambda number: (-int(marked[number][0].severity), number))[:keep]
        marked = [marked[number] for number in sorted(best)]
    metadata = dict(run.rules())
    for finding, _ in marked:
        metadata.setdefault(finding.rule, RuleMetadata(finding.rule, finding.name, finding.severity, finding.name, finding.name, "", ""))
    ids = sorted(metadata)
    index = {rule: number for number, rule in enumerate(ids)}
    hashes = _line_hashes([finding for finding, _ in marked], run)
    driver = sarif_om.ToolComponent(
        name="launchlint",
        version=run.version,
        semantic_version=run.version if re.fullmatch(r"\d+\.\d+\.\d+", run.version) else None,
        information_uri=run.home or None,
        rules=[_rule(metadata[rule]) for rule in ids],
    )
    invocation = sarif_om.Invocation(execution_successful=run.successful, tool_execution_notifications=notifications)
    sarif_run = sarif_om.Run(
        tool=sarif_om.Tool(driver=driver),
        automation_details=sarif_om.RunAutomationDetails(id="launchlint/"),
        column_kind="unicodeCodePoints",
        invocations=[invocation],
        original_uri_base_ids={"SRCROOT": sarif_om.ArtifactLocation(uri=_file_uri(run.root.rstrip("/") + "/"))},
        properties=_verdicts(run),
        results=[
            _result(finding, mark, index[finding.rule], hashes.get((finding.location.path, finding.location.line)), run)
            for finding, mark in marked
        ],
    )
    return dump(_plain(sarif_om.SarifLog(version="2.1.0", schema_uri=_SCHEMA, runs=[sarif_run]))) + "\n"


def _plain(value: Any) -> Any:
    """What sarif-om objects are in JSON: names from the attrs metadata, without what has its default (a level is always told)."""
    import attr

    if isinstance(value, str):
        return no_surrogates(value)
    if isinstance(value, dict):
        return {_plain(key): _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if not attr.has(type(value)):
        return value
    result: dict[str, Any] = {}
    for field in attr.fields(type(value)):
        item = getattr(value, field.name)
        if item is None or (item == _default(field) and field.name != "level"):
            continue
        result[field.metadata["schema_property_name"]] = _plain(item)
    return result


def _default(field: Any) -> Any:
    return getattr(field.default, "factory", lambda: field.default)()


def _rule(rule: RuleMetadata) -> Any:
    import sarif_om

    return sarif_om.ReportingDescriptor(
        id=rule.id,
        name=rule.name,
        short_description=sarif_om.MultiformatMessageString(text=_sentence(rule.summary)),
        full_description=sarif_om.MultiformatMessageString(text=_sentence(rule.summary)),
        help=sarif_om.MultiformatMessageString(text=rule.help_text, markdown=rule.help_markdown or None),
        help_uri=rule.help_uri or None,
        default_configuration=sarif_om.ReportingConfiguration(level=_LEVELS[rule.severity]),
        properties={"tags": list(rule.tags), "precision": rule.precision, "problem.severity": _PROBLEM_SEVERITIES[rule.severity]},
    )


def _verdicts(run: Run) -> dict[str, Any] | None:
    """What roslaunch makes of the entry files that it does not load, as they stand or with other args."""
    others = [{"file": visible(file), **verdict.as_object()} for file, verdict in run.verdicts if verdict.notice]
    return {"verdicts": others} if others else None


def _notification(text: str, level: str) -> Any:
    import sarif_om

    return sarif_om.Notification(message=sarif_om.Message(text=visible(text)), level=level)


def _result(finding: Finding, mark: str, rule_index: int, line_hash: str | None, run: Run) -> Any:
    import sarif_om

    prints = {"launchlint/v1": mark}
    if line_hash is not None:
        prints["primaryLocationLineHash"] = line_hash
    related = finding.related[:_MOST_RELATED]
    return sarif_om.Result(
        rule_id=finding.rule,
        rule_index=rule_index,
        level=_LEVELS[finding.severity],
        message=sarif_om.Message(text=_message(finding)),
        locations=[_location(finding.location, run)],
        related_locations=[_location(one.location, run, one.label, number) for number, one in enumerate(related, 1)] or None,
        code_flows=[_code_flow(finding, run)] if finding.chain else None,
        fixes=None if finding.fix is None else [_fix(finding.fix, run)],
        partial_fingerprints=prints,
    )


def _message(finding: Finding) -> str:
    """The message with a link to each related location, then the notes, the command that shows it and the help, one in each line."""
    links = ", ".join(
        f"[{_link_text(related.label or 'see also')}]({number})" for number, related in enumerate(finding.related[:_MOST_RELATED], 1)
    )
    lines = [_no_links(finding.message) + (f" ({links})" if links else "")]
    lines += [_no_links(note) for note in finding.notes]
    if finding.entry:
        lines.append(f"Show it: {_no_links(command(finding))}")
    if finding.help:
        lines.append(f"Help: {_no_links(finding.help)}")
    return "\n".join(_sentence(line) for line in lines)


def _no_links(text: str) -> str:
    """``text`` from outside, which must not become a link (SARIF 2.1.0, 3.11.6)."""
    return visible(text).replace("](", "] (")


def _link_text(text: str) -> str:
    return re.sub(r"([\[\]\\])", r"\\\1", visible(text))


def _sentence(text: str) -> str:
    return text if text.endswith((".", "!", "?")) else f"{text}."


def _location(location: Location, run: Run, message: str = "", number: int = -1) -> Any:
    import sarif_om

    return sarif_om.Location(
        id=number,
        message=sarif_om.Message(text=_sentence(visible(message))) if message else None,
        physical_location=sarif_om.PhysicalLocation(artifact_location=_artifact(location.path, run), region=_region(location)),
    )


def _region(location: Location) -> Any:
    import sarif_om

    return sarif_om.Region(
        start_line=location.line, start_column=location.column, end_line=location.end_line, end_column=location.end_column
    )


def _code_flow(finding: Finding, run: Run) -> Any:
    """From the entry file through the includes to the place of ``finding``."""
    import sarif_om

    steps = [_location(step, run, f"included here, step {number}") for number, step in enumerate(finding.chain[-_MOST_STEPS:], 1)]
    steps.append(_location(finding.location, run, finding.label or finding.message))
    flow = sarif_om.ThreadFlow(locations=[sarif_om.ThreadFlowLocation(location=step) for step in steps])
    return sarif_om.CodeFlow(thread_flows=[flow])


def _fix(fix: Fix, run: Run) -> Any:
    import sarif_om

    files: dict[str, list[Edit]] = {}
    for edit in fix.edits:
        files.setdefault(edit.path, []).append(edit)
    changes = [
        sarif_om.ArtifactChange(
            artifact_location=_artifact(path, run),
            replacements=[
                sarif_om.Replacement(
                    deleted_region=sarif_om.Region(char_offset=edit.start, char_length=edit.end - edit.start),
                    inserted_content=sarif_om.ArtifactContent(text=edit.text),
                )
                for edit in edits
            ],
        )
        for path, edits in files.items()
    ]
    words = f"{fix.message}: {fix.changes}" if fix.changes else fix.message
    return sarif_om.Fix(description=sarif_om.Message(text=_sentence(visible(words))), artifact_changes=changes)


def _artifact(path: str, run: Run) -> Any:
    """A path below the root as a relative URI with ``uriBaseId``, any other as an absolute one."""
    import sarif_om

    full = os.path.normpath(os.path.join(run.root, path))
    relative = os.path.relpath(full, run.root)
    if relative == ".." or relative.startswith("../"):
        return sarif_om.ArtifactLocation(uri=_file_uri(full))
    return sarif_om.ArtifactLocation(uri=_quoted(relative), uri_base_id="SRCROOT")


def _file_uri(path: str) -> str:
    return "file://" + _quoted(path)


def _quoted(path: str) -> str:
    try:
        return quote(path.encode("utf-8", "surrogateescape"))
    except UnicodeEncodeError:
        return quote(path.encode("utf-8", "surrogatepass"))


def _line_hashes(findings: Sequence[Finding], run: Run) -> dict[tuple[str, int], str]:
    """GitHub's fingerprint of the first line of each finding, for the files that can be read."""
    lines: dict[str, set[int]] = {}
    for finding in findings:
        lines.setdefault(finding.location.path, set()).add(finding.location.line)
    result: dict[tuple[str, int], str] = {}
    for path, numbers in lines.items():
        content = run.read(path)
        if content is not None:
            result.update({(path, line): value for line, value in line_hashes(content, numbers).items()})
    return result
