"""An element lacks an attribute that its tag needs.

A `<node>` needs `name`, `pkg` and `type`; `<include>` needs `file`; `<remap>` needs `from` and `to`; `<env>` needs
`name` and `value`; `<machine>` needs `name` and `address`; `<arg>` and `<param>` need `name`. An `<arg>` in an
`<include>` needs a `value` as well. (What a `<test>` needs is told by LL310.)

## Why it matters

roslaunch refuses the file, for some tags with a Python traceback that does not show the line.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.syntax.problems import MissingAttribute

RULE = Rule("LL105", "missing-attribute", Severity.ERROR, roslaunch="refuses")
STOPS = {
    "remap": "<remap> tag is missing required from/to attributes",
    "env": "<env> tag is missing required name/value attributes",
    "arg": "Invalid <arg> tag: 'name'",
}


def tell(problem: MissingAttribute, view: object) -> Iterator[Finding]:
    """Name the missing attribute. ``test-name`` is LL310's."""
    tag, name = problem.tag, problem.attribute
    if name == "test-name":
        return
    notes: tuple[str, ...]
    if tag == "rosparam":
        notes = ("roslaunch loads the file and fails when it runs the rosparam step",)
    elif tag == "include":
        notes = ("roslaunch ends with a Python traceback: KeyError: 'file'",)
    elif tag == "arg" and name == "value":
        notes = ("roslaunch stops with: include args must have declared values",)
    else:
        notes = (f"roslaunch stops with: {STOPS.get(tag, f'<{tag}> tag is missing required attribute: {name!r}')}",)
    yield RULE.at(
        problem.origin,
        f"<{tag}> needs the attribute {name}",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label=f"{name} is missing",
        notes=notes,
        help=_advice(tag, name),
        topic=name,
    )


def _advice(tag: str, name: str) -> str:
    if tag == "node" and name == "name":
        return 'add name="…"; for several copies of one node, name="$(anon …)" gives each a name of its own'
    if tag == "arg" and name == "value":
        return 'add value="…": what is passed to an included file must have a value'
    return f'add {name}="…"'
