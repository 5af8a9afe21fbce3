"""A nodelet is loaded of a class that no package exports.

What it does: for every `nodelet load CLASS MANAGER` and `nodelet standalone CLASS` it looks for the class in the plugin descriptions
of the packages that are here (`<nodelet plugin="…"/>` in `package.xml`), and in the library. It is an error where the class's package
is here and its descriptions do not have the class, and where the class is one slip away from one of a package whose classes the library
lists completely. It is a warning where a near name exists and there may be more classes than are known. Nothing is said of packages
that nobody here knows.

## Why it matters

roslaunch loads the file without a word. The manager then fails to load the nodelet, and its topics never appear.

## Example

```xml
<launch>
  <node pkg="nodelet" type="nodelet" name="camera_manager" args="manager"/>
  <node pkg="nodelet" type="nodelet" name="rectify" args="load image_proc/rectfy camera_manager"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="nodelet" type="nodelet" name="camera_manager" args="manager"/>
  <node pkg="nodelet" type="nodelet" name="rectify" args="load image_proc/rectify camera_manager"/>
</launch>
```

## Fix

`--unsafe-fixes` writes the class with the most similar name.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from launchlint.finding import Finding, Fix, Severity
from launchlint.graph.connections import Instance
from launchlint.model import Node
from launchlint.named_tuple import NamedTuple
from launchlint.rules.edits import fix, replace, spot
from launchlint.rules.judging.exported_nodelets import exported_nodelets
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.source import Origin
from launchlint.spelling import closest, one_slip

RULE = Rule("LL309", "unknown-nodelet-class", Severity.ERROR, fixable="unsafe")

SHORTEST_SLIP = 6
"""Below this many letters most names are one slip away from some other name."""
_MOST_NAMED = 6


class _Judgement(NamedTuple):
    """What to say of a class: ``has`` tells what there is instead, ``near`` is what was probably meant."""

    severity: Severity
    message: str
    has: str
    near: str | None


def check(view: GraphView) -> Iterator[Finding]:
    """Yield one finding for each nodelet whose class is not exported (nodelet::Loader, pluginlib::ClassLoader)."""
    for instance in view.graph.instances:
        if instance.kind != "nodelet" or view.library.nodelet(instance.program) is not None:
            continue
        judged = _judge(instance.program, view)
        if judged is None:
            continue
        node = instance.node
        yield RULE.at(
            Origin(node.places.get("arguments", node.origin.place), node.origin.step),
            judged.message,
            severity=judged.severity if instance.certain else min(judged.severity, Severity.WARNING),
            label="no such class",
            notes=(judged.has, _consequence(instance)),
            help=f"did you mean {judged.near}?"
            if judged.near
            else "correct the class, or export it in a plugin description of its package",
            cause=instance.program,
            fix=_fix(node, view, instance.program, judged.near),
        )


def _fix(node: Node, view: GraphView, name: str, near: str | None) -> Fix | None:
    place = node.places.get("arguments")
    if near is None or place is None or place.text.split().count(name) != 1 or "&" in place.text:
        return None
    words = re.sub(rf"(?<!\S){re.escape(name)}(?!\S)", lambda _: near, place.text)
    return fix(f"write {near}", replace(spot(view, place), place, words), safe=False, changes=f"the nodelet is a {near}")


def _consequence(instance: Instance) -> str:
    if instance.node.arguments.split()[:1] == ["standalone"]:
        return "roslaunch loads the file, and the node stops with an error when it starts"
    return "roslaunch loads the file, and the manager fails to load the nodelet when it starts"


def _judge(name: str, view: GraphView) -> _Judgement | None:
    prefix = name.partition("/")[0]
    package = view.packages.get(prefix, view.launch.entry.file)
    if package is not None:
        classes, reasons = exported_nodelets(view.packages).of_package(package)
        if name in classes:
            return None
        if classes:
            everywhere, readable = exported_nodelets(view.packages).everywhere()
            if name in everywhere:
                return None
            severity = Severity.WARNING if reasons or not readable else Severity.ERROR
            near = _slip(name, classes) or closest(name, classes)
            return (
                None
                if reasons and near is None
                else _Judgement(severity, f"the package {prefix} exports no nodelet {name}", _some(classes), near)
            )
    elif name in exported_nodelets(view.packages).everywhere()[0]:
        return None
    return _by_library(name, prefix, view)


def _by_library(name: str, prefix: str, view: GraphView) -> _Judgement | None:
    library = view.library
    known = library.nodelets(prefix)
    if not known:
        return _other_package(name, prefix, view)
    slip = _slip(name, known)
    if not library.has_all_nodelets(prefix):
        near = slip
        severity = Severity.WARNING
    else:
        near = slip or closest(name, known)
        severity = Severity.WARNING if slip is None else Severity.ERROR
    return None if near is None else _Judgement(severity, f"the package {prefix} is known to have no nodelet {name}", _some(known), near)


def _other_package(name: str, prefix: str, view: GraphView) -> _Judgement | None:
    """Where nobody has heard of the package: is it a slip for one that has such a class?"""
    if len(prefix) < SHORTEST_SLIP or view.packages.has(prefix) or prefix in view.packages.public:
        return None
    library = view.library
    package = _slip(prefix, library.packages())
    near = f"{package}{name[len(prefix) :]}"
    if package is None or near not in library.nodelets(package):
        return None
    severity = Severity.ERROR if library.has_all_nodelets(package) else Severity.WARNING
    return _Judgement(
        severity, f"there is no package {prefix}, and so no nodelet {name}", f"{package} {_some(library.nodelets(package))[3:]}", near
    )


def _some(classes: Sequence[str]) -> str:
    more = " …" if len(classes) > _MOST_NAMED else ""
    return f"it has: {', '.join(classes[:_MOST_NAMED])}{more}"


def _slip(name: str, names: Iterable[str]) -> str | None:
    """The one name that ``name`` is a slip for; names that differ in a digit stand for different things."""
    if len(name) < SHORTEST_SLIP:
        return None
    return one_slip(name, names)
