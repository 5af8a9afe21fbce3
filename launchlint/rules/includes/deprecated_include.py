"""An included file is marked as deprecated.

What it does: it speaks where the `<launch>` tag of an included file has a `deprecated` attribute, and says what that attribute
says.

## Why it matters

Who wrote the file means to take it away. roslaunch prints the same message each time.

## Example

```xml
<launch>
  <include file="$(dirname)/old.launch"/>
</launch>
```

```xml old.launch
<launch deprecated="use camera.launch">
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/camera.launch"/>
</launch>
```

```xml camera.launch
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import DeprecatedInclude
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL408", "deprecated-include", Severity.WARNING, roslaunch="reports")


def tell(problem: DeprecatedInclude, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``deprecated-include`` (roslaunch.xmlloader._launch_tag)."""
    path = shown(problem.file, root_of(problem.place.source))
    text = " ".join(problem.text.split())
    yield RULE.at(
        problem.origin,
        f"the included file {path} is deprecated: {text}",
        label="included here",
        notes=(f"roslaunch prints: [{path}] DEPRECATED: {text}",),
        help="include what took its place",
    )
