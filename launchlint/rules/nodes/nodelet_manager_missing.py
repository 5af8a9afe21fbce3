"""A nodelet is loaded into a manager that no node of the launch provides.

What it does: for every `nodelet load CLASS MANAGER` it resolves the manager's name as the node does and looks for a node of that
full name. It is an error where the name is one slip away from a node of the launch, a warning where the launch has other managers
or other nodelets spell the name a letter otherwise, and an info where it has none at all: a file may be meant to be included
beside a manager, or to be started beside one. Where it takes an arg of another value than its default to load the nodelet, each is one
level lower: whoever gives that may start a manager, too. It is silent where a launch file includes this one together with files that
are not here: these may start the manager.

## Why it matters

The nodelet waits for its manager for ever: no error, no output, no topics.

## Example

```xml
<launch>
  <node pkg="nodelet" type="nodelet" name="camera_manager" args="manager"/>
  <node pkg="nodelet" type="nodelet" name="rectify" args="load image_proc/rectify camera_manger"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="nodelet" type="nodelet" name="camera_manager" args="manager"/>
  <node pkg="nodelet" type="nodelet" name="rectify" args="load image_proc/rectify camera_manager"/>
</launch>
```
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.names import clean
from launchlint.model import Node
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin
from launchlint.spelling import closest, one_slip, slips
from launchlint.words import split_words

RULE = Rule("LL308", "nodelet-manager-missing", Severity.ERROR)


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Yield one finding for each nodelet without a manager (nodelet's ``nodelet load``, roscpp's NodeHandle.resolveName)."""
    launch = view.launch
    loading = [(node, words) for node in launch.nodes if (words := _load(node)) is not None]
    if not loading:
        return
    known = all(node.knows("name", "namespace") for node in launch.nodes)
    # A name with a slash in it is refused (LL302): once that is put right, the node is where the slash says.
    names = {clean(node.full_name) for node in launch.nodes if node.name}
    managers = {clean(node.full_name) for node in launch.nodes if _is_manager(node)}
    here = (f"the managers here are {', '.join(sorted(managers)[:6])}",) if managers else ()
    wanted = Counter(_full(node, manager) for node, manager in loading)
    nobody = wanted.keys() - names
    near: dict[str, set[str]] = {}
    for node, manager in loading:
        place = node.places.get("arguments", node.origin.place)
        full = _full(node, manager)
        if full in names:
            yield RULE.fine(place)
            continue
        if full not in near:
            near[full] = slips(full, names)
        unsure = not launch.complete or not known or not node.knows("namespace") or any(condition.assumed for condition in node.conditions)
        if not launch.complete and _slip(near[full], node) is None:
            yield RULE.fine(place)  # a file that is not here may start it
        if unsure or manager.startswith("~") or _is_remapped(node, full):
            continue
        slip = _slip(near[full], node)
        # Or the managers that other nodelets name agree, and this one differs in a letter.
        sibling = None if slip or wanted[full] > 1 else one_slip(full, nobody)
        yield RULE.at(
            Origin(place, node.origin.step),
            f"no node is called {full}, the manager of this nodelet",
            severity=_severity(slip, bool(managers) or sibling is not None, view.declared_entry, by_default=not launch.given),
            label="no such manager",
            notes=(*here, "the nodelet waits for its manager for ever"),
            help=_help(full, slip or sibling or _near(full, managers)),
        )


def _slip(near: set[str], node: Node) -> str | None:
    """The only other node of those whose names are ``near``."""
    others = near - {node.full_name}
    return others.pop() if len(others) == 1 else None


def _load(node: Node) -> str | None:
    """The manager's name as given, where the node loads a nodelet into one."""
    if node.package != "nodelet" or node.executable != "nodelet" or not node.knows("arguments", "package", "executable"):
        return None
    try:
        words = [word for word in split_words(node.arguments) if ":=" not in word]
    except ValueError:
        return None
    return words[2].rstrip("/") if len(words) > 2 and words[0] == "load" and words[2].rstrip("/") else None


def _full(node: Node, manager: str) -> str:
    return clean(manager if manager.startswith("/") else node.namespace + manager)


def _is_manager(node: Node) -> bool:
    return node.package == "nodelet" and node.executable == "nodelet" and node.arguments.split()[:1] == ["manager"]


def _is_remapped(node: Node, full: str) -> bool:
    """Whether a remap may lead the nodelet to another manager's service."""
    wanted = (full, f"{full}/load_nodelet")
    return any((remap.source if remap.source.startswith("/") else node.namespace + remap.source) in wanted for remap in node.remaps)


def _severity(slip: str | None, managers: bool, declared: bool, *, by_default: bool) -> Severity:
    """An error only where nothing has to be given for it: who switches the nodelet on may switch its manager on, too, or start one."""
    if slip is not None:
        return Severity.ERROR if by_default else Severity.WARNING
    level = Severity.WARNING if managers and by_default else Severity.INFO
    return Severity(level + 1) if declared and by_default else level


def _near(full: str, managers: set[str]) -> str | None:
    """A manager of the same name in another namespace, or one of a similar name."""
    base = full.rpartition("/")[2]
    same = sorted(name for name in managers if name.rpartition("/")[2] == base)
    return same[0] if same else closest(full, managers)


def _help(full: str, near: str | None) -> str:
    if near is None:
        return f'start a manager of that name: <node pkg="nodelet" type="nodelet" name="{full.rpartition("/")[2]}" args="manager"/>'
    return f"did you mean {near}?"
