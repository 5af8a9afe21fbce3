"""Something that is accepted and does nothing.

A `respawn_delay` without `respawn="true"` or below zero, `required` on a `<test>`, `if` or `unless` on `<launch>`, a
`<group>` without anything in it, and a `<rosparam>` with neither a file nor text.

## Why it matters

Whoever wrote it expects an effect. `<launch if="false">`, for one, loads like any other file.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" respawn_delay="5"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" respawn="true" respawn_delay="5"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule

RULE = Rule("LL113", "ineffective-attribute", Severity.WARNING)

# Reason → message, label, help.
WORDS = {
    "respawn-delay-without-respawn": (
        "respawn_delay has no effect without respawn",
        "the node is never started again",
        'add respawn="true", or remove respawn_delay',
    ),
    "negative-respawn-delay": ("a negative respawn_delay means no delay", "below zero", "write the delay in seconds, or remove it"),
    "required-on-test": ("required has no effect on <test>", "ignored", "remove it: rostest judges the outcome of every test anyway"),
    "condition-on-launch": (
        "{attribute} has no effect on <launch>",
        "ignored",
        "put the content into a <group> with this condition, or the condition on the <include> of this file",
    ),
    "empty-group": (
        "this <group> is empty",
        "nothing in it",
        "remove it; if it is meant to close a scope, move the elements it is for into it",
    ),
    "empty-rosparam": ("this <rosparam> loads nothing", "neither file nor text", 'add file="…" or YAML text, or remove it'),
}


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Say why it does nothing; facts: ``tag``, ``attribute``, ``reason``."""
    message, label, advice = (words.format(attribute=problem.facts["attribute"]) for words in WORDS[problem.facts["reason"]])
    yield RULE.at(problem.origin, message, label=label, help=advice, topic=problem.facts["reason"])
