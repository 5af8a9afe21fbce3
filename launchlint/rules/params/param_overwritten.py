"""A parameter is set twice, and the first value has no effect.

Told is what nobody writes on purpose: the same parameter set again to another value in the same file, by a file that
is included afterwards, or by a YAML file that is loaded afterwards. Silent are the usual ways to override a value: a
YAML file and single parameters after it, several YAML files from the general to the special, a parameter set after
the include whose value it replaces, a `~param` of a group that a node sets again, and a second setting under a
condition.

Two included files that disagree about a parameter are told as an info.

## Why it matters

The last setting wins silently, so that the value one reads is not the value the robot runs with.

## Example

```xml
<launch>
  <param name="robot/max_speed" value="0.5"/>
  <param name="robot/frame" value="base_link"/>
  <param name="robot/max_speed" value="1.5"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="fast" default="false"/>
  <param name="robot/max_speed" value="0.5"/>
  <param name="robot/frame" value="base_link"/>
  <param name="robot/max_speed" value="1.5" if="$(arg fast)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.model import Launch, ParameterSetting
from launchlint.rules.params.values import is_certain, is_known, is_same, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin, Place

RULE = Rule("LL504", "param-overwritten", Severity.WARNING)


def check(view: LaunchView) -> Iterator[Finding]:
    """Compare each setting with the one before it of the same name."""
    launch = view.launch
    last: dict[str, ParameterSetting] = {}
    launch_files = {id(launch.entry)} | {id(include.source) for include in launch.includes if include.source is not None}
    scoped = {_key(setting.origin) for setting in launch.settings if setting.kind == "param"}
    for setting in launch.parameter_settings:
        earlier = last.get(setting.name)
        last[setting.name] = setting
        if earlier is None or not _differ(earlier, setting) or _key(earlier.origin) in scoped:
            continue
        if id(earlier.origin.place.source) not in launch_files:
            continue  # a YAML file: what comes after it is meant to override it
        single = id(setting.origin.place.source) in launch_files
        severity = _severity(earlier.origin, setting.origin, single=single)
        if severity is not None:
            found = _finding(setting.name, earlier.origin, setting.origin.place, earlier.value, setting.value, severity)
            if not single:
                found = found._replace(help="put the <param> behind the <rosparam> that loads the file, or remove it")
            if earlier.tag == "rosparam" and setting.node is not None:
                found = found._replace(notes=("in a node, <param> counts over <rosparam>, whichever comes first",))
            yield found
    yield from _in_one_scope(launch)
    for problem in launch.problems:
        if problem.kind == "param-replaced" and problem.facts["always"] and not problem.assumed:
            old, new = problem.facts["old"], problem.facts["new"]
            if is_known(old) and is_known(new) and not is_same(old, new):
                first = Origin(problem.related[0][0], problem.origin.step)
                yield _finding(problem.facts["name"], first, problem.place, old, new, Severity.WARNING)


def _key(origin: Origin) -> tuple[str, int]:
    return (origin.place.source.path, origin.place.span.start)


def _differ(earlier: ParameterSetting, later: ParameterSetting) -> bool:
    """Whether ``later`` surely takes the place of another value whenever it is set."""
    if not (is_known(earlier.value) and is_known(later.value)) or is_same(earlier.value, later.value):
        return False
    if not (is_certain(earlier) and is_certain(later)):
        return False
    return set(later.conditions) <= set(earlier.conditions)


def _severity(earlier: Origin, later: Origin, *, single: bool) -> Severity | None:
    """How sure it is that nobody meant it; None where overriding is what people do. ``single``: the later one is no YAML file."""
    outer, inner = earlier.chain, later.chain
    if inner[: len(outer)] == outer:
        return Severity.WARNING  # in the same file, or in one that it includes afterwards
    if outer[: len(inner)] == inner:
        return None  # set again after the include
    return Severity.INFO if single else None


def _in_one_scope(launch: Launch) -> Iterator[Finding]:
    """A ``~param`` that is set again before any node has followed."""
    settings = {_key(setting.origin): setting for setting in launch.settings if setting.kind == "param"}
    for setting in settings.values():
        earlier = settings.get((setting.replaced.source.path, setting.replaced.span.start)) if setting.replaced is not None else None
        if earlier is None or earlier.reached or not set(setting.conditions) <= set(earlier.conditions):
            continue
        if any(condition.assumed for condition in (*earlier.conditions, *setting.conditions)):
            continue
        if is_known(earlier.value) and is_known(setting.value) and not is_same(earlier.value, setting.value):
            yield _finding(setting.key, earlier.origin, setting.origin.place, earlier.value, setting.value, Severity.WARNING)


def _finding(name: str, first: Origin, second: Place, old: object, new: object, severity: Severity) -> Finding:
    behind = first.place.source is not second.source
    return RULE.at(
        first,
        f"{name} is set to {shown(old)} here, and to {shown(new)} afterwards: the last value counts",
        severity=severity,
        label="has no effect",
        related=((second, "set again here"),),
        help="set it once; to override a value of an included file, set it behind the <include>, or pass an arg"
        if behind
        else "remove one of the two, or put a condition on the second",
        topic=name.rsplit("/", 1)[-1],
    )
