"""A spawner names a controller that its controller manager is not told the type of.

What it does: it reads the names on the command line of each `spawner` of `controller_manager`, and looks for `NAME.type` among the params
of the manager (`ros2_control_node`) that it asks, where those are known. Nothing is said where the manager is not in this launch, as with
a simulator, where it is given no controllers at all, and where the spawner brings a type or a file of params itself.

## Why it matters

The manager refuses to load the controller, since it does not know what it is. The spawner ends with an error, and the robot does not move.

## Example

```xml example.launch.xml
<launch>
  <node pkg="controller_manager" exec="ros2_control_node" name="controller_manager">
    <param name="diff_drive_controller">
      <param name="type" value="diff_drive_controller/DiffDriveController"/>
    </param>
  </node>
  <node pkg="controller_manager" exec="spawner" args="diffdrive_controller"/>
</launch>
```

## Use instead

```xml example.launch.xml
<launch>
  <node pkg="controller_manager" exec="ros2_control_node" name="controller_manager">
    <param name="diff_drive_controller">
      <param name="type" value="diff_drive_controller/DiffDriveController"/>
    </param>
  </node>
  <node pkg="controller_manager" exec="spawner" args="diff_drive_controller"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.model import Node, UnknownText
from launchlint.plural import listed
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin
from launchlint.spelling import closest

RULE = Rule("LL941", "controller-not-configured", Severity.ERROR)
_PACKAGE = "controller_manager"
_MANAGER = "controller_manager"
"""What ``ros2_control_node`` calls itself, and whom a spawner asks unless it is told."""
_ASKED = ("-c", "--controller-manager")
_PLACED = ("-n", "--namespace")
_WITH_VALUE = ("--controller-manager-timeout", "--switch-timeout", "--service-call-timeout")
_ALONE = ("--load-only", "--stopped", "--inactive", "-u", "--unload-on-kill", "--activate-as-group")
_MOST_NAMES = 6
_MOST_TOLD = 20


def check(view: LaunchView) -> Iterator[Finding]:
    """Look at every spawner (controller_manager::ControllerManager::load_controller)."""
    managers = [node for node in view.launch.nodes if (node.package, node.executable) == (_PACKAGE, "ros2_control_node")]
    configured = {name: known for node in managers for name, known in _configured(node)}
    for node in view.launch.nodes:
        if not configured or (node.package, node.executable) != (_PACKAGE, "spawner") or not node.knows("arguments", "namespace"):
            continue
        asked = _asked(() if node.process is None else node.process.arguments, node.namespace)
        known = configured.get(asked[0]) if asked is not None else None
        if asked is None or not known:
            continue
        assumed = any(each.assumed for each in (*node.conditions, *(each for manager in managers for each in manager.conditions)))
        for name in asked[1][:_MOST_TOLD]:
            if name not in known:
                near = closest(name, known)
                yield RULE.at(
                    Origin(node.places.get("arguments", node.origin.place), node.origin.step),
                    f"{asked[0]} is not told the type of the controller {name}",
                    severity=Severity.WARNING if assumed else None,
                    label="to be spawned",
                    notes=(
                        f"its params give the types of {listed(sorted(known), _MOST_NAMES)}",
                        "the spawner fails, and nothing is controlled by it",
                    ),
                    help=f"did you mean {near}?" if near is not None else f"set the param {name}.type of {asked[0]}",
                    cause=f"{asked[0]} {name}",
                )


def _configured(node: Node) -> Iterator[tuple[str, frozenset[str]]]:
    """The full name of a manager, and the controllers whose types it is told, where all of its params are known."""
    if not node.knows("name", "namespace"):
        return
    full = f"{node.namespace}{node.name or _MANAGER}"
    own = node.own_as(full).own if node.own_as is not None and not node.name else node.own
    if own is not None:
        yield full, frozenset(name.removesuffix(".type") for name in own if name.endswith(".type"))


def _asked(words: Sequence[str], namespace: str) -> tuple[str, list[str]] | None:
    """The manager that a spawner asks, and the controllers it names; None where that is not known, or it says more of them itself."""
    names: list[str] = []
    manager, place = _MANAGER, namespace.strip("/")
    waiting = iter(words)
    for word in waiting:
        option, equals, given = word.partition("=") if word.startswith("--") else (word, "", "")
        if isinstance(word, UnknownText):
            return None
        if option in (*_ASKED, *_PLACED, *_WITH_VALUE):
            value = given if equals else next(waiting, "")
            if isinstance(value, UnknownText) or not value:
                return None
            manager = value if option in _ASKED else manager
            place = value.strip("/") if option in _PLACED else place
        elif word == "--ros-args":
            break
        elif word.startswith("-"):
            if word not in _ALONE:
                return None
        else:
            names.append(word)
    full = manager if manager.startswith("/") else f"/{place}/{manager}" if place else f"/{manager}"
    return full, names
