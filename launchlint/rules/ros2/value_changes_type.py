"""A param of a ROS 2 node that is meant as a text reaches it as something else.

launch writes the value into a file, without quotes where YAML takes it for a text anyway, and rcl reads the file by rules of its own: `y`
and `n` are true and false there, `1e3` and `inf` are numbers. `<set_parameter>` passes its value on a command line, where no quotes are
left. For a composable node it is the other way: launch itself reads its values, and `1e-3` without a point stays a text.

## Why it matters

The node declares another type than it gets, and dies with an exception; or it takes `y` for true.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param name="axis" value="y" type="str"/>
  </node>
</launch>
```

## Use instead

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
talker:
  ros__parameters:
    axis: "y"
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import NumberStaysText, TextRetyped
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule

RULE = Rule("LL905", "value-changes-type", Severity.WARNING)
WORDS = {"int": "a whole number", "double": "a number"}


def tell(problem: TextRetyped | NumberStaysText, view: object) -> Iterator[Finding]:
    """Say what it becomes, and how it is kept."""
    name, value = problem.name, problem.value
    if isinstance(problem, NumberStaysText):
        yield RULE.at(
            problem.origin,
            f"the composable node gets {value} as a text, not as a number",
            label=f"to YAML, {value} is a text",
            related=problem.related,
            notes=("launch reads what composable nodes get itself, by YAML 1.1, where a number with an exponent needs a point and a sign",),
            help=f"write {_with_point(value)}",
            cause=f"numbers of {problem.origin.place.source.path}",
        )
        return
    becomes = WORDS[problem.type] if problem.type != "bool" else "true" if value in ("y", "Y") else "false"
    why = "it stands without quotes on the node's command line" if problem.command_line else "launch writes it without quotes for the node"
    yield RULE.at(
        problem.origin,
        f"the param {name} is meant as the text {value!r}, and the node gets {becomes}",
        label=f"{value} is {becomes} to rcl",
        notes=(f"{why}, and rcl reads {value} as {becomes}",),
        help=f'put the param into a parameter file, as {name.rpartition(".")[2]}: "{value}"',
        topic=name,
    )


def _with_point(value: str) -> str:
    """A number that both read as one: ``1e-3`` → ``1.0e-3``."""
    if not any(each.isdigit() for each in value):
        return f"{'-' if value[0] == '-' else ''}.{value.lstrip('+-')[:3].lower()}"
    mantissa, _, exponent = value.lower().partition("e")
    sign = "" if exponent[:1] in ("+", "-") else "+"
    return f"{mantissa if '.' in mantissa else mantissa + '.0'}e{sign}{exponent}"
