"""An element has an attribute that its tag does not take.

It is a misspelt one (`clear_parmas`), one of another tag (`args` belongs to `<node>`, `default` to `<arg>`), or one
that never existed.

## Why it matters

roslaunch drops the attribute. It says so in a warning that is easy to miss, and for `<launch>` not at all; the node
then runs without the setting that somebody wrote down.

A known attribute with a letter, a mark or a word like `off` put to it (`_if`, `xargs`, `launch-prefix-off`) has been switched off by
somebody: that is an info, without a fix. What rosmon reads (`rosmon-name`, `enable-coredumps`), another program that starts launch files,
is an info, too. An `<arg>` that has its name as an attribute (`<arg speed="2"/>`) is told of by LL105 alone.

In ROS 2, launch refuses the file: that is an error, in YAML as in XML (there, the attributes are the keys below the tag).

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" respwan="true"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" executable="talker" name="talker"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" respawn="true"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker"/>
</launch>
```

## Fix

`--fix` writes the attribute that the name is one slip away from, where there is only one and the element has not got it yet; a name that
is further off, or belongs to another tag, takes `--unsafe-fixes`. The value that was dropped takes effect then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS2, Spot, fix, rename_attribute, spot, write_over
from launchlint.rules.rule import Rule
from launchlint.rules.xml.conflicting_attributes import instead_of_value, misspelt_value
from launchlint.rules.xml.missing_attribute import instead_of_required, name_instead
from launchlint.spelling import closest, surely, switched_off
from launchlint.syntax.problems import UnknownAttribute
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.ros2.names import IN_PYTHON
from launchlint.syntax.ros2.problems import UnreadAttribute

RULE = Rule("LL104", "unknown-attribute", Severity.WARNING, roslaunch="reports", fixable="safe")
_ROSMON = "rosmon-"
_OF_ROSMON = ("enable-coredumps",)
"""What rosmon reads beside the attributes that begin with its name (rosmon_core, LaunchConfig::parseNode)."""


def tell(problem: UnknownAttribute | UnreadAttribute, view: object) -> Iterator[Finding]:
    """Name the attribute that was meant."""
    if isinstance(problem, UnreadAttribute):
        if not (problem.tag == "arg" and problem.attribute == "default"):  # of an include: LL105 says what is meant
            yield _ros2(problem)
        return
    tag, name, owners = problem.tag, problem.attribute, problem.owners
    silent: bool = problem.silent
    if name.startswith(_ROSMON) or name in _OF_ROSMON:
        yield RULE.at(
            problem.origin,
            f"{name} is for rosmon: roslaunch has no such attribute",
            severity=Severity.INFO,
            label="dropped by roslaunch",
            cause=f"{tag} {name}",
        )
        return
    at = spot(view, problem.place)
    if at is not None and name in (name_instead(at.element), instead_of_required(at.element)):
        return  # LL105 tells what is meant
    if at is not None and instead_of_value(at.element) == name:
        return  # LL110 does
    off = None if owners else _switched_off(tag, name, problem.known)
    if off is not None:
        yield RULE.at(
            problem.origin,
            f"<{tag}> has no attribute {name}, so that its {off} is switched off",
            severity=Severity.INFO,
            label="dropped",
            help=f"if that is meant, remove it, or put it into a comment; else write {off}",
        )
        return
    near = closest(name, problem.known)
    sure = near is not None and not owners and surely(name, problem.known) == near
    # An attribute of somebody's own stands in many files for one reason, a slip of the pen in one.
    cause = f"{tag} {name}" if near is None else f"{problem.place.source.path} {tag} {name} {near} {sure}"
    belongs = f"{name} belongs to {_tags(owners)}" if owners else ""
    advice = f"did you mean {near}?" if near is not None else f"{belongs}: move it there, or remove it" if belongs else "remove it"
    if tag == "rosparam" and name in ("name", "value") and _is_param(at):
        near, advice = None, "write <param>: it has a name and a value"
        cause = f"{problem.place.source.path} {problem.place.source.position(problem.place.span.start).line} param"
    slip = "" if at is None else misspelt_value(at.element)
    said = "roslaunch never looks at it" if silent else "roslaunch prints a warning and drops it"
    notes = (said, belongs) if belongs and near is not None else (said,)
    yield RULE.at(
        problem.origin,
        f"<{tag}> has no attribute {name}",
        label="dropped",
        notes=notes,
        help=advice,
        cause=cause,
        shared_cause=f"{problem.place.source.path} {slip}" if slip else "",
        fix=None if near is None else _fix(name, near, sure=sure, at=at),
    )


def _is_param(at: Spot | None) -> bool:
    """Whether the element has what a ``<param>`` has, and nothing to load."""
    return at is not None and {"name", "value"} <= at.element.attributes.keys() and "file" not in at.element.attributes


def _switched_off(tag: str, name: str, free: tuple[str, ...]) -> str | None:
    """The attribute that ``name`` is, switched off; nobody does that to one that the tag has to have."""
    rule = TAGS[tag]
    off = switched_off(name, rule.known)
    return None if off in rule.required and off in free else off


def _fix(name: str, near: str, *, sure: bool, at: Spot | None) -> Fix | None:
    value = "" if at is None or at.attribute is None else at.attribute.value
    return fix(f"write {near}", rename_attribute(at, near), safe=sure, changes=f'{near}="{value[:60]}" takes effect')


def _tags(tags: tuple[str, ...]) -> str:
    words = [f"<{tag}>" for tag in tags]
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


def _ros2(problem: UnreadAttribute) -> Finding:
    tag, name, known = problem.tag, problem.attribute, problem.known
    meant = IN_PYTHON.get(name)
    near = meant if meant in known else closest(name, known)
    sure = near is not None and (near == meant or surely(name, known) == near)
    condition = name in ("if", "unless")
    if near is not None:
        advice = f"did you mean {near}?"
    elif condition:
        advice = f"put the condition on what is around the {tag}"
    elif problem.owners:
        advice = f"{name} belongs to {_tags(problem.owners[:4])}: move it there, or remove it"
    else:
        advice = f"remove it; {tag} also takes {', '.join(known)}" if known else "remove it"
    return RULE.at(
        problem.origin,
        f"{tag} takes no condition here" if condition else f"{tag} has no attribute {name}",
        severity=Severity.ERROR,
        label="unknown to launch",
        notes=("ros2 launch refuses the file",),
        help=advice,
        cause=f"{problem.place.source.path} {tag} {name}",
        fix=None if near is None else fix(f"write {near}", write_over(problem.place, name, near), safe=sure, changes=LOADS2),
    )
