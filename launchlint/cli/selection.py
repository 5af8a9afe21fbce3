"""Which rules run, and how severe they are, from the command line and the configuration file."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from launchlint.errors import ConfigurationError, LaunchlintError, UsageError
from launchlint.finding import Severity
from launchlint.rules.registry import RULES, Entry, find
from launchlint.spelling import did_you_mean

if TYPE_CHECKING:
    from launchlint.workspace.configuration import Configuration


def selected_rules(
    select: tuple[str, ...], ignore: tuple[str, ...], configuration: Configuration, *, everything: bool = False
) -> frozenset[str]:
    """IDs of the rules that run: those selected (default: all that are on by default), less those ignored.

    A word is an ID, a name, the start of an ID (``LL3``) or ``all``. Raises UsageError or ConfigurationError for a word that fits none.
    """
    if everything:
        return frozenset(rule.id for rule in RULES)
    chosen = select or configuration.select
    rules = {rule.id for rule in RULES if rule.default}
    if chosen is not None:
        rules = _matching(chosen, configuration, "select", from_file=not select)
    rules -= _matching(ignore, configuration, "ignore", from_file=False)
    rules -= _matching(configuration.ignore, configuration, "ignore", from_file=True)
    return frozenset(rules)


def severities(given: tuple[str, ...], configuration: Configuration) -> Mapping[str, Severity]:
    """Rule ID → severity as asked for; ``--severity RULE=LEVEL`` goes over the configuration file."""
    chosen: dict[str, Severity] = {}
    for word, level in configuration.severity.items():
        for rule in _matching((word,), configuration, "severity", from_file=True):
            chosen[rule] = Severity[level.upper()]
    for text in given:
        word, separator, level = text.partition("=")
        if not separator or level.lower() not in ("error", "warning", "info"):
            raise UsageError(f"--severity {text}: write RULE=error, RULE=warning or RULE=info")
        for rule in _matching((word,), configuration, "severity", from_file=False):
            chosen[rule] = Severity[level.upper()]
    return chosen


def per_file_ignores(configuration: Configuration) -> Mapping[str, tuple[str, ...]]:
    """Path pattern → IDs of the rules that are off for the files it matches."""
    return {
        pattern: tuple(sorted(_matching(words, configuration, "per-file-ignores", from_file=True)))
        for pattern, words in configuration.per_file_ignores.items()
    }


def _matching(words: Iterable[str], configuration: Configuration, key: str, *, from_file: bool) -> set[str]:
    rules: set[str] = set()
    for word in (part.strip() for text in words for part in text.split(",")):
        if not word:
            continue
        found = _rules(word)
        if not found:
            near = did_you_mean(word.lower(), [rule.name for rule in RULES]) or did_you_mean(word.upper(), [rule.id for rule in RULES])
            hint = near or "launchlint rules lists them all"
            error: type[LaunchlintError] = ConfigurationError if from_file else UsageError
            where = f"{configuration.where(key)}: {key}" if from_file else f"--{key} {word}"
            raise error(f"{where}: there is no rule {word}; {hint}")
        rules.update(rule.id for rule in found)
    return rules


def _rules(word: str) -> list[Entry]:
    if word.lower() == "all":
        return list(RULES)
    rule = find(word)
    if rule is not None:
        return [rule]
    prefix = word.upper()
    return [rule for rule in RULES if len(prefix) > 2 and prefix.startswith("LL") and rule.id.startswith(prefix)]
