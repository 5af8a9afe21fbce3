"""A node publishes a topic that nobody subscribes to, while the launch file has a subscriber that was probably meant.

Topics without a subscriber are common and no mistake. It is a warning where a node subscribes to the same type under a name that
is a letter apart; where a remap that would join the two stands in another node and does nothing there, or all other nodes of the
same program have that name remapped and meet somebody; where another launch file of the workspace, or others of the same kind in
this one, show that the two belong together, as for LL612; or where the publishing node does nothing but publish, reaches nobody at all,
and the name that somebody subscribes to differs by a namespace or a word. It is an info where only the type speaks for it. Where both
ends meet nobody, the rule no-publisher (LL612) speaks. Nothing is said while a node of which not everything is known could be the
subscriber.

Several names of a node that are left alone in the same way, by one namespace or by missing remaps, are told once: by LL612 where there are
topics among them that the node waits for.

## Why it matters

What the node works out or commands reaches nobody.

## Example

```xml
<launch>
  <node pkg="turtlesim" type="turtlesim_node" name="sim"/>
  <node pkg="turtlesim" type="turtle_teleop_key" name="keys"/>
  <node pkg="teleop_twist_keyboard" type="teleop_twist_keyboard.py" name="teleop">
    <remap from="cmd_vel" to="drive"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="turtlesim" type="turtlesim_node" name="sim"/>
  <node pkg="teleop_twist_keyboard" type="teleop_twist_keyboard.py" name="teleop">
    <remap from="cmd_vel" to="turtle1/cmd_vel"/>
  </node>
</launch>
```

## Fix

`--unsafe-fixes` makes two ends meet whose names are one letter apart, where there is only one name so near: it writes the other name
in the `<remap>` or `<param>` that makes one of them, as global or relative as before, or else puts a `<remap>` into the `<node>`.
In ROS 2 a person has to do it.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.meant_for import tell
from launchlint.rules.judging.met import met
from launchlint.rules.judging.misspelt import Repairs
from launchlint.rules.judging.one_cause import causes
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL613", "no-subscriber", Severity.INFO, fixable="unsafe")


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at the topics that have publishers only."""
    yield from met(RULE, view, "publisher")
    repairs = Repairs(view)
    for cause in view.once(causes)["publisher"]:
        yield tell(RULE, cause, "what it publishes reaches nobody", repairs)
