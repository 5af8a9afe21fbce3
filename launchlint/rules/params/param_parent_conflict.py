"""A parameter has a value, and another parameter is set below it.

`gains` cannot be a number while there is `gains/p`: what has parameters below it is a namespace, and a parameter is
either a value or a namespace.

## Why it matters

The parameter server keeps only what is set last. roslaunch reports it if the value comes first, and says nothing at
all in the other order.

## Example

```xml
<launch>
  <param name="controller/gains" value="1.5"/>
  <param name="controller/gains/p" value="2.0"/>
</launch>
```

## Use instead

```xml
<launch>
  <param name="controller/gains/overall" value="1.5"/>
  <param name="controller/gains/p" value="2.0"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.model import ParameterSetting, Unknown
from launchlint.rules.judging.param_values import is_certain
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL505", "param-parent-conflict", Severity.WARNING, roslaunch="reports")

MOST_LEVELS = 100
"""Levels of a name that are looked at; real names have fewer than ten."""


def check(view: LaunchView) -> Iterator[Finding]:
    """Find names that are a value and a namespace, in either order; one finding for each pair of places."""
    values: dict[str, ParameterSetting] = {}
    below: dict[str, ParameterSetting] = {}
    told: set[str] = set()
    around: dict[str, list[str]] = {}
    for setting in view.launch.parameter_settings:
        if not is_certain(setting) or (isinstance(setting.value, Unknown) and setting.tag == "rosparam"):
            continue  # the value of a <rosparam> that cannot be read may be a dictionary
        namespace = setting.name.rpartition("/")[0]
        parents = around.get(namespace)
        if parents is None:  # the first one in it
            parents = around[namespace] = _parents(setting.name)
            for parent in parents:
                below.setdefault(parent, setting)
        for parent in parents:
            if parent in values and parent not in told:
                told.add(parent)
                yield _finding(values[parent], setting, value_first=True)
        if setting.name in below and setting.name not in told:
            told.add(setting.name)
            yield _finding(setting, below[setting.name], value_first=False)
        values.setdefault(setting.name, setting)


def _parents(name: str) -> list[str]:
    """The namespaces of a parameter name, outermost first, without the root (roslaunch.config.namespaces_of)."""
    parts = name.split("/")[:MOST_LEVELS]
    return ["/".join(parts[:end]) for end in range(2, len(parts))]


def _finding(value: ParameterSetting, child: ParameterSetting, *, value_first: bool) -> Finding:
    """The later of the two is told, whichever it is."""
    first, second = (value, child) if value_first else (child, value)
    kept = "the parameter server keeps only the one that is set last"
    if value_first and isinstance(value.value, dict):
        kept = "roslaunch takes that for a conflict, although the value is a dictionary"
    if value_first:
        note = f"roslaunch reports: parameter [{child.name}] conflicts with parent parameter [{value.name}]"
    else:
        note = "roslaunch says nothing, and the value wipes out everything below it"
    return RULE.at(
        second.origin,
        f"{value.name} is set to a value, and {child.name} below it: {kept}",
        label="set below it" if value_first else "set to a value",
        related=((first.origin.place, "set to a value" if value_first else "set below it"),),
        notes=(note,),
        help=f"give one of the two another name, such as {value.name}/value",
        topic=value.name.rsplit("/", 1)[-1],
        cause=f"{first.origin.place.source.path} {first.origin.place.span.start} {note if value_first else kept}",
    )
