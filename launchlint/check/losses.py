"""``check --base``: what the connections of each entry file have lost since another revision."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.file import internal_error, run_rule
from launchlint.check.graphs import Revision, graphs_of, revision
from launchlint.finding import Finding
from launchlint.graph.difference import difference
from launchlint.graph.topology import topology
from launchlint.rules.registry import Entry
from launchlint.rules.rule import Fine
from launchlint.rules.view import BaseView


def with_losses(results: Sequence[EntryResult], checker: EntryChecker, base: str) -> list[EntryResult]:
    """``results`` with the findings of the rules that compare with the revision ``base``.

    Raises:
        UsageError: there is no such revision, or no git.
    """
    rules = [rule for rule in checker.rules if rule.view == "base"]
    with revision(checker.options, base) as old:
        return [with_losses_since(result, checker, old, base, rules) for result in results] if rules else list(results)


def with_losses_since(result: EntryResult, checker: EntryChecker, old: Revision, base: str, rules: Sequence[Entry]) -> EntryResult:
    """One result with the findings of ``rules``, which compare with the revision ``base``, unpacked as ``old``."""
    request = old.request(result.request)
    if request is None or not old.differs(checker.options.root, result.launch_files):
        return result
    try:
        after = tuple(graphs_of(checker, result.request))
        before = graphs_of(old.checker, request)
        view = BaseView(base, difference(topology(before), topology(after)), after)
    except Exception as error:  # one file must never take the run down
        return result._replace(findings=(*result.findings, internal_error("the comparison", result.path, error)))
    told: list[Finding] = []
    for rule in rules:
        told.extend(found for found in run_rule(rule, view, result.path) if not isinstance(found, Fine))
    entry, arguments, launcher = result.path, result.request.arguments, result.outcome.launcher
    at_home = (each._replace(entry=entry, arguments=each.arguments or arguments, entries=1, launcher=launcher) for each in told)
    return result._replace(findings=(*result.findings, *at_home))
