"""A remap has an empty name, or one that is no ROS name.

A name begins with a letter, `/` or `~` and goes on with letters, digits, `_` and `/`. A `//` in it is information only:
roslaunch reads it as one `/`, but a part of the name may have been forgotten there.

## Why it matters

roslaunch refuses the file.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="scan" to="front-laser/scan"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="scan" to="front_laser/scan"/>
  </node>
</launch>
```

## Fix

`--fix` writes one `/` for two, which changes nothing. `--unsafe-fixes` writes the name that the help proposes; roslaunch loads
the file then.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import DoubledSlash, InvalidRemapName
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, fix, is_literal, replace, set_value, spot
from launchlint.rules.judging.joined import led_by
from launchlint.rules.judging.left_over import left_over_in, meant_substitution
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL607", "invalid-remap-name", Severity.ERROR, roslaunch="refuses", fixable="safe")


def tell(problem: InvalidRemapName | DoubledSlash, view: LaunchView) -> Iterator[Finding]:
    """Name the character at fault."""
    attribute, value = problem.attribute, problem.value
    if isinstance(problem, DoubledSlash):
        yield RULE.at(
            problem.origin,
            f"{value[:60]!r} has two slashes in a row: roslaunch reads them as one",
            severity=Severity.INFO,
            label="one /",
            help="remove one, or write the namespace that was to stand between them",
            fix=fix("write one /", replace(spot(view, problem.place), problem.place, "/"), safe=True, changes=""),
        )
        return
    if problem.reason == "empty":
        yield RULE.at(
            problem.origin,
            f"the attribute {attribute} of this remap is empty",
            related=problem.related,
            notes=("roslaunch stops with: remap from/to attributes cannot be empty",),
            help="give a topic or service name; a remap cannot switch a topic off, but can send it to a name that nobody uses",
        )
        return
    message, help_, legal = _fault(value)
    meant = meant_substitution(value)
    if meant:
        help_, legal = f"write {meant} where the value is given", ""
    yield RULE.at(
        problem.origin,
        message,
        label="no ROS name",
        related=problem.related,
        notes=(f"roslaunch stops with: remap {attribute} [{value}] is not a valid ROS name",),
        help=help_,
        fix=_fix(problem, view, value, legal),
        shared_cause=left_over_in(value, view),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """What is nearly a substitution is told before the names that it spoils."""
    return led_by(findings, "LL215")


def _fix(problem: InvalidRemapName, view: object, value: str, legal: str) -> Fix | None:
    if not legal or not is_literal(problem.place, value):
        return None
    return fix(f"write {legal}", set_value(spot(view, problem.place), legal), safe=False, changes=LOADS)


def _fault(name: str) -> tuple[str, str, str]:
    """What is wrong with the name, what to do, and a name that may stand there instead (empty where nobody knows)."""
    if ":=" in name:
        source, _, target = name.partition(":=")
        return f"{name!r} is how remaps are written on the command line", f'write from="{source}" to="{target}"', ""
    found = re.search(r"[^\w/~]|(?<!^)~", name)
    if found is not None and any(char in name for char in "*?"):
        return f"{name!r} is no ROS name: there are no patterns in remaps", "write one <remap> for each name", ""
    if found is not None:
        what = "a blank" if found[0].isspace() else f"the character {found[0]!r}"
        legal = re.sub("_{2,}", "_", re.sub(r"[^\w/]+", "_", name)).strip("_")
        where = " there" if found[0] == "~" else ""
        return f"{name!r} is no ROS name: {what} is not allowed{where}", f"write {legal}" if legal else "", legal
    return f"{name!r} is no ROS name: it begins with {name[:1]!r}", "begin it with a letter or /", ""
