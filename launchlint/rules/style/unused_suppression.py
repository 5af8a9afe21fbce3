"""A suppression comment suppresses nothing.

Its rule finds nothing there (any more), its rule does not exist, or the comment is malformed or stands where it
covers nothing. It is told of rules that ran only.

## Why it matters

A comment that looks as if it suppressed a mistake, and does not, hides the next mistake of that kind, or leaves one
in place that somebody thought was dealt with.

## Example

```xml
<launch>
  <!-- launchlint: ignore[remap-idenity] shows that the topic keeps its name -->
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="scan" to="scan"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <!-- launchlint: ignore[remap-identity] shows that the topic keeps its name -->
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="scan" to="scan"/>
  </node>
</launch>
```

## Fix

`--fix` removes the comment, or the rules in it that find nothing, and corrects a name that is one slip away from that of a rule.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Edit, Finding, Fix, Severity
from launchlint.rules.registry import RULES
from launchlint.rules.rule import Rule
from launchlint.rules.view import SuppressionView
from launchlint.spelling import closest, surely
from launchlint.suppression import Name, Suppression, unused

RULE = Rule("LL802", "unused-suppression", Severity.WARNING, fixable="safe")


def check(view: SuppressionView) -> Iterator[Finding]:
    """Look at every suppression of the run."""
    for suppression in view.suppressions:
        if suppression.problem:
            yield RULE.at_location(
                suppression.location, f"this comment suppresses nothing: {suppression.problem}", element=_element(suppression)
            )
            continue
        for name in suppression.names:
            if view.resolve(name.text.lower()) is None:
                yield _unknown(suppression, name, view.names)
    everything = all(rule.id in view.on for rule in RULES if rule.default)
    for suppression, names in unused(view.suppressions, set(view.used)):
        idle = tuple(name for name in names if view.resolve(name.text.lower()) in view.on)
        if idle:
            yield _unused(suppression, idle)
        elif not suppression.names and everything:
            yield _finding(suppression, "no rule finds anything where this comment suppresses all", _removal(suppression))


def _unknown(suppression: Suppression, name: Name, names: tuple[str, ...]) -> Finding:
    near = closest(name.text.lower(), names)
    return RULE.at_location(
        suppression.location,
        f"there is no rule {name.text}: this name suppresses nothing",
        help=f"did you mean {near}?" if near is not None else "launchlint rules lists all rules",
        topic=name.text,
        element=_element(suppression),
        fix=_renamed(suppression, name, surely(name.text.lower(), names)),
    )


def _renamed(suppression: Suppression, name: Name, near: str | None) -> Fix | None:
    if near is None or suppression.location.start == name.span.start:  # out of an entity
        return None
    return Fix(f"write {near}", True, (Edit(suppression.location.path, *name.span, near),))


def _unused(suppression: Suppression, idle: tuple[Name, ...]) -> Finding:
    listed = ", ".join(name.text for name in idle)
    verb = "finds" if len(idle) == 1 else "find"
    where = "in this file" if suppression.covers is None else "in the element below"
    kept = [name for name in suppression.names if name not in idle]
    fix = _removal(suppression) if not kept else _shortened(suppression, kept)
    return _finding(suppression, f"{listed} {verb} nothing {where}, so that there is nothing to suppress", fix)


def _finding(suppression: Suppression, message: str, fix: Fix) -> Finding:
    return RULE.at_location(suppression.location, message, label="not needed", fix=fix, element=_element(suppression))


def _removal(suppression: Suppression) -> Fix:
    return Fix("remove the comment", True, (suppression.removal,))


def _shortened(suppression: Suppression, kept: list[Name]) -> Fix:
    listed = ", ".join(name.text for name in kept)
    start, end = suppression.names[0].span.start, suppression.names[-1].span.end
    return Fix(f"leave only {listed} in the list", True, (Edit(suppression.location.path, start, end, listed),))


def _element(suppression: Suppression) -> str:
    return f"suppression {' '.join(sorted(suppression.rules))}".strip()
