"""What is said of nodes of one name in ROS 2: launch warns, and starts them all."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import DuplicateNode
from launchlint.evaluate.ros2.problems import DefaultOverruled
from launchlint.finding import Finding, Severity
from launchlint.model import Node
from launchlint.rules.judging.included_twice import ways
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at
from launchlint.source import Place


def one_name(problem: DuplicateNode, rule: Rule, view: LaunchView) -> Iterator[Finding]:
    """Two nodes that would be one to everybody who asks for it by its name."""
    name, first, second = problem.name, problem.first, problem.second
    twice = first.origin.place == second.origin.place
    if not twice and any(_renames(each, node) for each in view.launch.noticed(DefaultOverruled) for node in (first, second)):
        return  # LL911 says that the default for this name does not count
    tried = view.tried
    notes = [f"ros2 launch warns that there are 2 nodes with the name {name}: services and params of such nodes reach any of them"]
    if tried:
        notes.append(f"only with {tried}, which is not what this launch file does by itself")
    advice = "rename one, or put them into different namespaces"
    by_program = twice and not problem.origin.chain  # a loop, or a function that is called twice: nothing is included twice
    if by_program:
        advice = "let each have a name, or a namespace, of its own"
    elif twice:
        advice = f"include the file once, or push a namespace in a {words_at(problem.origin).tag('group')} around each include"
    yield rule.at(
        problem.origin,
        f"the node {name} is started twice" if twice else f"two nodes are named {name}",
        severity=Severity.INFO if tried else Severity.WARNING,
        label="both are made here" if by_program else "its file is included twice" if twice else "the second one",
        related=((*problem.related, *_way_to(first, second)) if not twice else _way_to(first, second)),
        notes=tuple(notes),
        help=advice,
        cause=f"{[place.key for node in (first, second) for place in node.origin.chain]} {second.origin.place.source.path}"
        if second.origin.chain or first.origin.chain
        else name,
        about=(name, *(ways(first, second) if twice else ())),
    )


def _renames(problem: DefaultOverruled, node: Node) -> bool:
    """Whether a node has its name from an arg whose default does not count, since an include before has left another value."""
    return problem.left and problem.place.source is node.origin.place.source and node.name.rpartition("/")[2] == problem.value


def _way_to(first: Node, second: Node) -> tuple[tuple[Place, str], ...]:
    """The includes that lead to the first node and not to the second."""
    shared = set(second.origin.chain)
    return tuple((place, "the first one comes from this include") for place in first.origin.chain if place not in shared)[-3:]
