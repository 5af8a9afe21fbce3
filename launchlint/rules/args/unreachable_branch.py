"""An `if` or `unless` can never be taken.

Its value is fixed in the file itself, literally or through args that have a fixed `value`, so that no arg given to the file
and no environment variable can change it.

## Why it matters

What stands in it is not started in any configuration, and nobody notices when it breaks. Often the arg was meant to have a
`default` in place of a `value`.

A literal `if="false"` (or `if="0"`, `unless="true"`, `unless="1"`) is a switch: somebody put the element away and means to
have it back. That is told as information only.

## Example

```xml
<launch>
  <arg name="sim" value="false"/>
  <node pkg="gazebo_ros" type="gzserver" name="gazebo" if="$(arg sim)"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="sim" default="false"/>
  <node pkg="gazebo_ros" type="gzserver" name="gazebo" if="$(arg sim)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.model import Branch
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL213", "unreachable-branch", Severity.WARNING)


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Every condition that keeps its element out and cannot be changed; one that is taken anywhere is in order."""
    for branch in view.launch.branches:
        if branch.taken is False and not branch.open:
            yield _finding(branch)
        else:
            yield RULE.fine(branch.origin)


def _finding(branch: Branch) -> Finding:
    tag = branch.element.text.removeprefix("<").split(None, 1)[0].rstrip("/>")
    shown = " ".join(branch.text.split())[:60]
    if "$(" not in branch.text:
        return RULE.at(
            branch.origin,
            f'this <{tag}> is switched off by {branch.attribute}="{shown}"',
            severity=Severity.INFO,
            label="never taken",
            help="put an arg with a default into the condition to switch it on without an edit, or remove the element",
        )
    return RULE.at(
        branch.origin,
        f"this <{tag}> is never evaluated: nothing can change {branch.attribute}={shown!r}",
        label="never taken",
        notes=("all args that it depends on have a fixed value in this file",),
        help="write default instead of value where the arg is declared, or remove the element",
    )
