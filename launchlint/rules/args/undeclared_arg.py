"""A `$(arg …)` names an arg that is declared nowhere.

It is an error where a declared name is one slip away, where an `<include>` enters the file and does not pass the arg (nothing
can then give it), and where the configuration says how the file is started (`entries`) and leaves the arg out. Else it is
information: roslaunch takes an arg from the command line whether it is declared or not, and some files are started just so.
In an `$(eval …)` it is a warning: the name may be a text without its quotes.

## Why it matters

roslaunch refuses the file as soon as it evaluates the element without a value for the arg. In a branch that is rarely taken
that may be on the day of the demonstration. And nobody who reads `roslaunch --ros-args` learns of an arg that is not declared.

## Example

```xml
<launch>
  <arg name="scan_topic" default="scan"/>
  <remap from="scan" to="$(arg scan_topci)"/>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="scan_topic" default="scan"/>
  <remap from="scan" to="$(arg scan_topic)"/>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Fix

`--unsafe-fixes` reads the arg with the most similar name.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.problem import Problem
from launchlint.rules.edits import LOADS, fix, replace, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.spelling import closest, surely

RULE = Rule("LL201", "undeclared-arg", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Name the arg that was meant, or say who has to give it; facts: ``name``, ``known`` (args in scope)."""
    name, known = problem.facts["name"], problem.facts["known"]
    declare = f'declare it above: <arg name="{name}" default="…"/>'
    meant = surely(name, known)
    near = meant or closest(name, known)
    entered = _entered_without(problem, view)
    if meant is not None or entered or view.declared_entry:
        severity = Severity.ERROR if problem.refused else Severity.WARNING
        message = f"the arg {name} is not declared"
        note = f"roslaunch stops here, since {name} has no value"
        help_ = f"did you mean {near}?" if near is not None else declare
    elif not problem.place.text.startswith("$(arg "):
        severity, message = Severity.WARNING, f"the arg {name} is not declared"
        note = f"roslaunch stops here, since {name} has no value"
        written = problem.place.text
        if written.isidentifier():
            help_ = f"put quotes around {name} if it is a text; else {declare}"
        else:
            help_ = declare if "'" in written or '"' in written else "put quotes around the name: arg('…')"
    else:
        severity = Severity.INFO
        message = f"the arg {name} is not declared: only the command line can give it, with {name}:=…"
        note, help_ = "without it roslaunch stops here", declare
    yield RULE.at(
        problem.origin,
        message,
        severity=severity,
        related=problem.related,
        notes=(note,),
        help=help_,
        topic=name,
        fix=None if near is None or severity is Severity.INFO or help_ != f"did you mean {near}?" else _fix(problem, view, name, near),
    )


def _entered_without(problem: Problem, view: LaunchView) -> bool:
    """Whether an include on the way here keeps the arg out; through ``pass_all_args`` it can still come from the command line."""
    passing = {include.origin.place: include.pass_all_args for include in view.launch.includes}
    return any(not passing.get(place, False) for place in problem.origin.chain)


def _fix(problem: Problem, view: object, name: str, near: str) -> Fix | None:
    """The arg with the near name is read instead, where the place is the name or a substitution with it."""
    text = problem.place.text
    if text.count(name) != 1:
        return None
    return fix(f"read {near}", replace(spot(view, problem.place), problem.place, text.replace(name, near)), safe=False, changes=LOADS)
