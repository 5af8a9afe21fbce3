"""`$(dirname)` or `$(filename)` stands after an include, and means the included file.

What it does: it looks for these two where the last include that was executed before them is of a file in another folder (for `$(filename)`:
of any file), up to and including args that this include itself is given.

## Why it matters

`ros2 launch` sets both when it executes an include, and nothing puts them back. What comes after looks for its files in the folder of the
included file: it does not find them, or finds others of the same name.

## Example

```xml launch/main.launch.xml
<launch>
  <include file="$(dirname)/sensors/camera.launch.xml"/>
  <node pkg="demo_nodes_cpp" exec="talker">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```xml launch/sensors/camera.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="listener"/>
</launch>
```

```yaml launch/talker.yaml
/**:
  ros__parameters:
    rate: 5
```

## Use instead

```xml launch/main.launch.xml
<launch>
  <let name="here" value="$(dirname)"/>
  <include file="$(var here)/sensors/camera.launch.xml"/>
  <node pkg="demo_nodes_cpp" exec="talker">
    <param from="$(var here)/talker.yaml"/>
  </node>
</launch>
```

```xml launch/sensors/camera.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="listener"/>
</launch>
```

```yaml launch/talker.yaml
/**:
  ros__parameters:
    rate: 5
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.problems import DirectoryOfAnother
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.wording import words_at

RULE = Rule("LL916", "dirname-after-include", Severity.ERROR)


def tell(problem: DirectoryOfAnother, view: object) -> Iterator[Finding]:
    """Say what it means there (launch.actions.IncludeLaunchDescription sets ``current_launch_file_directory``)."""
    words = words_at(problem.origin)
    word = words.call(problem.substitution)
    kept = words.written("let", {"name": "here", "value": word}, f"SetLaunchConfiguration('here', {word})")
    what = "the folder of" if problem.substitution == "dirname" else "which is"
    yield RULE.at(
        problem.origin,
        f"{word} is {problem.means} here, {what} the file included before, not this one",
        label=f"{problem.means} at this point",
        notes=("an include sets it, and nothing puts it back",),
        help=f"keep it before the first include: {kept}, and write {words.call('var', 'here')} from there on",
        cause=f"{problem.place.source.path} {problem.substitution}",
    )
