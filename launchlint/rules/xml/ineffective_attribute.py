"""Something that is accepted and does nothing.

A `respawn_delay` without `respawn="true"` or below zero, `required` on a `<test>`, `if` or `unless` on `<launch>`, a
`<group>` without anything in it, and a `<rosparam>` with neither a file nor text. A group in which everything is commented out is an
info: somebody keeps it as a place for that. So is one without attributes below a comment that says what belongs there, and one with a
namespace among several that hold nothing but params, with or without an empty `<rosparam>`: it keeps the place of params.

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

## Fix

`--fix` removes `required` from a `<test>`, `--unsafe-fixes` an empty group without comments. Nothing changes, which is proved before it
is done.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import Spot, fix, remove_attribute, remove_element, spot
from launchlint.rules.rule import Rule
from launchlint.syntax.problems import IneffectiveAttribute

RULE = Rule("LL113", "ineffective-attribute", Severity.WARNING, fixable="safe")

_PARAMS = ("param", "rosparam")
_SEVERAL = 2

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
    "commented-out-group": (
        "all that this <group> holds is commented out",
        "nothing that counts",
        "nothing needs to be done while it is to come back; else remove the group, too",
    ),
    "kept-group": (
        "this <group> is empty",
        "nothing in it",
        "nothing needs to be done while it is kept for what the comment above it speaks of; else remove both",
    ),
    "place-of-params": (
        "this <{tag}> holds no params",
        "nothing in it",
        "nothing needs to be done while it keeps the place of params, as others beside it have them; else remove it",
    ),
    "empty-rosparam": ("this <rosparam> loads nothing", "neither file nor text", 'add file="…" or YAML text, or remove it'),
}


def tell(problem: IneffectiveAttribute, view: object) -> Iterator[Finding]:
    """Say why it does nothing."""
    at = spot(view, problem.place)
    reason: str = problem.reason
    kept = "" if reason != "empty-group" else "commented-out-group" if _is_commented_out(at) else "kept-group" if _has_heading(at) else ""
    if not kept and reason in ("empty-group", "empty-rosparam") and _keeps_place(at):
        kept = "place-of-params"
    tag = "" if at is None else at.element.tag
    message, label, advice = (words.format(attribute=problem.attribute, tag=tag) for words in WORDS[kept or reason])
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.INFO if kept else None,
        label=label,
        help=advice,
        topic=reason,
        fix=None if kept in ("kept-group", "place-of-params") else _fix(reason, at),
    )


def _is_commented_out(at: Spot | None) -> bool:
    """Whether a comment of an element without children holds XML."""
    if at is None:
        return False
    inside = at.document.place(at.element.span).text[at.element.start_span.end - at.element.span.start :]
    return re.search(r"<[A-Za-z]", inside) is not None


def _keeps_place(at: Spot | None) -> bool:
    """Whether a group with a namespace, or what alone is in it, stands among several that hold nothing but params: it keeps their place."""
    group = None if at is None else at.element if at.element.tag == "group" else at.element.parent
    if group is None or group.parent is None or not group.get("ns") or len(group.children) > 1:
        return False
    beside = (each for each in group.parent.children if each is not group and each.tag == "group" and each.get("ns") and each.children)
    return sum(all(child.tag in _PARAMS for child in each.children) for each in beside) >= _SEVERAL


def _has_heading(at: Spot | None) -> bool:
    """Whether a bare element stands below a comment that begins its line."""
    if at is None or at.element.attributes:
        return False
    text, end = at.document.source.text, _without_blanks(at.document.source.text, at.element.span.start)
    if not text.endswith("-->", 0, end):
        return False
    start = next((comment.span.start for comment in at.document.comments if comment.span.end == end), 0)
    before = _without_blanks(text, start)
    return "\n" in text[before:start]


def _without_blanks(text: str, end: int) -> int:
    """Where the blanks before ``end`` begin."""
    while end and text[end - 1].isspace():
        end -= 1
    return end


def _fix(reason: str, at: Spot | None) -> Fix | None:
    if reason == "required-on-test":
        return fix("remove required", remove_attribute(at), safe=True)
    if reason == "empty-group" and at is not None and "<!--" not in at.document.place(at.element.span).text:
        return fix("remove the group", remove_element(at), safe=False)
    return None
