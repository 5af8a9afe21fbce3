"""``<launch>``, ``<group>``, ``<arg>``, ``<remap>`` and ``<env>``, and the walk over a launch file (roslaunch.xmlloader._recurse_load)."""

from __future__ import annotations

import os
from functools import partial

from launchlint.evaluate.block import NO_CYCLE, Block, Clear
from launchlint.evaluate.problems import ArgOverrideRefused, ArgRedeclared, ConditionOnLaunch
from launchlint.evaluate.ros1.entering import Entering
from launchlint.evaluate.ros1.file import FileEvaluation, Progress
from launchlint.evaluate.ros1.include_tags import include
from launchlint.evaluate.ros1.machine_tags import machine
from launchlint.evaluate.ros1.node_tags import node
from launchlint.evaluate.ros1.parameter_tags import param, rosparam
from launchlint.evaluate.ros1.scope import Context, Missing
from launchlint.evaluate.ros1.scope_tags import clear_without_namespace, env, remap, scope_namespace
from launchlint.evaluate.session import Session
from launchlint.model import Argument, Scope, Unknown
from launchlint.source import Origin
from launchlint.syntax.ros1.domains import parse_condition
from launchlint.syntax.ros1.problems import arg_value_and_default, if_and_unless
from launchlint.syntax.ros1.substitutions import is_plain
from launchlint.syntax.tree import Document, Element
from launchlint.workspace.looking import note, watched

TAGS = frozenset({"arg", "group", "node", "test", "param", "remap", "machine", "rosparam", "include", "env"})


def launch_tag(file: FileEvaluation, launch: Element) -> None:
    """The attributes of the root: ``deprecated``, and conditions that have no effect (roslaunch.xmlloader._launch_tag).

    roslaunch looks at ``if`` and ``unless`` here only to crash on a substitution in them or on a value that is no boolean.
    """
    if "if" in launch.attributes and "unless" in launch.attributes:
        file.record(if_and_unless(file.document, launch))
        return
    for name in ("if", "unless"):
        attribute = launch.attributes.get(name)
        if attribute is None:
            continue
        if "$" in attribute.value:
            file.record(ConditionOnLaunch(origin=file.at(attribute.value_span), refused=True, attribute=name, text=attribute.value))
            continue
        try:
            parse_condition(attribute.value)
        except ValueError as error:
            file.not_boolean(attribute, attribute.value, str(error))


def enter(session: Session, document: Document, entering: Entering, entry: str, progress: Progress) -> Block:
    """Evaluate ``document`` as ``entering`` says, or take the block of an equal entering. Raises Exhausted."""
    key = entering.key
    stored = (key, progress.angles)
    known = _known(session, entering, stored, entry, progress)
    if known is not None and progress.has_room_for(known):
        progress.looked_at += known.looked_at
        note(known.looked)
        session.touched |= known.touched
        session.variables |= known.variables
        progress.angles |= known.angles
        return known
    session.checkpoint()
    file = FileEvaluation(
        session, document, entering.file, entry, progress, is_entry=entering.is_entry, private_above=entering.private_above,
        environment_arguments=entering.from_environment,
    )  # fmt: skip
    context = Context(entering.namespace, None)
    context.arguments = dict(entering.arguments)
    context.lenient = entering.pass_all
    block = file.block
    place, before = len(progress.stack), progress.looked_at
    outer = session.touched, session.variables
    session.touched, session.variables = set(), set()
    progress.stack.append(key)
    try:
        block.default_machine, block.looked = watched(partial(_whole, file, context, entering.default_machine))
    finally:
        progress.stack.pop()
        inner = session.touched, session.variables
        outer[0].update(inner[0])
        outer[1].update(inner[1])
        session.touched, session.variables = outer
    block.looked_at = progress.looked_at - before
    block.argument_values = {name: value for name, value in context.arguments.items() if not isinstance(value, Missing)}
    block.entered.add(key)
    block.angles = progress.angles
    if entering.private_above:
        block.leaked = list(context.private.values())
    if block.cycle_floor >= place:
        block.cycle_floor = NO_CYCLE
    # A block whose include cycle leads back to a file above it would be another one below other files.
    if not block.anonymous and block.cycle_floor == NO_CYCLE:
        block.touched, block.variables = frozenset(inner[0]), frozenset(inner[1])
        if progress.defaults and _differs(block, entering, progress):
            session.variants[stored, entry, progress.variant] = block
        else:
            session.blocks[(stored, entry) if block.near else stored] = block
    return block


def _whole(file: FileEvaluation, context: Context, default_machine: str | None) -> str | None:
    """Evaluate the whole file; the default machine after it."""
    launch = file.document.launch
    assert launch is not None
    launch_tag(file, launch)
    return walk(file, launch, context, default_machine)


def _known(session: Session, entering: Entering, stored: object, entry: str, progress: Progress) -> Block | None:
    """The block of an equal entering, worked out with the same defaults or with defaults that make no difference to it."""
    known = session.blocks.get(stored) or session.blocks.get((stored, entry))
    if progress.defaults and (known is None or _differs(known, entering, progress)):
        return session.variants.get((stored, entry, progress.variant))
    return known


def _differs(block: Block, entering: Entering, progress: Progress) -> bool:
    """Whether ``block`` may be another one with other defaults: one of them is its own or below it, or reaches it as an unknown value."""
    return (
        os.path.abspath(entering.file) in progress.defaulted
        or not progress.defaulted.isdisjoint(block.touched)
        or any(isinstance(value, Unknown) for value in entering.arguments.values())
    )


