"""An element lacks an attribute that its tag needs.

A `<node>` needs `name`, `pkg` and `type`; `<include>` needs `file`; `<remap>` needs `from` and `to`; `<env>` needs
`name` and `value`; `<machine>` needs `name` and `address`; `<arg>` and `<param>` need `name`. An `<arg>` in an
`<include>` needs a `value` as well. (What a `<test>` needs is told by LL310.) Where the name of an arg or a param is the attribute itself
(`<arg speed="2"/>`) the help says so, and LL104 says nothing of it; nor where the only strange attribute stands for the only one that is
missing (`package` for `pkg`).

In ROS 2, a `<node>` needs only `exec`; a `<node_container>` needs `name` and `namespace` as well, a `<composable_node>` `pkg`, `plugin` and
`name`. Where the attribute stands under its name in ROS 1 (`type` for `exec`), LL112 tells of it alone, and LL104 where
it is the name in Python (`executable`).

## Why it matters

roslaunch refuses the file, for some tags with a Python traceback that does not show the line.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="container"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="container" namespace=""/>
</launch>
```

"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.edits import MOST_ATTRIBUTES, spot
from launchlint.rules.rule import Rule
from launchlint.spelling import closest
from launchlint.syntax.problems import MissingAttribute
from launchlint.syntax.ros1.dialect import OWNERS, TAGS
from launchlint.syntax.ros2.names import IN_PYTHON
from launchlint.syntax.ros2.of_ros1 import ATTRIBUTES
from launchlint.syntax.ros2.problems import LacksAttribute
from launchlint.syntax.tree import Element

RULE = Rule("LL105", "missing-attribute", Severity.ERROR, roslaunch="refuses")
STOPS = {
    "remap": "<remap> tag is missing required from/to attributes",
    "env": "<env> tag is missing required name/value attributes",
    "arg": "Invalid <arg> tag: 'name'",
}


def tell(problem: MissingAttribute | LacksAttribute, view: object) -> Iterator[Finding]:
    """Name the missing attribute. ``test-name`` is LL310's."""
    if isinstance(problem, LacksAttribute):
        yield from _ros2(problem)
        return
    tag, name = problem.tag, problem.attribute
    if name == "test-name":
        return
    at = spot(view, problem.place)
    meant = None if at is None or name != "name" else name_instead(at.element)
    strange = None if at is None else instead_of_required(at.element)
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
        help=f'write name="{meant}" {_value(at.element, meant)}'
        if at is not None and meant is not None
        else f"is {strange}, which roslaunch drops, meant to be {name}?"
        if strange is not None
        else _advice(tag, name),
        topic=name,
    )


def _advice(tag: str, name: str) -> str:
    if tag == "node" and name == "name":
        return 'add name="…"; for several copies of one node, name="$(anon …)" gives each a name of its own'
    if tag == "arg" and name == "value":
        return 'add value="…": what is passed to an included file must have a value'
    return f'add {name}="…"'


def name_instead(element: Element) -> str | None:
    """The attribute that is the name itself, as in ``<arg speed="2"/>``; ``None`` where there is no such one, or more than one."""
    if element.tag not in ("arg", "param") or "name" in element.attributes or len(element.attributes) > MOST_ATTRIBUTES:
        return None
    known = TAGS[element.tag].known
    strange = [each for each in element.attributes if each not in known]
    if len(strange) != 1 or strange[0] in OWNERS or closest(strange[0], (*known, *OWNERS)) is not None:
        return None
    return strange[0]


def instead_of_required(element: Element) -> str | None:
    """The attribute that stands for the only one which ``element`` lacks and has to have, as in ``<node package="amcl" …/>``.

    ``None`` where there is no such one, or more than one.
    """
    rule = TAGS.get(element.tag)
    if rule is None or element.tag in ("arg", "param") or len(element.attributes) > MOST_ATTRIBUTES:
        return None
    lacking = [each for each in rule.required if each not in element.attributes]
    strange = [each for each in element.attributes if each not in rule.known]
    return strange[0] if len(lacking) == 1 and len(strange) == 1 and closest(strange[0], rule.known) is None else None


def _value(element: Element, meant: str) -> str:
    """How the value of the attribute ``meant`` is given to an ``<arg>`` or a ``<param>``."""
    return f'{"default" if element.tag == "arg" and _is_declaration(element) else "value"}="{element.attributes[meant].value[:60]}"'


def _is_declaration(element: Element) -> bool:
    return element.parent is None or element.parent.tag in ("launch", "group")


def _ros2(problem: LacksAttribute) -> Iterator[Finding]:
    tag, name = problem.tag, problem.attribute
    old = ATTRIBUTES.get("node" if tag == "node_container" else tag, {})
    if any(name in (old.get(given), IN_PYTHON.get(given)) for given in problem.given):
        return  # it stands under another name: LL112 or LL104
    if problem.child:
        message, advice = f"{tag} needs at least one {name} inside", f"add <{name} …/>, or remove the {tag}"
    else:
        message, advice = f"{tag} needs the attribute {name}", _ADVICE2.get((tag, name), f'add {name}="…"')
        if tag == "arg" and name == "value" and "default" in problem.given:
            advice = "write value for default: what is passed to an included file is its value"
    yield RULE.at(problem.origin, message, label=f"{name} is missing", notes=("ros2 launch refuses the file",), help=advice, topic=name)


_ADVICE2 = {
    ("node_container", "namespace"): 'add namespace="" for the namespace around it; a container must say it, so that nodes find it',
    ("arg", "value"): 'add value="…": what is passed to an included file must have a value',
    ("let", "value"): 'add value="…"; a variable that may be given from outside is an <arg> with a default',
}
