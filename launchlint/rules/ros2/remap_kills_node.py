"""A remap of a ROS 2 node is one that rcl refuses.

Both sides are names: letters, digits and single underscores, in parts between slashes, with `/` or `~/` in front. Wildcards, `{node}`,
a slash at the end, a digit at the beginning of a part, and an empty side are refused. It is a warning where only another value of an arg
than its default makes the name.

## Why it matters

launch passes it on as it is, and the node dies when it starts.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker">
    <remap from="chatter" to="front-left/chatter"/>
  </node>
</launch>
```

## Use instead

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker">
    <remap from="chatter" to="front_left/chatter"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import RemapDies
from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.rcl.refused import Refused
from launchlint.rcl.remap import parse
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

_OTHER = late(r"[^\w/~]")
_DOUBLED = late(r"_{2,}|/{2,}")
_DIGIT = late(r"(^|/)([0-9])")
RULE = Rule("LL947", "remap-kills-node", Severity.ERROR)


def tell(problem: RemapDies, view: LaunchView) -> Iterator[Finding]:
    """Say what is wrong, and on which side."""
    shown = problem.source if problem.side == "from" else problem.target
    text = problem.place.text
    written = shown in text if shown else "$(" not in text
    yield RULE.at(
        problem.origin,
        f"{problem.node} dies when it starts: rcl refuses this remap, since {problem.reason}",
        severity=None if written or not view.launch.given else Severity.WARNING,
        label=f"{problem.side}={shown!r}" if shown else f"{problem.side} is empty",
        notes=(f"launch passes -r {problem.source}:={problem.target}, and does not look at it",),
        help=_help(problem, shown),
    )


def _help(problem: RemapDies, shown: str) -> str:
    """What to write instead: the name that rcl takes and that is most like this one, if there is one."""
    side = problem.side
    if not shown:
        return f"remove the remap, or give {side} a name"
    if "*" in shown:
        return "write one remap for each of the names"
    mended = _mended(shown, problem.node)
    rule = f"{mended}:={problem.target}" if side == "from" else f"{problem.source}:={mended}"
    if mended != shown and not isinstance(parse(rule), Refused):
        return f'write {side}="{mended}"'
    return "write the name with letters, digits and underscores, and slashes between its parts"


def _mended(name: str, node: str) -> str:
    """A name without what rcl refuses: ``~scan`` → ``~/scan``, ``front-camera//image/`` → ``front_camera/image``."""
    own, _, last = node.rpartition("/")
    name = name.replace("{node}", last).replace("{ns}", own or "/").replace("{namespace}", own or "/")
    if name.startswith("~") and not name.startswith("~/"):
        name = f"~/{name[1:]}"
    name = _DOUBLED.sub(lambda found: found[0][0], _OTHER.sub("_", name))
    name = _DIGIT.sub(r"\1n\2", name)
    return name.rstrip("/")
