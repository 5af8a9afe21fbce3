"""A `package.xml` cannot be read.

What it does: it looks at the `package.xml` of every package in the workspaces: it must be well-formed XML and have a `<name>`. In a
workspace of ROS 2 what `COLCON_IGNORE` sets aside is left out, as `build` and `install` are. A file among templates is passed over, and one
without any `<package` beside which nothing says how to build it: a script makes manifests of such.

## Why it matters

rospkg, which roslaunch asks for packages, stops at the first such file. Then no `$(find …)` and no node of any package works. colcon, which
builds workspaces of ROS 2, passes over the package: it is never installed, so that ros2 launch does not find it.

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

import posixpath
import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.other_file import line_of, shown
from launchlint.rules.judging.template import is_among_templates
from launchlint.rules.rule import Rule
from launchlint.rules.view import RunView
from launchlint.workspace.looking import content, is_file
from launchlint.workspace.other_ros import is_all_of_ros2
from launchlint.workspace.package import Package

_ELEMENT = b"<package"
_BUILD_FILES = ("CMakeLists.txt", "setup.py", "setup.cfg", "Makefile")
_OF_ROSPKG = "rospkg stops at such a file: then no $(find …) and no node of any package is found"
_OF_COLCON = "colcon passes over such a package: it is not installed, and ros2 launch does not find it"

RULE = Rule("LL704", "broken-manifest", Severity.WARNING)


def check(view: RunView) -> Iterator[Finding]:
    """Yield one finding for each package whose manifest cannot be used (rospkg.manifest.parse_manifest_file)."""
    broken = [package for package in view.packages.broken() if view.is_asked(package.directory)]
    ros2 = bool(broken) and is_all_of_ros2(view.packages, [entry.path for entry in view.entries])
    for package in broken:
        if (ros2 and view.packages.colcon.is_hidden(package.directory)) or _is_for_a_script(package, view):
            continue
        line = re.search(r"\bline (\d{1,7})\b", package.broken)
        reason = re.sub(r", line \d+(?:, column \d+)?", "", package.broken)
        yield RULE.at(
            line_of(package.manifest_path, view.root, int(line[1]) if line else 1),
            f"this package.xml cannot be used: {reason}",
            label="here",
            notes=(_OF_COLCON if ros2 else _OF_ROSPKG,),
            help=f"mend it, or put a {'COLCON_IGNORE' if ros2 else 'CATKIN_IGNORE'} file beside it",
        )


def _is_for_a_script(package: Package, view: RunView) -> bool:
    """Whether no package is meant: the file lies among templates, or is a piece of a manifest beside which nothing says how to build it."""
    if is_among_templates(shown(package.directory, view.root)):
        return True
    text = content(package.manifest_path)
    if not text or not text.strip() or _ELEMENT in text:
        return False
    return not any(is_file(posixpath.join(package.directory, name)) for name in _BUILD_FILES)
