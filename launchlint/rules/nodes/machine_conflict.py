"""One machine name is defined twice, differently.

What it does: it compares all `<machine>` tags of a launch, includes counted in. Two equal definitions are fine.

## Why it matters

roslaunch does not choose: it refuses the whole launch.

## Example

```xml
<launch>
  <machine name="onboard" address="robot1.local" env-loader="/opt/robot/env.sh"/>
  <machine name="onboard" address="robot2.local" env-loader="/opt/robot/env.sh"/>
</launch>
```

## Use instead

```xml
<launch>
  <machine name="onboard1" address="robot1.local" env-loader="/opt/robot/env.sh"/>
  <machine name="onboard2" address="robot2.local" env-loader="/opt/robot/env.sh"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import MachineConflict
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL307", "machine-conflict", Severity.ERROR, roslaunch="refuses")

_WRITTEN = {"env_loader": "env-loader", "ssh_port": "ssh-port", "assignable": "default"}
"""Field of a machine → the attribute it comes from, where that is spelled otherwise."""


def tell(problem: MachineConflict, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``machine-conflict`` (roslaunch.config.ROSLaunchConfig.add_machine)."""
    name = problem.name
    fields = " and ".join(_WRITTEN.get(field, field) for field in problem.fields)
    yield RULE.at(
        problem.origin,
        f"the machine {name} is defined twice, with another {fields}",
        label="the second definition",
        related=problem.related,
        notes=(f"roslaunch stops with: Machine [{name}] already added and does not match duplicate entry",),
        help="name one of them otherwise, or make both definitions equal",
    )
