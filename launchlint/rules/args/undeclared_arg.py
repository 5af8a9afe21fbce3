"""A `$(arg …)` names an arg that is declared nowhere.

It is an error where a declared name is one slip away, where an `<include>` enters the file and does not pass the arg (nothing
can then give it), and where the configuration says how the file is started (`entries`) and leaves the arg out. Else it is
information: roslaunch takes an arg from the command line whether it is declared or not, and some files are started just so.
In an `$(eval …)` it is a warning: the name may be a text without its quotes.

An arg that is declared, but only under conditions none of which holds, is information too, where other args would make one hold.

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

from launchlint.evaluate.problems import UndeclaredArg
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, fix, replace, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.spelling import closest, surely

RULE = Rule("LL201", "undeclared-arg", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: UndeclaredArg, view: LaunchView) -> Iterator[Finding]:
    """Name the arg that was meant, or say who has to give it."""
    name, known = problem.name, problem.known
    declare = f'declare it above: <arg name="{name}" default="…"/>'
    meant = surely(name, known)
    near = meant or closest(name, known)
    switches = _switches(problem, view)
    if switches and not view.declared_entry:
        yield _under_conditions(problem, switches)
        return
    entered = _entered_without(problem, view)
    if meant is not None or entered or view.declared_entry:
        severity = Severity.ERROR if problem.refused else Severity.WARNING
        message = f"the arg {name} is not declared"
        note = f"roslaunch stops here, since {name} has no value"
        help_ = f"did you mean {near}?" if near is not None else declare
    elif problem.in_expression:
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


def _switches(problem: UndeclaredArg, view: LaunchView) -> tuple[str, ...]:
    """The args of the entry file that the conditions of the declarations of the arg hang on; ``skipped`` are their places."""
    starts = {place.key for place in problem.skipped}
    if not starts:
        return ()
    names: set[str] = set()
    for branch in view.launch.branches:
        path, span = branch.element.source.path, branch.element.span
        if any(path == at and span.start <= start < span.end for at, start in starts):
            names |= branch.steered_by
    return tuple(sorted(names))


def _under_conditions(problem: UndeclaredArg, switches: tuple[str, ...]) -> Finding:
    """The arg has declarations, and a configuration in which none of them counts."""
    name = problem.name
    return RULE.at(
        problem.origin,
        f"the arg {name} is declared under conditions only, and none of them holds",
        severity=Severity.INFO,
        related=(*problem.related, *((place, "declared here, under a condition") for place in problem.skipped)),
        notes=(f"without it roslaunch stops here; what declares it hangs on {' and '.join(switches)}",),
        help=f"declare {name} for the other cases too, or say in the doc of {switches[0]} what has to be chosen",
        topic=name,
    )


def _entered_without(problem: UndeclaredArg, view: LaunchView) -> bool:
    """Whether an include on the way here keeps the arg out; through ``pass_all_args`` it can still come from the command line."""
    passing = {include.origin.place: include.pass_all_args for include in view.launch.includes}
    return any(not passing.get(place, False) for place in problem.origin.chain)


def _fix(problem: UndeclaredArg, view: object, name: str, near: str) -> Fix | None:
    """The arg with the near name is read instead, where the place is the name or a substitution with it."""
    text = problem.place.text
    if text.count(name) != 1:
        return None
    return fix(f"read {near}", replace(spot(view, problem.place), problem.place, text.replace(name, near)), safe=False, changes=LOADS)
