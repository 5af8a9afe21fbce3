'''A file that a parameter is read from is not there.

That is the `file` of a `<rosparam>`, and the `textfile` or `binfile` of a `<param>`. The path is checked as it is after
substitution, and the file has to be readable UTF-8 text (but for `binfile`).

## Why it matters

roslaunch refuses the launch file, and with it every launch file that includes it.

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
'''

from __future__ import annotations

import os
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.nearby import nearby_file
from launchlint.rules.other_file import root_of, shown
from launchlint.rules.rule import Rule

RULE = Rule("LL502", "param-file-missing", Severity.ERROR, roslaunch="refuses")


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Say why it cannot be read and which file is near; facts: ``attribute``, ``file``, ``reason``."""
    file, reason = problem.facts["file"], problem.facts["reason"]
    root = root_of(problem.place.source)
    near = nearby_file(file)
    name = os.path.basename(file) or file
    missing = reason == "there is no such file"
    said = f"roslaunch stops, since it finds no file {shown(file, root)}" if missing else "roslaunch refuses the file"
    yield RULE.at(
        problem.origin,
        f"the file {name} does not exist" if missing else f"the file {name} cannot be read: {reason}",
        label="no such file" if missing else "",
        related=problem.related,
        notes=(said,),
        help=f"did you mean {near}?" if near else _advice(file, root, missing=missing),
    )


def _advice(file: str, root: str, *, missing: bool) -> str:
    if not os.path.isabs(file):
        return "start the path with $(find PACKAGE) or $(dirname): a relative path is looked up where roslaunch is started"
    if not missing:
        return "give the path of a text file in UTF-8"
    directory = os.path.dirname(file)
    if not os.path.isdir(directory):
        return f"correct the path: there is no directory {shown(directory, root)} either"
    return "correct the path, or add the file"
