"""What is said of packages, names of nodes and values when a ROS 2 launch file is executed."""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.evaluate.problems import InvalidNamespace, InvalidNodeName, PackageNotFound
from launchlint.evaluate.ros2.names import name_fault, namespace_fault
from launchlint.evaluate.ros2.problems import (
    ChoiceRefused,
    CommandOption,
    InvalidPackageName,
    NodePackageMissing,
    NoDirectory,
    ParameterNotSet,
    UnsplittablePrefix,
)
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.missing_package import cause, judge
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at
from launchlint.spelling import closest
from launchlint.syntax.problems import InvalidValue

STOPS = "ros2 launch stops here"


def package(problem: PackageNotFound | NodePackageMissing | InvalidPackageName, rule: Rule, view: LaunchView) -> Iterator[Finding]:
    """A package that is not here, or cannot be one."""
    name = problem.package
    if isinstance(problem, InvalidPackageName) or (isinstance(problem, NodePackageMissing) and not problem.valid):
        yield rule.at(
            problem.origin,
            f"{name!r} is not the name of a package",
            label="no package can be called that",
            notes=(f"{STOPS}: '{name}' is not a valid package name",),
            help="write the name alone, and a path behind the substitution" if "/" in name else "",
        )
        return
    judgement = judge(name, view.packages.colcon, problem.place.source.file, problem.place.source.text)
    if judgement is None:
        return
    severity = judgement.severity if problem.refused else min(judgement.severity, Severity.WARNING)
    unsure = judgement.severity is not Severity.ERROR
    yield rule.at(
        problem.origin,
        f"the package {name} is not known" if unsure else f"there is no package {name}",
        severity=severity,
        label="not found",
        notes=(f"ros2 launch stops{' where it is missing' if unsure else ''} with: package '{name}' not found", judgement.why),
        help=judgement.help,
        topic=name,
        shared_cause=cause(name, severity, judgement),
        about=(name,),
    )


def node_name(problem: InvalidNodeName, rule: Rule) -> Iterator[Finding]:
    """A name that launch refuses."""
    name = problem.name
    good = re.sub(r"\W", "_", name.strip("/ "), flags=re.ASCII)
    good = f"n_{good}" if good[:1].isdigit() else good
    namespace, slash, base = name.rpartition("/")
    advice = f"write the name {base} and the namespace {namespace}" if slash and base and namespace else f"write {good}" if good else ""
    yield rule.at(
        problem.origin,
        f"the node name {name!r} is not valid: {name_fault(name)}" if name else "the node has an empty name",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="invalid",
        notes=(STOPS,),
        help=advice or "give it a name, or leave the name out: the node then has the one that its program chooses",
    )


def namespace(problem: InvalidNamespace, rule: Rule) -> Iterator[Finding]:
    """A namespace that launch refuses."""
    name = problem.namespace
    good = "/".join(f"n_{part}" if part[:1].isdigit() else part for part in re.sub(r"[^\w/]", "_", name, flags=re.ASCII).split("/") if part)
    fault = namespace_fault(name if name.startswith("/") else f"/{name}") or "what it makes with the pushed one is too long"
    yield rule.at(
        problem.origin,
        f"the namespace {name!r} is not valid: {fault}",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="invalid",
        notes=(STOPS,),
        help=f"write {'/' if name.startswith('/') else ''}{good}" if good else "write a name with letters, digits, _ and /",
    )


def value(problem: ChoiceRefused | InvalidValue | UnsplittablePrefix, rule: Rule) -> Iterator[Finding]:
    """A value that its place does not take."""
    if isinstance(problem, UnsplittablePrefix):
        yield rule.at(
            problem.origin,
            "the quotes in launch-prefix do not match",
            notes=(f"{STOPS}: No closing quotation",),
            help="close the quote",
        )
        return
    text, choices = problem.value[:60], problem.choices
    near = closest(problem.value, choices)
    listed = ", ".join(choices)
    if isinstance(problem, ChoiceRefused):
        message = f"the arg {problem.name} is {text!r}, which is none of its choices: {listed}"
        if not problem.given:
            message = f"the default of {problem.name}, {text!r}, is none of its choices: {listed}"
    else:
        message = f"{problem.attribute}={text!r} is not {problem.expected}"
    yield rule.at(
        problem.origin,
        message,
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        notes=(STOPS,),
        help=f"did you mean {near}?" if near is not None else f"write one of {listed}",
    )


def substitution(problem: ParameterNotSet | CommandOption | NoDirectory, rule: Rule) -> Iterator[Finding]:
    """A substitution that fails when it is performed."""
    words = words_at(problem.origin)
    if isinstance(problem, ParameterNotSet):
        message = f"no {words.tag('set_parameter')} has set {problem.name}"
        advice = f"set it above, or write {words.call('param', problem.name, 'DEFAULT')}"
    elif isinstance(problem, CommandOption):
        message = f"{problem.value!r} says nothing to {words.call('command', '…')}"
        advice = f"write one of {', '.join(problem.known)}, or put the whole command in quotes"
    else:
        message, advice = f"there is no file for {words.call(problem.substitution)}", ""
    severity = Severity.ERROR if problem.refused else Severity.WARNING
    yield rule.at(problem.origin, message, severity=severity, notes=(STOPS,), help=advice)
