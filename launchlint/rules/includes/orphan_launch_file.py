"""A launch file that nothing includes and that cannot be started by itself.

What it does: it looks for files that need args which only an including file would give, where no file of the run includes them.
Off by default: files are also included from other repositories.

## Why it matters

Such a file is often left over. Or the file that included it now names another one.

## Example

```xml
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="$(arg camera)"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="camera" default="camera"/>
  <node pkg="usb_cam" type="usb_cam_node" name="$(arg camera)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Location, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import RunView

RULE = Rule("LL409", "orphan-launch-file", Severity.INFO, default=False)


def check(view: RunView) -> Iterator[Finding]:
    """Yield one finding for each file that needs a caller and has none."""
    included = {path for entry in view.entries for path in entry.included if path != entry.path}
    roots: dict[str, Location] = {path: root for entry in view.entries for path, root in entry.roots}
    for entry in view.entries:
        if not entry.undeclared_args or entry.path in included or entry.path not in roots:
            continue
        yield Finding(
            RULE.id,
            RULE.name,
            RULE.severity,
            roots[entry.path],
            "nothing includes this file, and it does not load alone",
            label="this file",
            notes=("it reads args that it does not declare, and that only an including file would give",),
            help="remove it, include it, or give its args defaults; or list it under entries with its args",
            element=entry.path,
        )
