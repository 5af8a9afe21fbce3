"""A node's script cannot be run: it lacks the executable bit or the `#!` line.

What it does: where the package of a node lies in the workspace or is installed, it looks at the script that `type` names.
Programs that CMake builds are passed over, and those that `catkin_install_python` names: ROS Noetic writes a program of that name into
the devel space, which runs the script whatever it lacks. It is an info where the first line is missing, since nothing makes up for that
elsewhere. It is an info where `install()` gives the script
the executable bit: it runs from an install space, as whoever wrote that knows, and not from a devel space. So it is where another command
of `CMakeLists.txt` names the script, as with `execute_process(COMMAND chmod +x …)`, and where a shell script or Makefile of the workspace
that copies programs to `devel/lib/` or `install/lib/` names it. All scripts that lack the same are told of together, over all packages: the
executable bit mostly gets lost for many at once.

## Why it matters

roslaunch does not find a file without the executable bit, however plain it lies there. A script without a first line such as
`#!/usr/bin/env python3` is found, but the system does not know what to run it with. Both show only when the node is started.

## Example

```xml
<launch>
  <node pkg="my_robot" type="teleop.py" name="teleop"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
```

```python scripts/teleop.py
import rospy

rospy.init_node("teleop")
```

## Use instead

```xml
<launch>
  <node pkg="my_robot" type="teleop.py" name="teleop"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
```

```python scripts/teleop.py
#!/usr/bin/env python3
import rospy

rospy.init_node("teleop")
```
"""

from __future__ import annotations

import posixpath
import sys
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.other_file import line_of, root_of, shown
from launchlint.rules.judging.package_contents import contents
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin

RULE = Rule("LL305", "not-executable", Severity.ERROR, roslaunch="reports")
_MOST_NAMED = 6


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each node or test whose script cannot be started (roslib.packages.find_node, execve(2))."""
    if sys.platform == "win32":  # files have no executable bit there
        return
    launch = view.launch
    root = root_of(launch.entry)
    for node in (*launch.nodes, *launch.tests):
        if not node.knows("package", "executable") or not node.executable.strip() or "/" in node.executable:
            continue
        package = view.packages.get(node.package, launch.entry.file)
        if package is None:
            continue
        found = contents(view.packages).executables(package)
        flaw = found.flaw(node.executable)
        if flaw is None:
            continue
        wrapped = node.executable in found.relayed  # catkin_install_python.cmake; roslib.packages.find_node looks there first
        if wrapped and not flaw.lacks_shebang:
            continue
        path = shown(flaw.path, root)
        wrong, help = _words(path, flaw.lacks_bit, flaw.lacks_shebang)
        notes = ["roslaunch loads the file and fails when it starts this node"]
        if flaw.lacks_bit:
            notes.append("roslaunch looks only at files with the executable bit")
        made = contents(view.packages).made(package).by(flaw.path)
        installed = not flaw.lacks_shebang and contents(view.packages).installs(package).makes_runnable(flaw.path)
        from launchlint.rules.judging.not_in_libexec import is_placed

        placed = flaw.lacks_bit and not flaw.lacks_shebang and is_placed(package.name, node.executable, view.packages)
        none_has_it = flaw.lacks_bit and not found.has_runnable_script
        if wrapped:
            notes = ["catkin_install_python makes a program that runs it, in a devel space of ROS Noetic; elsewhere it cannot be started"]
        elif made is not None:
            notes.append(f"the build may mend it: {made}")
        elif placed:
            notes.append(f"a script of the workspace copies programs to lib/{package.name}, perhaps this one, and with that bit")
        elif installed:
            notes.append("CMakeLists.txt installs it with that bit: it runs from an install space, not from a devel space")
        if none_has_it:
            notes.append(f"no script of the package {node.package} has the executable bit")
        doubtful = any(condition.assumed for condition in node.conditions)
        yield RULE.at(
            Origin(node.places.get("executable", node.origin.place), node.origin.step),
            f"{node.executable} cannot be run: it has {wrong}",
            severity=Severity.INFO if wrapped or installed or placed or made is not None else Severity.WARNING if doubtful else None,
            label=f"{node.executable} cannot be run",
            related=((line_of(flaw.path, root), "its first line"),),
            notes=tuple(notes),
            help=help,
            topic=path,
            cause=f"{flaw.lacks_bit} {flaw.lacks_shebang} {made is None} {installed or placed} {wrapped}",
            about=(wrong,),
        )


def together(findings: Sequence[Finding]) -> Finding:
    """The scripts that lack the same, of one package or of several."""
    whole = joined(findings)
    scripts = sorted({finding.topic for finding in findings})
    if len(scripts) < 2:
        return whole
    names = [posixpath.basename(script) for script in scripts]
    more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    wrong = findings[0].about[0]
    helps = list(dict.fromkeys(finding.help for finding in sorted(findings, key=lambda finding: finding.topic)))
    return whole._replace(
        message=f"{len(names)} scripts cannot be run: they have {wrong}: {', '.join(names[:_MOST_NAMED])}{more}",
        help=f"{helps[0]}; the same for the others" if len(helps) > 1 else helps[0],
    )


def _words(path: str, lacks_bit: bool, lacks_shebang: bool) -> tuple[str, str]:
    line = "put a line such as #!/usr/bin/env python3 at its top"
    mode = f"chmod +x {path}, and git update-index --chmod=+x {path}"
    if lacks_bit and lacks_shebang:
        return "neither the executable bit nor a #! line", f"{line}, then {mode}"
    return ("no executable bit", mode) if lacks_bit else ("no #! line", line)
