"""``<include>`` (roslaunch.xmlloader._include_tag), and how a file is entered."""

from __future__ import annotations

from collections.abc import Callable

from launchlint.evaluate.block import Block, Call, Clear, Value
from launchlint.evaluate.problems import (
    ArgOverrideRefused,
    ArgRedeclared,
    DeprecatedInclude,
    IncludeCycle,
    IncludeMissingArg,
    IncludeNotFound,
    IncludeNotLoadable,
    IncludeUndeclaredArg,
    PassAllHidesTypo,
)
from launchlint.evaluate.ros1.entering import Entering
from launchlint.evaluate.ros1.file import DEEPEST_INCLUDE, Exhausted, FileEvaluation, Progress
from launchlint.evaluate.ros1.scope import Context, set_private
from launchlint.evaluate.ros1.scope_tags import clear_without_namespace, env, scope_namespace
from launchlint.evaluate.session import Read, Session
from launchlint.model import Argument, EnvironmentSetting, Include, Scope, Unknown
from launchlint.source import Origin, Place
from launchlint.syntax.problems import MalformedXml
from launchlint.syntax.ros1.problems import arg_value_and_default, missing_attribute
from launchlint.syntax.tree import Document, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

Enter = Callable[[Session, Document, Entering, str, Progress], Block]
CHILD_TAGS = frozenset({"arg", "env"})
INCLUDE_ELEMENTS = 5
"""What entering a file costs, in elements; with ``pass_all_args`` every arg is one more."""


def include(file: FileEvaluation, element: Element, context: Context, default_machine: str | None, enter: Enter) -> str | None:
    """Evaluate an ``<include>`` with ``enter``, which evaluates a file. Returns the default machine in force after it."""
    name, made_from = file.traced(lambda: file.required(element, "file", context))
    pass_all = file.flag(element, "pass_all_args", context)
    namespace, given = scope_namespace(file, element, context)
    if file.flag(element, "clear_params", context, empty_is_absent=True):
        if given is not False:
            file.effect(Clear(namespace, Origin(file.place(element.attributes["clear_params"].value_span))))
        else:
            clear_without_namespace(file, element)
    passed, reads, environment, explicit = _passed(file, element, context, pass_all=pass_all)
    origin = Origin(file.place(element.start_span))
    scope = Scope("include", origin, namespace, context.scope)
    context.nodes_above.append(origin.place)
    entry = Include("", None, namespace, passed, pass_all, origin, scope, file.conditions)
    if isinstance(name, Unknown):
        file.effect(entry._replace(file=name.text))
        _reach_unseen(file, context)
        return default_machine
    document = _open(file, element, name, from_environment=file.from_environment(made_from))
    if document is None or document.launch is None:
        file.effect(entry._replace(file=name, source=None if document is None else document.source))
        _reach_unseen(file, context)
        return default_machine
    private_above = bool(context.private) or file.private_above
    outside = frozenset(passed_name for passed_name, made_from in reads.items() if file.from_environment(made_from))
    entering = Entering(
        name, namespace, passed, pass_all=pass_all, private_above=private_above, default_machine=default_machine, from_environment=outside,
    )  # fmt: skip
    if entering.key in file.progress.stack or len(file.progress.stack) >= DEEPEST_INCLUDE:
        _cycle(file, element, name, entering.key)
        _reach_unseen(file, context)
        return default_machine
    block = enter(file.session, document, entering, file.entry, file.progress)
    file.block.anonymous |= block.anonymous
    file.block.near |= block.near
    file.block.depth = max(file.block.depth, block.depth + 1)
    file.block.cycle_floor = min(file.block.cycle_floor, block.cycle_floor)
    file.block.entered |= block.entered
    file.block.node_count += block.node_count
    context.reach(block.node_count)
    lost = _check_arguments(file, element, document, block, explicit, pass_all=pass_all)
    call = Call(
        entry._replace(file=name, source=document.source), block, tuple(context.remaps_in_force()), tuple(environment),
        tuple(context.private.values()), reads, scope, file.conditions, lost,
    )  # fmt: skip
    file.effect(call)
    for parameter in block.leaked:
        leaked = parameter.setting
        step_origin = leaked.origin._replace(step=_below(origin.place, leaked.origin))
        set_private(context.private, parameter._replace(setting=leaked._replace(origin=step_origin)))
    return block.default_machine


def _reach_unseen(file: FileEvaluation, context: Context) -> None:
    """A file that is not followed may start nodes: it counts as one, here and in the files that include this one."""
    file.block.node_count += 1
    context.reach(1)


def _below(place: Place, origin: Origin) -> Any:
    from launchlint.source import IncludeStep

    step = IncludeStep(place, None)
    for inner in origin.chain:
        step = IncludeStep(inner, step)
    return step


