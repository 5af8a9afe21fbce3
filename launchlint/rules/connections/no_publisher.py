"""A node waits for a topic that nobody publishes, while the launch file has a publisher that was probably meant.

A launch file is often only a part of a robot, so that a topic without a publisher is no mistake by itself. It is told where another
node publishes the same type under a name so near that one of the two is wrong: a letter apart, or in another namespace while that
publisher in turn reaches nobody; or where the two are the only ones in the launch that speak a type made for one purpose. It is an info
where the names are less alike; where a node that waits in vain for everything finds one single topic of its type; and where the type is
one of `std_msgs`, the names are those of the code, and one of the programs runs several times. So it is where the names have nothing in
common, and other sources of the workspace publish (or hear) the one that is left alone: that program may be started from elsewhere. And
so it is where a remap with the missing name stands in the other node and acts on nothing, which LL601 tells.

A node that takes any type, as a relay does, is told of only where the names are one letter apart, where both are left alone and a remap
leads it to the same name in another namespace, or where two others of their kind meet.

Nothing is said of an input for which params of the node switch on a file: `use_pcd_map: true` and a `map_path` for `map`.

It is told, too, where something else shows what was meant, however little the names are alike; a note then says what. The node waits for a
private name (`~odom`) that no remap leads anywhere, so that others publish there only if they are told to, and just one other node
publishes such a name, or has the only other loose end of that type. A remap that would join the two stands in another node, where it does
nothing, or stands there twice; or it stands in one of the two, and the name that it is to lead elsewhere is one letter apart from the one
that the node has. A remap leads what the node publishes to the very topic that it hears, and nobody else publishes there. All other nodes
of the same program have that name remapped, and meet somebody. In another launch file of the workspace (ROS 1), a remap leads that name of
the same program to the other one, and no other node gives the same here; where all is known and both are left alone, that of another
program that waits for such a name counts, too. Two others of their kind meet: copies of both programs, or names of one node that differ in
one word (`left/image` and `right/image`; `front` and `rear`, where the publisher has that word, too). A remap makes the name that the node
waits for, and of all that publish that type, made for one purpose, one alone has the name of its code. Everything is known that could be
the publisher, and another node with that name in its code, which is no private one, is led by a remap to what the other one publishes. The
two would meet if one of them had no remap. Or both nodes talk to nobody else, and nobody else speaks that type. Nothing is said of two
names that the launch file gives and that have nothing in common, where only copies of both programs meet; nor of the first and the last
node of a chain, of which one hears and the other says the same type, nor of two that a remap parts where what the one says comes, by way of
others, of what the other one hears, nor of a node that listens to several private names of which a remap leads one somewhere and leaves two
or more: it may take any of them.

Where a node of which not everything is known could be the publisher, and nothing says that it is, only what something shows besides is
told, or two names that differ in nothing but the namespace or one letter; a note then says which node that is. It is an info where the
namespaces differ and that node talks to whatever it finds (a window of displays, a bag), or is a launch file that is not here, unless
remaps make both names, or one of them where the type is made for one purpose. Nothing is said where a remap, a param, an argument or a
text in the sources of such a node has one of the two names.

Where a node is in another namespace than the nodes it was meant for, or lacks its remaps, so that several of its names are left alone in
the same way, that is told once, with all of them; services and actions and what is published in vain (LL613, LL614) among them.

It is an info, too, where a remap leads the node below the name of a program of the workspace that is not started here, and where one leads
the publisher below a name that no node here has, while an include could not be followed: that node may be one of its nodes.
Where every file that shows it is included by another one of the workspace that does not, it is an info: what a part lacks when it is
started alone, the whole may have.

A launch file of ROS 2 that has args without a default, or that another one of its package includes, is a part of a whole. Where the node
waits for a global name there, and the whole may give that, or put the file into the namespace in which the two meet, it is an info.

## Why it matters

Both nodes run, neither complains, and no message arrives.

## Example

```xml
<launch>
  <node pkg="turtlesim" type="turtlesim_node" name="sim"/>
  <node pkg="teleop_twist_keyboard" type="teleop_twist_keyboard.py" name="teleop"/>
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

import posixpath
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.meant_for import tell
from launchlint.rules.judging.met import met
from launchlint.rules.judging.misspelt import Repairs
from launchlint.rules.judging.one_cause import causes
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL612", "no-publisher", Severity.WARNING, fixable="unsafe")


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at the topics that have subscribers only."""
    yield from met(RULE, view, "subscriber")
    repairs = Repairs(view)
    for cause in view.once(causes)["subscriber"]:
        yield tell(RULE, cause, "both nodes run and neither complains, but no message arrives", repairs)


def idea(finding: Finding) -> tuple[object, ...]:
    """In launch files of one directory a node asks for the same name, and misses the same one of another node by as much."""
    return (posixpath.dirname(finding.location.path), finding.fix is None, *finding.about)
