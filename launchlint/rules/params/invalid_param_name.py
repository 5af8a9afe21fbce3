"""A parameter has a name that is no ROS name.

A name begins with a letter (or `/` or `~`) and goes on with letters, digits, `_` and `/`. Hyphens, blanks, dots and
letters outside ASCII are not allowed.

## Why it matters

roslaunch sets the parameter all the same, but a C++ node that asks for it ends with an InvalidNameException.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <param name="odom-frame" value="odom"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <param name="odom_frame" value="odom"/>
  </node>
</launch>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule

RULE = Rule("LL510", "invalid-param-name", Severity.WARNING)

UNREADABLE = "roslaunch sets it, but a C++ node that asks for it ends with an InvalidNameException"
NAMELESS = "roslaunch gives the value to the namespace itself, so that all parameters in it are in danger"
_ILLEGAL = re.compile(r"[^A-Za-z0-9_/~]+", re.ASCII)


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Name the character at fault; facts: ``name``."""
    name = problem.facts["name"]
    bare = name.lstrip("~/")
    found = _ILLEGAL.search(name)
    if not bare:
        message, help_ = "the parameter has no name", "give it a name"
    elif found is not None:
        what = "a blank" if found[0][0] == " " else f"the character {found[0][0]!r}"
        message, help_ = f"{name!r} is no parameter name: {what} is not allowed", f"write {_legal(name)}"
    else:
        message, help_ = f"{name!r} is no parameter name: it begins with {bare[0]!r}", "begin it with a letter"
    yield RULE.at(
        problem.origin,
        message,
        label="no ROS name",
        related=problem.related,
        notes=(UNREADABLE if bare else NAMELESS,),
        help=help_,
    )


def _legal(name: str) -> str:
    return re.sub("_{2,}", "_", _ILLEGAL.sub("_", name)).strip("_") or "a name of letters, digits and _"
