"""What is said of args, includes and expressions of ROS 2 launch files: the mistakes are those of ROS 1, what launch does is its own."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from launchlint.evaluate.problems import (
    EnvUnset,
    EvalError,
    EvalNotCovered,
    IncludeCycle,
    IncludeMissingArg,
    IncludeNotFound,
    IncludeNotLoadable,
    RequiredArgUnset,
    UndeclaredArg,
)
from launchlint.finding import Finding, Severity
from launchlint.model import ROS2
from launchlint.rules.judging.broken_call import broken_call
from launchlint.rules.judging.near_launch_file import near_launch_file
from launchlint.rules.judging.never_declared import never_declared
from launchlint.rules.judging.other_file import is_inside, root_of, shown
from launchlint.rules.judging.out_of_share import leads_out, where
from launchlint.rules.judging.template import has_placeholder
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at
from launchlint.source import Place
from launchlint.spelling import closest, surely

_MOST_PLACES = 3
_OWN = ("ros_namespace", "launch-prefix")
"""Launch configurations that are launch's own."""


def undeclared(problem: UndeclaredArg, rule: Rule, view: LaunchView) -> Iterator[Finding]:
    """``$(var …)`` of something that nothing has set."""
    name = problem.name
    if declared_below(problem, view) is not None:
        return  # LL205 says so
    known = tuple(each for each in problem.known if not each.startswith("anon") and each not in _OWN)
    meant = surely(name, known)
    near = meant or closest(name, known)
    elsewhere = problem.elsewhere
    certain = meant is not None or view.declared_entry or bool(elsewhere)
    refused = Severity.ERROR if problem.refused else Severity.WARNING
    message, advice = f"{name} is not set", f"declare it above, or write {words_at(problem.origin).call('var', name, 'DEFAULT')}"
    if elsewhere:
        message, advice = _set_elsewhere(problem)
        if any(isinstance(each, RequiredArgUnset) for each in view.launch.problems):
            refused = Severity.WARNING  # it is only started with args that it asks for, and by who knows them
    elif near is not None:
        advice = f"did you mean {near}?"
    yield rule.at(
        problem.origin,
        message if certain else f"{message}: only the command line can give it, with {name}:=…",
        severity=refused if certain else Severity.INFO,
        related=tuple((place, "set here") for place in elsewhere[:_MOST_PLACES]),
        notes=(f"{'' if certain else 'without it '}ros2 launch stops here with: launch configuration '{name}' does not exist",),
        help=advice,
        topic=name,
        shared_cause=never_declared(problem.place.source.path, name if certain or near is not None else ""),
    )


def declared_below(problem: UndeclaredArg, view: LaunchView) -> Place | None:
    """Where the file declares the arg that it reads too early; None where it does not, or others may have set it before."""
    place = problem.place
    if view.launch.dialect != ROS2 or any(problem.name == name for name, _ in view.launch.given):
        return None
    declared = (each.origin for each in view.launch.declared if each.name == problem.name)
    below = (each.place for each in declared if each.step is problem.origin.step and each.place.source is place.source)
    return next((each for each in below if each.span.start > place.span.start), None)


def _set_elsewhere(problem: UndeclaredArg) -> tuple[str, str]:
    """What is wrong where the file does set the configuration, and what to do."""
    name, read, words = problem.name, problem.place.span.start, words_at(problem.origin)
    if all(place.span.start > read for place in problem.elsewhere):
        return f"{name} is not set yet: launch executes the file from top to bottom, and sets it further down", "move what sets it up"
    return (
        f"{name} is not set here: a group keeps what is set in it for itself, and with forwarding off it lets nothing in",
        f"set it in the same group, before it is read; a group with {words.set_to('forwarding', 'false')} needs it in {words.tag('keep')}",
    )