def _passed(
    file: FileEvaluation, element: Element, context: Context, *, pass_all: bool
) -> tuple[dict[str, Value], dict[str, frozenset[str]], list[EnvironmentSetting], dict[str, Place]]:
    """What the ``<arg>`` and ``<env>`` children give: values, the args they were made from, environment, places of explicit args."""
    file.spend(INCLUDE_ELEMENTS + (len(context.arguments) if pass_all else 0), element.name_span)
    file.spend_on_scope(context, element.name_span)
    own = Context(context.namespace, context)
    passed: dict[str, Value] = dict(context.arguments) if pass_all else {}
    reads: dict[str, frozenset[str]] = {name: frozenset((name,)) for name in passed}
    if pass_all:
        file.reads.update(passed)
    explicit: dict[str, Place] = {}
    environment = list(context.environment)
    for tag, child in file.children(element, own, CHILD_TAGS, any_case=True):
        if tag == "env":
            setting = env(file, child, own)
            if setting is not None:
                environment.append(setting)
            continue
        name = file.required(child, "name", own)
        (value, default), read = file.value_and_default(child, own)
        if "doc" in child.attributes:
            file.optional(child, "doc", own)
        if isinstance(name, Unknown):
            continue
        place = child.attributes["name"].written(file.document.source)
        if value is not None and default is not None:
            file.record(arg_value_and_default(file.document, child))
            default = None
        if name in explicit and not pass_all:
            file.record(ArgRedeclared(origin=Origin(place), refused=True, related=((explicit[name], "the first one"),), name=name))
        explicit[name] = place
        chosen = value if value is not None else passed.get(name, default)
        if chosen is None and name not in passed:
            file.record(missing_attribute(file.document, child, "value"))
            chosen = Unknown("", "the attribute value is missing")
        if chosen is not None:
            passed[name] = chosen
            reads[name] = read if value is not None or name not in reads else reads[name]
        file.effect(Argument(name, value, default, Origin(place), True))
    return passed, reads, environment, explicit


def _open(file: FileEvaluation, element: Element, name: str, *, from_environment: bool) -> Document | None:
    document = file.session.document(name)
    attribute = element.attributes["file"]
    origin = file.at(attribute.value_or_name_span)
    if isinstance(document, Read):
        file.record(IncludeNotFound(origin=origin, refused=True, file=name, written=attribute.value, reason=document.reason,
                                    environment=from_environment))  # fmt: skip
        return None
    if document.launch is None:
        malformed = any(isinstance(problem, MalformedXml) for problem in document.problems)
        reason = "it is not well-formed XML" if malformed else "it is not a launch file"
        file.record(IncludeNotLoadable(origin=origin, refused=True, file=name, reason=reason, environment=from_environment,
                                       malformed=malformed))  # fmt: skip
    else:
        deprecated = document.launch.get("deprecated")
        if deprecated:
            file.record(DeprecatedInclude(origin=origin, file=name, text=deprecated))
    return document


def _cycle(file: FileEvaluation, element: Element, name: str, entering: tuple[Any, ...]) -> None:
    stack = file.progress.stack
    files = [str(key[0]) for key in stack]
    endless = entering in stack
    start = stack.index(entering) if endless else files.index(name) if name in files else 0
    attribute = element.attributes["file"]
    cycle = [file.session.shown(step) for step in (*files[start:], name)]
    shown = tuple(cycle if len(cycle) <= 12 else [*cycle[:6], "…", *cycle[-5:]])
    problem = IncludeCycle(origin=file.at(attribute.value_span), refused=True, cycle=shown, endless=endless, depth=len(files))
    if not endless:
        raise Exhausted(problem)
    file.block.cycle_floor = min(file.block.cycle_floor, start)
    file.record(problem)


def _check_arguments(
    file: FileEvaluation, element: Element, document: Document, block: Block, explicit: dict[str, Place], *, pass_all: bool
) -> bool:
    """Args passed but not declared, declared with ``value=``, or required but not passed (roslaunch.loader.post_process_include_args).

    Returns whether a value that is passed is lost.
    """
    path = document.source.path
    lost = bool(block.refused_overrides)
    undeclared = tuple(name for name in explicit if name not in block.declared and name not in block.refused_overrides)
    known, target, passed = tuple(sorted(block.open_arguments)), document.source.file, tuple(sorted(explicit))
    for name, place in explicit.items():
        if name in block.refused_overrides:
            fixed = ((block.refused_overrides[name], "its value is fixed here"),)
            file.record(ArgOverrideRefused(origin=Origin(place), refused=True, related=fixed, name=name, by_include=True, file=path))
        elif name not in block.declared and not block.assumed_declarations:
            lost = lost or not pass_all  # roslaunch goes on with what it has, and what follows is no guess
            kind = PassAllHidesTypo if pass_all else IncludeUndeclaredArg
            file.record(
                kind(origin=Origin(place), refused=not pass_all, name=name, file=path, known=known, target=target, undeclared=undeclared)
            )
    for name, declaration in block.refused_overrides.items():
        if name not in explicit:  # passed by pass_all_args, and fixed in a group there: only at file level the fixed value wins
            fixed = ((declaration, "its value is fixed here"),)
            origin = file.at(element.attributes["pass_all_args"].value_span)
            file.record(ArgOverrideRefused(origin=origin, refused=True, related=fixed, name=name, by_include=True, file=path))
    for name, (declaration, read) in block.missing.items():
        related = ((declaration, "declared here without a default"), (read, "read here"))
        file.record(
            IncludeMissingArg(
                origin=file.at(element.attributes["file"].value_span), refused=True, related=related,
                name=name, file=path, passed=passed, target=target, pass_all=pass_all,
            )
        )  # fmt: skip
    return lost
