"""An arg whose default is empty and stands for *required*: all that breaks without it has one cause, told once.

Which problems those are is not guessed from their words: the file is evaluated once more with the arg unknown, and what vanishes was caused
by the empty default. This is done only for configurations that roslaunch refuses.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping

from launchlint.check.empty_reach import may_be_caused
from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.problems import DuplicateNode, IncludeMissingArg, RequiredArgUnset
from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.model import Launch, Unknown
from launchlint.problem import Problem
from launchlint.source import Origin, Place
from launchlint.syntax.tree import Document, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.evaluate.block import Value
    from launchlint.evaluate.ros1.file import Declaration

    Key: TypeAlias = tuple[type[Problem], Place, tuple[Place, ...]]

MOST_DECLARATIONS = 12
"""Empty defaults that are tried one by one."""
BREAKS = "an empty value breaks this"


def told_at_declarations(session: Session, file: str, evaluation: Evaluation, pinned: frozenset[str]) -> Evaluation:
    """``evaluation`` with args that are unknown where their empty default is what makes roslaunch refuse it, and a problem for each.

    The problem is ``required-arg-unset`` for an arg of the entry file, and ``include-missing-arg`` for one that an include leaves out;
    their fact ``empty`` is true. The same ``evaluation`` where no empty default is to blame.
    """
    launch = evaluation.launch
    if launch.refused is None or any(isinstance(each, (RequiredArgUnset, IncludeMissingArg)) and each.empty for each in launch.problems):
        return evaluation  # it loads, or has been here
    declared = dict(_empty_declarations(evaluation))
    if not declared or not may_be_caused(session, evaluation, {name for name, _ in declared.values()}):
        return evaluation

    done: dict[frozenset[tuple[Declaration, str]], Evaluation] = {}

    def evaluated(chosen: Mapping[Declaration, Value]) -> Evaluation:
        variant = frozenset((each, repr(value)) for each, value in chosen.items())
        if variant not in done:
            done[variant] = evaluate(session, file, launch.given, pinned, chosen)
        return done[variant]

    def with_defaults(chosen: Mapping[Declaration, Value]) -> Launch:
        return evaluated(chosen).launch

    refusing = {_key(problem): problem for problem in launch.problems if problem.refused}
    left = refusing.keys() - _keys(with_defaults({each: _unknown(name) for each, (name, _) in declared.items()}))
    causes: list[Problem] = []
    guilty: dict[Declaration, Value] = {}
    for declaration, (name, place) in list(declared.items())[:MOST_DECLARATIONS]:
        if not left:
            break
        caused = left - _keys(with_defaults({declaration: _unknown(name)}))
        found = _causes(name, place, [refusing[key] for key in refusing if key in caused], evaluation)
        if found:
            causes += found
            guilty[declaration] = _unknown(name)
            left -= caused
    if not causes:
        return evaluation
    better = evaluated(guilty)
    kept = _independent(launch, better.launch, lambda: with_defaults({each: _placeholder(declared[each][0]) for each in guilty}))
    problems = (*causes, *better.launch.problems, *kept)
    refused = next((problem for problem in problems if problem.refused), None)
    return better._replace(launch=better.launch._replace(problems=problems, refused=refused))


def _empty_declarations(evaluation: Evaluation) -> Iterator[tuple[Declaration, tuple[str, Place]]]:
    """The args declared with an empty default, those of the entry file first."""
    entry = evaluation.launch.entry.path
    for path in sorted(evaluation.documents, key=lambda each: each != entry):
        document = evaluation.documents[path]
        for element in document.elements:
            if element.tag == "arg" and element.get("default") == "" and element.parent is not None and element.parent.tag != "include":
                name = element.attributes.get("name")
                if name is not None and name.value:
                    place = document.place(name.value_span)
                    yield (path, place.span.start), (name.value, place)


def _independent(launch: Launch, better: Launch, with_placeholders: Callable[[], Launch]) -> tuple[Problem, ...]:
    """The nodes of one name that have it with any other value of the args, too: nothing is known of names made from unknown args."""
    still = _keys(better)
    lost = [problem for problem in launch.problems if isinstance(problem, DuplicateNode) and _key(problem) not in still]
    if not lost:
        return ()
    there = _keys(with_placeholders())
    return tuple(problem for problem in lost if _key(problem) in there)


def _unknown(name: str) -> Unknown:
    return Unknown(f"$(arg {name})", f"the arg {name} is empty, which stands for none")


def _placeholder(name: str) -> str:
    """A value that is as good as any, for names and namespaces at least, and another one for each arg."""
    return "x" + re.sub(r"\W", "_", name, flags=re.ASCII)


def _key(problem: Problem) -> Key:
    return type(problem), problem.place, problem.origin.chain


def _keys(launch: Launch) -> set[Key]:
    return {_key(problem) for problem in launch.problems}


def _causes(name: str, place: Place, broken: list[Problem], evaluation: Evaluation) -> list[Problem]:
    """One problem for all that the empty default at ``place`` breaks: at the declaration, or at each include that leaves the arg out."""
    if place.source.path == evaluation.launch.entry.path:
        unset = RequiredArgUnset(origin=Origin(place), refused=True, related=_places(broken), name=name, empty=True)
        return [unset] if broken else []
    groups: dict[Origin, list[Problem]] = {}
    for problem in broken:
        for origin in _including(place, problem, evaluation.launch):
            groups.setdefault(origin, []).append(problem)
    return [
        made for origin, problems in groups.items() if (made := _left_out(name, place, origin, problems, evaluation.documents)) is not None
    ]


def _including(place: Place, problem: Problem, launch: Launch) -> list[Origin]:
    """The include on the way to ``problem`` that enters the file which holds ``place``."""
    chain = problem.origin.chain
    found = (each for each in launch.includes if each.source is not None and each.source.path == place.source.path)
    return [each.origin for each in found if (*each.origin.chain, each.origin.place) == chain[: len(each.origin.chain) + 1]][-1:]


def _left_out(name: str, place: Place, origin: Origin, broken: list[Problem], documents: Mapping[str, Document]) -> Problem | None:
    document = documents.get(origin.place.source.path)
    element = None if document is None else document.element_from(origin.place.span.start)
    file = None if element is None else element.attributes.get("file")
    if document is None or element is None or file is None:
        return None
    return IncludeMissingArg(
        origin=Origin(document.place(file.value_span), origin.step),
        refused=True,
        related=((place, "its default is empty"), *_places(broken)),
        name=name,
        file=place.source.path,
        passed=tuple(sorted(_passed(element))),
        target=place.source.file,
        pass_all="pass_all_args" in element.attributes,
        empty=True,
    )


def _passed(include: Element) -> Iterator[str]:
    for child in include.children:
        if child.tag.lower() == "arg":
            yield child.get("name") or ""


def _places(problems: list[Problem]) -> tuple[tuple[Place, str], ...]:
    return tuple((place, BREAKS) for place in dict.fromkeys(problem.place for problem in problems))