def required(problem: RequiredArgUnset, rule: Rule, view: LaunchView) -> Iterator[Finding]:
    """An arg of the entry file without a default."""
    name, path = problem.name, view.launch.entry.path
    if view.declared_entry:
        severity, message = Severity.ERROR, f"the configuration starts {path} without the arg {name}, which it requires"
        advice = f"give it a default, or add {name} to the args of this entry in .launchlint.yaml"
    else:
        severity, message = Severity.INFO, f"{path} can only be started with {name}:=…"
        advice = f"give it a default if there is a usual value; check it with --arg {name}:=VALUE"
    stops = f"without it ros2 launch stops with: Included launch description missing required argument '{name}'"
    yield rule.at(problem.origin, message, severity=severity, label="no default", related=problem.related, notes=(stops,), help=advice,
                  topic=name)  # fmt: skip


def missing(problem: IncludeMissingArg, rule: Rule, view: LaunchView) -> Iterator[Finding]:
    """An arg that an include does not pass; all of one include are told together."""
    together = view.beside(problem)
    names = list(dict.fromkeys(each.name for each in together)) or [problem.name]
    if problem.name != names[0]:
        return  # told with the first
    listed, several = ", ".join(names), len(names) > 1
    slips = [f"{near} meant to be {name}" for name in names if (near := closest(name, problem.passed)) is not None]
    it, default = ("them", "them defaults") if several else ("it", "it a default")
    advice = f"pass {it} in the include, or give {default} in {problem.file}"
    yield rule.at(
        problem.origin,
        f"{problem.file} needs the {'args' if several else 'arg'} {listed}, which {'are' if several else 'is'} not passed",
        label=f"included without {it}",
        related=tuple(dict.fromkeys(each for one in together for each in one.related)) or problem.related,
        notes=(f"ros2 launch stops with: Included launch description missing required argument '{names[0]}'",),
        help=f"is {', and '.join(slips)}? Else {advice}" if slips else advice,
        topic=listed,
        shared_cause=broken_call(problem.file, listed),
    )


_HOMES = ("/home/", "/Users/", "/root/", "/opt/ros/")
"""Where files lie of one person, and of an installed ROS: LL406 tells such paths, and that machine has the file."""


def _is_elsewhere(file: str, view: LaunchView) -> bool:
    """Whether it lies in somebody's home, or in a directory that a container of the workspace has (LL406)."""
    return file.startswith(_HOMES) or f"/{file.split('/')[1]}" in view.packages.container_directories()


def not_found(problem: IncludeNotFound | IncludeNotLoadable, rule: Rule, view: LaunchView) -> Iterator[Finding]:
    """An included file that is not there."""
    from launchlint.workspace.ament.shares import may_be_installed
    from launchlint.workspace.templates import template_of

    file, source = problem.file, problem.place.source
    if has_placeholder(file) or isinstance(problem, IncludeNotLoadable):
        return
    relative = not posixpath.isabs(file)
    named = file if relative else shown(file, root_of(source))
    notes = [f"ros2 launch stops with: No such file or directory: '{named}'"]
    if problem.reason != "there is no such file":
        notes = [f"{named}: {problem.reason}"]
    if relative and file:
        notes.append("a relative name counts from the directory ros2 launch is called in, not from this file")
    if problem.environment:
        notes.append("the name hangs on an environment variable, which may be another one on the robot")
    perhaps = "" if relative or not file else may_be_installed(view.packages, file)
    if perhaps:
        notes.append(f"the build may install it to this place: {perhaps}")
    template = None if relative or not file else template_of(file)
    if template is not None:
        notes.append(f"{shown(template, root_of(source))} lies beside it: a template from which it may be made")
    base = posixpath.basename(file)
    others = list(view.packages.colcon.launch_files(base)) if base and not relative else []
    advice = "correct the name, or create the file"
    if relative and file:
        words = words_at(problem.place)
        advice = f"write {words.under('dirname', '', file)}, or find it by its package: {words.under('find-pkg-share', 'PACKAGE', '…')}"
    elif len(others) == 1:
        advice = f"did you mean {shown(others[0], root_of(source))}?"
    elif not relative and file and (near := near_launch_file(file, {posixpath.abspath(source.file), *view.included_by.get(source, ())})):
        advice = f"did you mean {near}?"
    left = leads_out(file, problem.place, view.packages)
    if left:
        notes.append(where(left))
    outside = not relative and not is_inside(file, (*view.packages.workspaces, root_of(source) or "/nowhere")) and _is_elsewhere(file, view)
    elsewhere = (
        left or outside or (relative and source.path.endswith(".py"))
    )  # people start such files from the workspace they are made for
    yield rule.at(
        problem.origin,
        f"the included file {named} does not exist" if file else "the name of the included file is empty",
        severity=Severity.INFO if problem.environment or elsewhere or template else Severity.WARNING if perhaps else None,
        label="not found",
        notes=tuple(notes),
        help=advice,
        cause=f"{source.path} {file}" if relative else f"not there {file}",
        about=(named,) if file else (),
    )


