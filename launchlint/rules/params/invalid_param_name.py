"""A parameter has a name that is no ROS name.

A name begins with a letter (or `/` or `~`) and goes on with letters, digits, `_` and `/`. Hyphens, blanks, dots and
letters outside ASCII are not allowed. roslaunch sets the parameter all the same, and rospy asks for any name; roscpp checks it first.

Where the node that the parameter is for is a C++ node, it cannot read it; where it is a Python node that may read it nothing is said.
Where the library does not say which of the two will read it, letters and digits outside ASCII, which rospy takes for part of a name, are
an info.

## Why it matters

A C++ node that asks for the parameter ends with an InvalidNameException, and it cannot be set with `_name:=value` either.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <param name="odom-frame" value="odom"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <param name="odom_frame" value="odom"/>
  </node>
</launch>
```
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator

from launchlint.evaluate.names import is_legal
from launchlint.evaluate.problems import InvalidParamName
from launchlint.finding import Finding, Severity
from launchlint.graph.connections import ConnectionGraph, Instance
from launchlint.late import late
from launchlint.model import ParameterSetting
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL510", "invalid-param-name", Severity.WARNING)

UNREADABLE = "roslaunch sets it, but a C++ node that asks for it ends with an InvalidNameException"
PERHAPS = "roslaunch sets it, and a Python node can read it; a C++ node that asks for it ends with an InvalidNameException"
NAMELESS = "roslaunch gives the value to the namespace itself, so that all parameters in it are in danger"
CPP = ("roscpp", "nodelet")
_ILLEGAL = late(r"[^A-Za-z0-9_/~]+", re.ASCII)


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at every ``<param>`` of such a name (ros::names::validate; rospy's get_param takes any)."""
    problems = [*view.launch.noticed(InvalidParamName)]
    if not problems:
        return
    settings, clients = _Settings(view.graph), _Clients(view.graph)
    told: dict[tuple[str, int], set[str]] = {}  # a file that is included often sets the same params often
    for problem in problems:
        name = problem.name
        bare = name.lstrip("~/")
        if bare and name.startswith("/") and _ILLEGAL.search(name) is None:
            continue  # only the first character of what is written may not be a digit
        readers = told.get(problem.place.key)
        if readers is None:
            readers = {client for setting in settings.made_at(problem) for client in clients.of(setting)}
            told[problem.place.key] = readers
        if bare and "rospy" in readers:
            yield RULE.fine(problem.origin)
        else:
            yield _finding(problem, name, bare, sure=not readers.isdisjoint(CPP))


class _Settings:
    """The settings of a launch by where they are written."""

    def __init__(self, graph: ConnectionGraph) -> None:
        self._by_file: dict[str, dict[int, list[ParameterSetting]]] = {}
        for setting in graph.launch.parameter_settings:
            if setting.tag == "param":
                source, span = setting.origin.place
                self._by_file.setdefault(source.path, {}).setdefault(span.start, []).append(setting)
        self._starts = {path: sorted(settings) for path, settings in self._by_file.items()}

    def made_at(self, problem: InvalidParamName) -> list[ParameterSetting]:
        """What the element sets in whose start tag the problem lies."""
        source, span = problem.place
        starts = self._starts.get(source.path, [])
        index = bisect_right(starts, span.start)
        found = self._by_file[source.path][starts[index - 1]] if index else []
        return [setting for setting in found if span.start < setting.origin.place.span.end]


class _Clients:
    """The client libraries of the nodes that may read a parameter, as far as they are known."""

    def __init__(self, graph: ConnectionGraph) -> None:
        self._graph = graph
        self._instances = {instance.name: instance for instance in graph.instances}

    def of(self, setting: ParameterSetting) -> Iterator[str]:
        """Those of the node that it is private to, else of the nodes that are known to read it."""
        readings = self._graph.readers.get(setting.name, ())
        names = {reading.node for reading in readings}
        for name in names if setting.node is None else (setting.node,):
            instance = self._instances.get(name)
            if instance is not None:
                yield _client(instance, reads=name in names, name=setting.name)


def _client(instance: Instance, *, reads: bool, name: str) -> str:
    """The client library of a node; of a Python node only where the node reads the param, or may: nobody puts a blank into a name."""
    client = "rospy" if not instance.client and instance.node.executable.endswith(".py") else instance.client
    may = instance.may_have_more("params") and not any(map(str.isspace, name))
    return client if client != "rospy" or reads or may else ""


def _finding(problem: InvalidParamName, name: str, bare: str, *, sure: bool) -> Finding:
    found = _ILLEGAL.search(name)
    if not bare:
        message, help_ = "the parameter has no name", "give it a name"
    elif found is not None:
        what = "a blank" if found[0][0] == " " else f"the character {found[0][0]!r}"
        message, help_ = f"{name!r} is no parameter name: {what} is not allowed", f"write {_legal(name)}"
    else:
        message, help_ = f"{name!r} is no parameter name: it begins with {bare[0]!r}", "begin it with a letter"
    return RULE.at(
        problem.origin,
        message,
        severity=Severity.INFO if bare and not sure and is_legal(bare) else None,
        label="no ROS name",
        related=problem.related,
        notes=(NAMELESS if not bare else UNREADABLE if sure else PERHAPS,),
        help=help_ if sure or not bare else f"{help_}, unless only Python nodes read it",
        cause="" if sure or not bare else name,
    )


def _legal(name: str) -> str:
    return re.sub("_{2,}", "_", _ILLEGAL.sub("_", name)).strip("_") or "a name of letters, digits and _"
