"""The YAML of a `<rosparam>` cannot be loaded.

It is read as PyYAML reads it for rosparam: one document, and a dictionary unless the attribute `param` says which
parameter the value is for. Where the YAML stands in a file of its own, the finding stands there.

In ROS 2 launch itself reads the parameter files of composable nodes, and those whose substitutions it performs; what rcl makes of the files
of other nodes is told by LL904.

## Why it matters

roslaunch refuses the launch file, and with it every launch file that includes it.

## Example

```xml
<launch>
  <rosparam>
    rate:10
  </rosparam>
</launch>
```

## Use instead

```xml
<launch>
  <rosparam>
    rate: 10
  </rosparam>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import ParamYamlInvalid
from launchlint.evaluate.ros2.parameter_problems import ComponentFileRefused, ContentNoYaml
from launchlint.finding import Finding, Severity
from launchlint.rules.edits import spot
from launchlint.rules.of_environment import hangs_on_environment
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Place
from launchlint.syntax.ros1.substitutions import parse

RULE = Rule("LL503", "param-yaml-invalid", Severity.ERROR, roslaunch="refuses")
_ASKED = "it is made from an environment variable, which may have another value where this is started"


def tell(problem: ParamYamlInvalid | ComponentFileRefused | ContentNoYaml, view: object) -> Iterator[Finding]:
    """Say what is wrong and what was meant."""
    if not isinstance(problem, ParamYamlInvalid):
        yield _ros2(problem)
        return
    reason, hint, place = problem.reason, problem.hint, problem.place
    name = problem.file.rpartition("/")[2] if problem.in_file else ""
    what = f"the YAML file {name}" if name else "this <rosparam>"
    note = "roslaunch refuses the launch file"
    if hint == "scalar" or (hint == "colon" and reason.startswith("a value that is no dictionary")):
        note = "roslaunch stops with: 'param' attribute must be set for non-dictionary values"
    if hint == "colon":
        key, _, value = place.text.split("\n", 1)[0].partition(":")
        message = f"a blank is missing behind the colon of {key!r}, so that it is a text and no key"
        label, help_ = "a text", f"write {key}: {value.strip()}"
    elif hint == "scalar":
        message = f"the value of {what} is no dictionary, and no parameter is named for it"
        label, help_ = "", "name the parameter with param=, or write NAME: VALUE"
    else:
        message, label, help_ = f"{what} cannot be loaded: {reason}", "here", _advice(place, name)
    asked = not name and isinstance(view, LaunchView) and hangs_on_environment(_content(problem, view), problem.origin, view)
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.INFO if asked else None,
        label=label,
        related=problem.related,
        notes=(note, *([_ASKED] if asked else [])),
        help=help_,
    )


def _content(problem: ParamYamlInvalid, view: LaunchView) -> str:
    """The ``<rosparam>`` as it is written, with the YAML inside."""
    at = spot(view, problem.place)
    return problem.place.text if at is None else problem.place.source.text[at.element.span.start : at.element.span.end]


def _ros2(problem: ComponentFileRefused | ContentNoYaml) -> Finding:
    name = problem.file.rpartition("/")[2]
    composable = isinstance(problem, ComponentFileRefused)
    what = f"the parameter file {name} cannot be loaded" if composable else f"{name} is no YAML once its substitutions are performed"
    why = "ros2 launch reads the params of composable nodes itself, and stops" if composable else "ros2 launch stops"
    return RULE.at(problem.origin, f"{what}: {problem.reason}", related=problem.related, notes=(why,))


def _advice(place: Place, name: str) -> str:
    """What to do; ``name`` is the YAML file, empty for one that is written into the launch file."""
    line = place.source.line(place.source.position(place.span.start).line)
    if name and not place.source.path.endswith(name):
        return f"save {name} as a text file in UTF-8"
    if line.lstrip(" ").startswith("\t"):
        return "indent YAML with blanks: tabs are not allowed there"
    if name and parse(line).computed:
        return 'substitutions in the file need subst_value="true" on the <rosparam>, and quotes around values such as "$(arg x)"'
    return f"try the mended file with: rosparam load {name}" if name else ""
