"""A node calls a service or an action that nobody serves, while the launch file has a server that was probably meant.

It is told where another node serves the same type under a name that is a letter apart, or under the same name in another namespace where
nobody calls it; where another launch file of the workspace, or others of the same kind in this one, show that the two belong together, as
for LL612; and where they are the only ones in the launch that serve and call a service of that type, which is none of `std_srvs`, and
everything is known that could be the server. Else, where the names are less alike, or the type says little (those of `std_srvs`), it is
an info. Nothing is said of a service of a type that no node of the launch serves: it may run elsewhere. What could be there although it
is not known counts as for topics (LL612).

Several names of a node that are left alone in the same way, by one namespace or by missing remaps, are told once: by LL612 or LL613 where
there are topics among them.

## Why it matters

The call fails, or the node waits for the service for ever.

## Example

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" ns="maps" args="floor.yaml"/>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" ns="maps" args="floor.yaml"/>
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="static_map" to="maps/static_map"/>
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

RULE = Rule("LL614", "no-server", Severity.WARNING, fixable="unsafe")


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at the services and actions that have clients only."""
    yield from met(RULE, view, "client", "action client")
    repairs = Repairs(view)
    for cause in view.once(causes)["client"]:
        yield tell(RULE, cause, "the call fails, or waits for the server for ever", repairs)
