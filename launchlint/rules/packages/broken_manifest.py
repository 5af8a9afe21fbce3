"""A `package.xml` cannot be read.

What it does: it looks at the `package.xml` of every package in the workspaces: it must be well-formed XML and have a `<name>`.

## Why it matters

rospkg, which roslaunch asks for packages, stops at the first such file. Then no `$(find …)` and no node of any package works.

## Example

```xml
<launch>
  <node pkg="my_robot" type="drive.py" name="drive"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot<name>
</package>
```

## Use instead

```xml
<launch>
  <node pkg="my_robot" type="drive.py" name="drive"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
</package>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.other_file import line_of
from launchlint.rules.rule import Rule
from launchlint.rules.view import RunView

RULE = Rule("LL704", "broken-manifest", Severity.WARNING)


def check(view: RunView) -> Iterator[Finding]:
    """Yield one finding for each package whose manifest cannot be used (rospkg.manifest.parse_manifest_file)."""
    for package in view.packages.broken():
        if not view.is_asked(package.directory):
            continue
        line = re.search(r"\bline (\d{1,7})\b", package.broken)
        reason = re.sub(r", line \d+(?:, column \d+)?", "", package.broken)
        yield RULE.at(
            line_of(package.manifest_path, view.root, int(line[1]) if line else 1),
            f"this package.xml cannot be used: {reason}",
            label="here",
            notes=("rospkg stops at such a file: then no $(find …) and no node of any package is found",),
            help="mend it, or put a CATKIN_IGNORE file beside it",
        )