def walk(file: FileEvaluation, element: Element, context: Context, default_machine: str | None) -> str | None:
    """Evaluate the children of a ``<launch>`` or ``<group>`` in order. Returns the default machine in force after it, which leaks out."""
    for tag, child in file.children(element, context, TAGS):
        if tag == "arg":
            arg(file, child, context)
        elif tag == "group":
            default_machine = group(file, child, context, default_machine)
        elif tag in ("node", "test"):
            node(file, child, context, default_machine, is_test=tag == "test")
        elif tag == "param":
            param(file, child, context, context.namespace)
        elif tag == "rosparam":
            rosparam(file, child, context, context.namespace)
        elif tag == "remap":
            scoped_remap(file, child, context)
        elif tag == "env":
            scoped_env(file, child, context)
        elif tag == "machine":
            name = machine(file, child, context)
            default_machine = default_machine if name is None else name
        else:
            default_machine = include(file, child, context, default_machine, enter)
    file.close_settings(context, element.span.end)
    return default_machine


def group(file: FileEvaluation, element: Element, context: Context, default_machine: str | None) -> str | None:
    """A ``<group>``: its own scope, in the same namespace or in one below."""
    namespace, given = scope_namespace(file, element, context)
    file.spend_on_scope(context, element.name_span)
    inner = Context(namespace, context)
    inner.scope = Scope("group", Origin(file.place(element.start_span)), namespace, context.scope)
    if file.flag(element, "clear_params", context, empty_is_absent=True):
        if given is not False:
            file.effect(Clear(namespace, Origin(file.place(element.attributes["clear_params"].value_span))))
        else:
            clear_without_namespace(file, element)
    default_machine = walk(file, element, inner, default_machine)
    context.nodes_above.extend(inner.nodes_above)
    return default_machine


def arg(file: FileEvaluation, element: Element, context: Context) -> None:
    """An ``<arg>`` of a launch file or group (roslaunch.loader.LoaderContext.add_arg)."""
    # Which of several declarations counts is decided by their conditions.
    reads = file.condition_reads
    effect = file.session.plain_arguments.get(element)
    if effect is None:
        found = _argument(file, element, context)
        if found is None:
            return
        effect, more = found
        reads |= more
    name, value, default, origin, _, in_group = effect
    place = origin.place
    if default == "" and file.progress.defaults:
        default = file.progress.defaults.get(place.key, default)
        effect = effect._replace(default=default)
    file.effect(effect)
    file.block.assumed_declarations |= file.assumed
    earlier = context.declared.get(name)
    if earlier is None:
        context.declared[name] = place
        if not in_group:
            file.block.declared[name] = place
    elif not context.lenient:
        problem = ArgRedeclared(origin=Origin(place), refused=True, related=((earlier, "the first declaration"),), name=name)
        # The earlier one may stand under a condition of unknown value, and the two exclude each other.
        file.record(problem.but(refused=False, assumed=True) if file.block.assumed_declarations else problem)
        return
    block = file.block
    if value is not None:
        if context.has_value(name) and not context.lenient:
            if file.is_entry:
                file.record(ArgOverrideRefused(origin=Origin(place), refused=True, name=name, by_include=False))
            else:
                block.refused_overrides.setdefault(name, place)
        context.arguments[name] = value
        block.argument_reads[name] = block.argument_reads.get(name, frozenset()) | reads
    elif default is not None:
        block.open_arguments.add(name)
        if not context.has_value(name):
            context.arguments[name] = default
            block.argument_reads[name] = block.argument_reads.get(name, frozenset()) | reads
    else:
        block.open_arguments.add(name)


def _argument(file: FileEvaluation, element: Element, context: Context) -> tuple[Argument, frozenset[str]] | None:
    """The declaration, and the args it was made from; None where its name is not known.

    One that is just what is written, as most are, is the same in all configurations, and kept.
    """
    name = file.required(element, "name", context)
    (value, default), reads = file.value_and_default(element, context)
    if "doc" in element.attributes:
        file.optional(element, "doc", context)
    if isinstance(name, Unknown):
        return None
    both = value is not None and default is not None
    if both:
        file.record(arg_value_and_default(file.document, element))
        default = None
    place = element.attributes["name"].written(file.document.source)
    argument = Argument(name, value, default, Origin(place), False, element.parent is not file.document.launch)
    if not both and all(is_plain(each.value) for key, each in element.attributes.items() if key not in ("if", "unless")):
        file.session.plain_arguments[element] = argument
    return argument, reads


def scoped_remap(file: FileEvaluation, element: Element, context: Context) -> None:
    """A ``<remap>`` outside nodes: acts on the nodes that follow in its scope."""
    rule = remap(file, element, context)
    if rule is not None:
        replaced = context.add_remap(rule)
        if not rule.source:
            return
        file.open_setting(context, "remap", rule.source, rule, rule.origin, None if replaced is None else replaced.origin.place)


def scoped_env(file: FileEvaluation, element: Element, context: Context) -> None:
    """An ``<env>`` outside nodes."""
    setting = env(file, element, context)
    if setting is not None:
        context.environment.append(setting)
        file.open_setting(context, "env", setting.name, setting.value, setting.origin, None)
