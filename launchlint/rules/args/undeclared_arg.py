"""A `$(arg …)` names an arg that is declared nowhere.

It is an error where a declared name is one slip away, where an `<include>` enters the file and does not pass the arg (nothing
can then give it), and where the configuration says how the file is started (`entries`) and leaves the arg out. Else it is
information: roslaunch takes an arg from the command line whether it is declared or not, and some files are started just so.
In an `$(eval …)` it is a warning: the name may be a text without its quotes.

An arg that is declared, but only under conditions none of which holds, is information too, where other args would make one hold, and at
most a warning where environment variables would, which may be set on the robot. What is
proposed then is a declaration for the case in which none holds: a plain one beside the others would make roslaunch stop in the other cases.

In ROS 2 it is an error where a name that is set is one slip away, and where the file itself sets the name, but further down, or in a
group that keeps it for itself, or outside of one that lets nothing in (a warning if the file asks for args, so that nobody starts it
as it is). Else it is information: `ros2 launch` takes any name from the command line, and files that are only included read what those
set that include them.

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

from collections.abc import Iterator, Sequence
from itertools import starmap

from launchlint.evaluate.problems import UndeclaredArg
from launchlint.evaluate.ros1.values import automatic, shown
from launchlint.finding import Finding, Fix, Severity
from launchlint.late import late
from launchlint.rules.edits import LOADS, fix, replace, spot
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.never_declared import all_undeclared, never_declared
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.source import Place
from launchlint.spelling import closest, is_part, surely
from launchlint.syntax.ros1.substitutions import parts_of

RULE = Rule("LL201", "undeclared-arg", Severity.ERROR, roslaunch="refuses", fixable="unsafe")

_OPPOSITE = {"if": "unless", "unless": "if"}
_ASKED = ("env", "optenv")
_MOST_ASKED = 3
_MOST_NAMED = 6
_PLAIN = late(r"[\w./+ -]*")


def tell(problem: UndeclaredArg, view: LaunchView) -> Iterator[Finding]:
    """Name the arg that was meant, or say who has to give it."""
    if of_ros2(view):
        from launchlint.rules.judging import ros2_args as ros2_words

        yield from ros2_words.undeclared(problem, RULE, view)
        return
    name, known = problem.name, problem.known
    declare = _for_the_other_case(problem, view) or f'declare it above: <arg name="{name}" default="…"/>'
    meant = surely(name, known)
    near = meant or closest(name, known) or _longer(name, known)
    switches = _switches(problem, view)
    if switches and not view.declared_entry:
        yield _under_conditions(problem, switches, declare)
        return
    entered = _entered_without(problem, view)
    variables = _variables(problem, view)
    if meant is not None or entered or view.declared_entry:
        severity = Severity.ERROR if problem.refused and not variables else Severity.WARNING
        message = f"the arg {name} is not declared" if not problem.skipped else _only_under_conditions(problem)
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
        if problem.skipped:
            message = _only_under_conditions(problem)
        note, help_ = "without it roslaunch stops here", declare
    yield RULE.at(
        problem.origin,
        message,
        severity=severity,
        related=_related(problem),
        notes=(note, *([f"what declares it hangs on {' and '.join(variables)}, which the robot may set"] if variables else [])),
        help=help_,
        topic=name,
        shared_cause=never_declared(problem.place.source.path, "" if near is None and severity is Severity.ERROR else name),
        fix=None if near is None or severity is Severity.INFO or help_ != f"did you mean {near}?" else _fix(problem, view, name, near),
    )


def _longer(name: str, known: Sequence[str]) -> str | None:
    """The only arg that is declared under the name with a word put to it."""
    longer = [each for each in known if is_part(name, each)]
    return longer[0] if len(longer) == 1 else None


def together(findings: Sequence[Finding]) -> Finding:
    """Those of one cause: in ROS 2 all that the file gets from those who include it."""
    names = list(dict.fromkeys(each.topic for each in findings if each.rule == RULE.id))
    if len(names) > 1 and findings[0].launcher != "roslaunch":
        return all_undeclared(findings)
    if len(names) > 1:
        told = joined([each for each in findings if each.rule == RULE.id])
        more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
        return told._replace(message=f"{len(names)} args are not declared: {', '.join(names[:_MOST_NAMED])}{more}")
    readings = [each for each in findings if each.rule == RULE.id]  # beside it LL206 tells of the declaration: not one place more
    return joined(findings)._replace(message=joined(readings).message)


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


def _variables(problem: UndeclaredArg, view: LaunchView) -> list[str]:
    """The environment variables that the conditions of the declarations of the arg ask for."""
    spots = [at for place in problem.skipped if (at := spot(view, place)) is not None]
    conditions = [parts_of(at.element.attributes[key]) for at in spots for key in _OPPOSITE if key in at.element.attributes]
    return sorted(
        {each.words[1].text for parts in conditions for each in parts.substitutions() if each.command in _ASKED and each.words[1:]}
    )


def _under_conditions(problem: UndeclaredArg, switches: tuple[str, ...], declare: str) -> Finding:
    """The arg has declarations, and a configuration in which none of them counts."""
    name = problem.name
    return RULE.at(
        problem.origin,
        _only_under_conditions(problem),
        severity=Severity.INFO,
        related=_related(problem),
        notes=(f"without it roslaunch stops here; what declares it hangs on {' and '.join(switches)}",),
        help=f"{declare}; or say in the doc of {switches[0]} what has to be chosen",
        topic=name,
    )


def _only_under_conditions(problem: UndeclaredArg) -> str:
    where = " and ".join(f"{name} is {shown(value)}" for name, value in problem.asked[:_MOST_ASKED])
    return f"the arg {problem.name} is declared under conditions only, and none of them holds{where and f' where {where}'}"


def _related(problem: UndeclaredArg) -> tuple[tuple[Place, str], ...]:
    return (*problem.related, *((place, "declared here, under a condition") for place in problem.skipped))


def _for_the_other_case(problem: UndeclaredArg, view: LaunchView) -> str:
    """How to declare an arg for the case in which none of its declarations counts; empty where it has none.

    A plain declaration beside the others would make roslaunch stop wherever one of them counts (roslaunch.loader, ``add_arg``).
    """
    if not problem.skipped:
        return ""
    name, asked = problem.name, problem.asked
    at = spot(view, problem.skipped[0])
    conditions = [] if at is None else [(key, at.element.attributes[key].value) for key in _OPPOSITE if key in at.element.attributes]
    if len(problem.skipped) == 1 and len(conditions) == 1 and '"' not in conditions[0][1]:
        ((key, text),) = conditions
        return f'declare it for the other case too: <arg name="{name}" default="…" {_OPPOSITE[key]}="{" ".join(text.split())}"/>'
    if 0 < len(asked) <= _MOST_ASKED and all(_PLAIN.fullmatch(value) for _, value in asked):
        return f'declare it for this case too: <arg name="{name}" default="…" if="$(eval {" and ".join(starmap(_holds, asked))})"/>'
    return "declare it for this case too, under a condition: roslaunch takes no second declaration where another one counts"


def _holds(name: str, value: str) -> str:
    """An expression that is true where the arg has the value (in one, roslaunch makes numbers and booleans of texts)."""
    known = automatic(value)
    asked = f"arg('{name}')"
    if isinstance(known, bool):
        return asked if known else f"not {asked}"
    return f"{asked} == {known!r}"


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
