"""A file that a parameter is read from is not there.

That is the `file` of a `<rosparam>`, and the `textfile` or `binfile` of a `<param>`. The path is checked as it is
after substitution, and the file has to be readable UTF-8 text (but for `binfile`).

## Why it matters

roslaunch refuses the launch file, and with it every launch file that includes it. It is a warning where the file may
well be there on the robot: a path made from an environment variable, one outside of all packages, and a relative one.

## Example

```xml
<launch>
  <rosparam file="$(dirname)/config/wheels.yaml"/>
</launch>
```

```yaml config/wheel.yaml
radius: 0.1
```

## Use instead

```xml
<launch>
  <rosparam file="$(dirname)/config/wheel.yaml"/>
</launch>
```

```yaml config/wheel.yaml
radius: 0.1
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL502", "param-file-missing", Severity.ERROR, roslaunch="refuses")


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Say why it cannot be read and which file is near; facts: see evaluate.ros1.missing_file, and ``environment``."""
    facts = problem.facts
    path, missing = facts["shown"], facts["missing"]
    if _is_made_up(path, problem.place.text, view.launch.given):
        return
    notes = [f"roslaunch stops, since it finds no file {path}" if missing else "roslaunch refuses the launch file"]
    if facts["relative"]:
        notes.append("a relative path is looked up where roslaunch is started, not beside this file")
    elif facts["environment"]:
        notes.append("the path is made from an environment variable, which may be another one on the robot")
    elif facts["elsewhere"]:
        notes.append("it is in no package that is here, so that it may be there on the robot")
    name = path.rpartition("/")[2] or path
    unsure = facts["relative"] or facts["environment"] or facts["elsewhere"]
    if not path:
        message = "the name of the file is empty"
    else:
        message = f"the file {name} does not exist" if missing else f"the file {name} cannot be read: {facts['reason']}"
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.WARNING if unsure and path else None,
        label="no such file" if missing else "",
        related=problem.related,
        notes=tuple(notes),
        help=_advice(facts),
    )


def _advice(facts: Mapping[str, Any]) -> str:
    if facts["near"] is not None:
        return f"did you mean {facts['near']}?"
    if facts["relative"]:
        return "start the path with $(find PACKAGE) or $(dirname)"
    if not facts["missing"]:
        return "give the path of a text file in UTF-8"
    if facts["no_directory"]:
        return f"correct the path: there is no directory {facts['no_directory']} either"
    return "correct the path, or add the file"


def _is_made_up(path: str, written: str, given: tuple[tuple[str, str], ...]) -> bool:
    """Whether the path holds a ``true`` or ``false`` that was only given to an arg to see the other side of a condition."""
    if "$(" not in written:
        return False
    words = re.split(r"[^A-Za-z0-9]+", path)
    return any(value in ("true", "false") and value in words for _, value in given)