def cycle(problem: IncludeCycle, rule: Rule) -> Iterator[Finding]:
    """Files that include each other."""
    files = problem.cycle
    message = f"{files[-1]} includes itself" if len(files) < 3 else f"{files[-1]} includes itself through {files[-2]}"
    yield rule.at(
        problem.origin,
        message if problem.endless else f"includes are nested {problem.depth} deep here",
        label="this closes the circle" if problem.endless else "too deep",
        notes=(f"the includes go {' → '.join(files)}", "ros2 launch stops with: maximum recursion depth exceeded"),
        help="take one of these includes out, or give it a condition that ends",
    )


def environment(problem: EnvUnset, rule: Rule, view: LaunchView, reason: str, slip: str | None) -> Iterator[Finding]:
    """``$(env …)`` of a variable that is not set; ``reason`` is why that may be meant, ``slip`` the variable that was meant."""
    name = problem.variable
    written = words_at(problem.origin).call("env", name, "DEFAULT")
    stops = f"ros2 launch stops with: environment variable '{name}' does not exist"
    place = problem.place
    if place.source.path.endswith(".py") and place.text.startswith("os."):
        written = f"os.environ.get('{name}', 'DEFAULT')"
        stops = f"ros2 launch stops with: KeyError: '{name}'"
    advice = f"write {written}, or give it a value under env: in .launchlint.yaml if it is always set"
    yield rule.at(
        problem.origin,
        f"the environment variable {name} is not set here",
        severity=Severity.INFO if reason else None,
        notes=(f"where it is not set {stops}", *([reason] if reason else [])),
        help=advice if slip is None else f"did you mean {slip}?",
        topic=name,
        cause=name,
    )


def takes_text_for_name(problem: EvalError | EvalNotCovered) -> bool:
    """Whether an expression of a launch file in Python fails since the ``true`` or ``false`` that it gets is no name of Python."""
    if not isinstance(problem, EvalError) or not problem.place.source.path.endswith(".py"):
        return False
    return "'true'" in problem.reason or "'false'" in problem.reason


def expression(problem: EvalError | EvalNotCovered, rule: Rule) -> Iterator[Finding]:
    """``$(eval …)`` that fails, or that is not computed."""
    words = words_at(problem.origin)
    if isinstance(problem, EvalNotCovered):
        yield rule.at(
            problem.origin,
            f"launchlint does not compute this {words.call('eval', '…')}: {problem.reason}",
            severity=Severity.INFO,
            notes=("what depends on it is not checked any further",),
        )
        return
    text = problem.expression
    advice = ""
    if "'true'" in problem.reason or "'false'" in problem.reason:
        advice = f"Python writes True and False; to compare a launch configuration with a text: {words.equals('x', 'true')}"
    elif "not defined" in problem.reason:
        advice = f"an expression knows no launch configurations: put quotes around {words.call('var', '…')} if it is a text"
    elif "SyntaxError" in problem.reason:
        advice = "write it as one expression of Python"
    yield rule.at(
        problem.origin,
        f"{words.call('eval', '…')} fails: {problem.reason}",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        notes=(f"what Python gets is {text[:80]}", "ros2 launch stops with the same error of Python's"),
        help=advice,
    )
