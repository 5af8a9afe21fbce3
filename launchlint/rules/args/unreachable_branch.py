"""An `if` or `unless` can never be taken.

Its value is fixed in the file itself, literally or through args that have a fixed `value`, so that no arg given to the file
and no environment variable can change it. It looks at launch files of ROS 1: in ROS 2 a `<let>` and whatever a file before has left set
the value, too, and what a branch hangs on is not followed through these.

## Why it matters

What stands in it is not started in any configuration, and nobody notices when it breaks. Often the arg was meant to have a
`default` in place of a `value`.

A literal `if="false"` (or `if="0"`, `unless="true"`, `unless="1"`) is a switch: somebody put the element away and means to
have it back. So is an arg whose value in this file is a literal `true` or `false`. Both are told as information only.

## Example

```xml
<launch>
  <arg name="robot" value="turtlebot"/>
  <node pkg="husky_base" type="husky_node" name="base" if="$(eval robot == 'husky')"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="robot" default="turtlebot"/>
  <node pkg="husky_base" type="husky_node" name="base" if="$(eval robot == 'husky')"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.model import Branch
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Place
from launchlint.syntax.ros1.substitutions import only_arg, parse

RULE = Rule("LL213", "unreachable-branch", Severity.WARNING)
_BOOLEANS = ("true", "false", "1", "0")


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Every condition that keeps its element out and cannot be changed; one that is taken anywhere is in order."""
    for branch in view.launch.branches:
        if branch.taken is False and not branch.open:
            yield _finding(branch, view)
        else:
            yield RULE.fine(branch.origin)


def _finding(branch: Branch, view: LaunchView) -> Finding:
    shown = " ".join(branch.text.split())[:60]
    if not parse(branch.text).computed:
        return RULE.at(
            branch.origin,
            f'this <{branch.tag}> is switched off by {branch.attribute}="{shown}"',
            severity=Severity.INFO,
            label="never taken",
            help="put an arg with a default into the condition to switch it on without an edit, or remove the element",
        )
    switch = _switch(branch, view)
    return RULE.at(
        branch.origin,
        f"this <{branch.tag}> is never evaluated: nothing can change {branch.attribute}={shown!r}",
        severity=None if switch is None else Severity.INFO,
        label="never taken",
        related=() if switch is None else ((switch, "the switch"),),
        notes=("all args that it depends on have a fixed value in this file",)
        if switch is None
        else ("its arg has a literal value, which people change in the file itself",),
        help="write default instead of value where the arg is declared, or remove the element",
    )


def _switch(branch: Branch, view: LaunchView) -> Place | None:
    """The value of the one arg that the condition is, where that stands in the same file as a literal ``true`` or ``false``."""
    arg = only_arg(parse(branch.text.strip()))
    document = view.documents.get(branch.element.source.path)
    if not arg or document is None:
        return None
    declared = [each for each in document.elements if each.tag == "arg" and each.get("name") == arg and "value" in each.attributes]
    if len(declared) != 1 or (declared[0].get("value") or "").strip().lower() not in _BOOLEANS:
        return None
    return document.place(declared[0].attributes["value"].value_span)
