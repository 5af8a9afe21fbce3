"""The args of a launch file do not fit the files that include it.

What it does: it looks at all includes of the run together. Where two or more of them fail at the same arg (or pass the same
args that are not declared) of one file, it tells so at that file, with its callers: the file has most likely changed. Where the same
callers do both, that is told once: an arg was renamed.

## Why it matters

A single caller is told of its own mistake (LL403, LL404). Seen from the file that changed, what breaks several of them is one mistake,
mended in one place: so it is told there, once, and no more at each of them.

## Example

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="rate" value="15"/>
  </include>
</launch>
```

```xml second.launch
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="rate" value="30"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="frame_rate" default="30"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="framerate" value="$(arg frame_rate)"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="frame_rate" value="15"/>
  </include>
</launch>
```

```xml second.launch
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="frame_rate" value="30"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="frame_rate" default="30"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="framerate" value="$(arg frame_rate)"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Location, Related, Severity
from launchlint.rules.judging.broken_call import MOVE, lacking_call, undeclared_call
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.rules.view import RunView

RULE = Rule("LL407", "broken-caller", Severity.ERROR, roslaunch="refuses")
_MISSING = " missing"
_BREAKS = "breaks here"

_MOST_SHOWN = 8


def check(view: RunView) -> Iterator[Finding]:
    """Yield one finding for each arg of a file that several includes get wrong."""
    roots: dict[str, Location] = {}
    calls: dict[tuple[str, str, bool], dict[tuple[str, int], Location]] = {}
    known: dict[str, tuple[str, ...]] = {}
    launchers: dict[str, str] = {}
    renamed: dict[tuple[str, frozenset[str]], str] = {}
    included = {path for entry in view.entries for path in entry.included if path != entry.path}
    for entry in view.entries:
        roots.update(entry.roots)
        if entry.needs_caller and entry.path in included:
            continue  # what it lacks when started alone, its callers give
        for call in entry.broken_calls:
            launchers[call.target] = entry.launcher
            known[call.target] = known.get(call.target) or call.known
            calls.setdefault((call.target, call.name, call.missing), {})[call.location.path, call.location.start] = call.location
    for (target, name, missing), callers in calls.items():
        if not missing and ", " not in name:
            renamed[target, frozenset(path for path, _ in callers)] = name
    for (target, name, missing), callers in sorted(calls.items()):
        root = roots.get(target)
        if root is None or len({path for path, _ in callers}) < 2:
            continue
        places = [callers[key] for key in sorted(callers)]
        args, it = ("args", "them") if ", " in name else ("arg", "it")
        wrong = f"do not pass the arg {name}, which it needs" if missing else f"pass the {args} {name}, which it does not declare"
        instead = renamed.get((target, frozenset(path for path, _ in callers)), "") if missing else ""
        meant = f"is {instead}, which they pass, meant to be {name}? Else " if instead else ""
        more = (f"and {len(places) - _MOST_SHOWN} more",) if len(places) > _MOST_SHOWN else ()
        yield Finding(
            RULE.id,
            RULE.name,
            RULE.severity,
            root,
            f"{len(places)} includes of this file {wrong}",
            label="this file",
            related=tuple(Related(place, _BREAKS) for place in places[:_MOST_SHOWN]),
            notes=(*more, f"{launchers[target]} refuses each of the launch files that hold them"),
            help=f"{meant}give {name} a default here, or pass it there" if missing else f"declare {name} here, or stop passing {it} there",
            element=f"{target} {name}",
            topic=f"{name}{_MISSING if missing else ' undeclared'}",
            cause=lacking_call(target) if missing else undeclared_call(target, name.split(", "), known[target]),
        )


def idea(finding: Finding) -> tuple[object, ...] | None:
    """The same files do not pass what a file needs, and pass what it does not declare: its args were changed, most likely renamed."""
    if finding.rule != RULE.id:
        return None
    callers = {each.location.path for each in finding.related if each.label == _BREAKS}
    return (finding.location.path, *sorted(callers)) if callers else None


def together(findings: Sequence[Finding]) -> Finding:
    """With what the includes themselves say to do where the file holds the arg after all: a second declaration would be refused."""
    told = joined(findings)
    if told.rule != RULE.id:
        return told
    moved = next((each.help for each in findings if each.rule != RULE.id and each.help.startswith(MOVE)), "")
    needed = [each.topic.removesuffix(_MISSING) for each in findings if each.rule == RULE.id and each.topic.endswith(_MISSING)]
    if len(needed) > 1:
        names = ", ".join(needed)
        told = told._replace(
            message=f"{len(told.related)} includes of this file do not pass all args that it needs: {names}",
            help=f"give {names} defaults here, or pass them there",
        )
    return told._replace(help=f"{moved}; or stop passing it there") if moved else told
