"""``check --base``: what the connections of each entry file have lost since another revision."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.file import run_rule
from launchlint.check.graphs import graphs_of, revision
from launchlint.finding import Finding, Key
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
    if not rules:
        return list(results)
    compared: list[EntryResult] = []
    with revision(checker.options, base) as old:
        there = old.requests([result.request for result in results])
        for result in results:
            request = there.get(result.request.at)
            if request is None:
                compared.append(result)
                continue
            after = tuple(graphs_of(checker, result.request, every_configuration=True))
            before = tuple(graphs_of(old.checker, request, every_configuration=True))
            told: dict[Key, Finding] = {}
            # What is lost as the file is started by default, and what is lost however it is started.
            for old_graphs, new_graphs in ((before[:1], after[:1]), (before, after)):
                view = BaseView(base, difference(topology(old_graphs), topology(new_graphs)), new_graphs)
                for finding in _told(rules, view, result):
                    told.setdefault(finding.key, _at_home(finding, result))
            compared.append(result._replace(findings=(*result.findings, *told.values())))
    return compared


def _told(rules: Sequence[Entry], view: BaseView, result: EntryResult) -> Iterator[Finding]:
    for rule in rules:
        yield from (found for found in run_rule(rule, view, result.path) if not isinstance(found, Fine))


def _at_home(finding: Finding, result: EntryResult) -> Finding:
    return finding._replace(entry=result.path, arguments=result.request.arguments, entries=1)
