"""Which rules run, and how severe they are, from the command line and the configuration file."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from launchlint.check.ignores import PerFileIgnores
from launchlint.errors import ConfigurationError, LaunchlintError, UsageError
from launchlint.finding import Severity
from launchlint.rules.registry import RULES, Entry, find
from launchlint.spelling import did_you_mean

TYPE_CHECKING = False
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
    written = None if configuration.select is None else _written(configuration.select, configuration, "select")
    by_default = {rule.id for rule in RULES if rule.default} if written is None else written
    rules = _given(select, "--select") if select else by_default
    return frozenset(rules - _given(ignore, "--ignore") - _written(configuration.ignore, configuration, "ignore"))


def severities(given: tuple[str, ...], configuration: Configuration) -> Mapping[str, Severity]:
    """Rule ID → severity as asked for; ``--severity RULE=LEVEL`` goes over the configuration file."""
    chosen: dict[str, Severity] = {}
    for word, level in configuration.severity.items():
        for rule in _matching(word, f"{configuration.where('severity', word)}: severity", ConfigurationError):
            chosen[rule] = Severity[level.upper()]
    for text in given:
        word, separator, level = text.partition("=")
        if not separator or level.lower() not in ("error", "warning", "info"):
            raise UsageError(f"--severity {text}: write RULE=error, RULE=warning or RULE=info")
        for rule in _matching(word, f"--severity {text}", UsageError):
            chosen[rule] = Severity[level.upper()]
    return chosen


def per_file_ignores(configuration: Configuration, root: str) -> PerFileIgnores:
    """The rules that are off for some files; ``root`` is what the paths of findings are relative to."""
    rules = {
        pattern: tuple(sorted(_written(words, configuration, "per-file-ignores", pattern)))
        for pattern, words in configuration.per_file_ignores.items()
    }
    return PerFileIgnores(rules, configuration.directory or root, root)


def _given(texts: Iterable[str], option: str) -> set[str]:
    """IDs for the words of an option; commas separate them too."""
    words = [word.strip() for text in texts for word in text.split(",") if word.strip()]
    return {rule for word in words for rule in _matching(word, f"{option} {word}", UsageError)}


def _written(words: Iterable[str], configuration: Configuration, *keys: str) -> set[str]:
    """IDs for the words under a key of the configuration file."""
    return {
        rule
        for number, word in enumerate(words)
        for rule in _matching(word, f"{configuration.where(*keys, number)}: {keys[0]}", ConfigurationError)
    }


def _matching(word: str, where: str, error: type[LaunchlintError]) -> set[str]:
    found = _rules(word)
    if not found:
        near = did_you_mean(word.lower(), [rule.name for rule in RULES]) or did_you_mean(word.upper(), [rule.id for rule in RULES])
        raise error(f"{where}: there is no rule {word}; {near or 'launchlint rules lists them all'}")
    return {rule.id for rule in found}


def _rules(word: str) -> list[Entry]:
    if word.lower() == "all":
        return list(RULES)
    rule = find(word)
    if rule is not None:
        return [rule]
    prefix = word.upper()
    return [rule for rule in RULES if len(prefix) > 2 and prefix.startswith("LL") and rule.id.startswith(prefix)]
