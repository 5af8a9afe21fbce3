"""The evaluation of one launch file: what every tag needs to do its work.

The tags themselves are in ``launch_tags``, ``include_tags``, ``node_tags``, ``parameter_tags`` and ``machine_tags``; this is the state
they share.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType

from launchlint.evaluate.block import Block, Effect, LocalBranch, Value
from launchlint.evaluate.problems import (
    ArgOutOfScope,
    ConditionNotBoolean,
    EvaluationBound,
    RequiredArgUnset,
    UndeclaredArg,
    UnexpandedSubstitution,
    UsedBeforeDeclaration,
)
from launchlint.evaluate.ros1.arg_uses import args_needed
from launchlint.evaluate.ros1.kept_values import kept_value, resolved
from launchlint.evaluate.ros1.scope import ActiveSetting, Context, Missing, asked_of
from launchlint.evaluate.ros1.substitution import ANONYMOUS_FOLD, OUTSIDE, SHORT, absolute_directory, never_boolean
from launchlint.evaluate.session import Session
from launchlint.model import Condition, ScopedSetting, Unknown
from launchlint.problem import Problem
from launchlint.source import Origin, Place, Span
from launchlint.syntax.problems import InvalidValue
from launchlint.syntax.ros1.domains import parse_condition, parse_flag
from launchlint.syntax.ros1.problems import if_and_unless, missing_attribute
from launchlint.syntax.ros1.substitutions import EXTRA, is_plain, only_arg, parse, parts_of, slip
from launchlint.syntax.tree import Attribute, Document, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeAlias, TypeVar

    from launchlint.syntax.parts import Parts

    T = TypeVar("T")

LARGEST_EVALUATION = 400_000
"""Elements looked at in one configuration; more than any real launch file, few enough to end in seconds."""
CHARACTERS_PER_ELEMENT = SHORT
INHERITED_PER_ELEMENT = 8
"""How much text, and how many args and settings passed on to a scope, count as one more element."""
DEEPEST_INCLUDE = 300
"""Includes inside includes: roslaunch itself overflows Python's stack a little above this (three frames an include, limit 1000)."""


Declaration: TypeAlias = "tuple[str, int]"
"""Where an arg is declared: the path of the file as shown, and the offset of the name."""
NO_DEFAULTS: Mapping[Declaration, Value] = MappingProxyType({})


class Exhausted(Exception):
    """The evaluation of this entry file is given up, since it would not end in reasonable time; holds the problem that says so."""


class Progress:
    """What all files of one evaluation share: the anonymous names so far, the include stack, and how much has been looked at.

    ``angles``: a ``<rosparam>`` has been loaded, and with it roslaunch's knowledge of ``deg(…)`` and ``rad(…)``, also for ``<param
    type="yaml">``. ``defaults`` holds what to take in place of some empty defaults, by the place of the declaration, and ``defaulted``
    names the files with these; ``variant`` is equal for equal defaults.
    """

    __slots__ = ("angles", "anonymous", "defaulted", "defaults", "looked_at", "stack", "variant")

    def __init__(self, defaults: Mapping[Declaration, Value] = NO_DEFAULTS, defaulted: frozenset[str] = frozenset()) -> None:
        self.defaults = defaults
        self.defaulted = defaulted
        self.variant = frozenset((at, repr(value)) for at, value in defaults.items())
        self.angles = False
        self.anonymous = 0
        self.looked_at = 0
        self.stack: list[tuple[Any, ...]] = []

    def has_room_for(self, block: Block) -> bool:
        """Whether ``block``, worked out before, may be used here: doing it again must meet no bound and no file above it."""
        return (
            self.looked_at + block.looked_at <= LARGEST_EVALUATION
            and len(self.stack) + block.depth < DEEPEST_INCLUDE
            and block.entered.isdisjoint(self.stack)
        )


class FileEvaluation:
    """One launch file, entered in one way.

    ``reads`` collects the args read since it was last emptied; ``environment_arguments`` are the args whose values the including files
    made from environment variables.
    """

    def __init__(
        self, session: Session, document: Document, file: str, entry: str, progress: Progress, *, is_entry: bool, private_above: bool,
        environment_arguments: frozenset[str] = frozenset(),
    ) -> None:  # fmt: skip
        self.session = session
        self.document = document
        self.file = file
        self.entry = entry
        self.progress = progress
        self.is_entry = is_entry
        self.private_above = private_above
        self.environment_arguments = environment_arguments
        self.block = Block(document)
        self.reads: set[str] = set()
        self.conditions: tuple[Condition, ...] = ()
        self.condition_reads: frozenset[str] = frozenset()
        self.assumed = False
        self._declarations: dict[str, list[Element]] | None = None
        self._outside = bool(environment_arguments)

    # -- recording ---------------------------------------------------------------------------------------------

    def place(self, span: Span) -> Place:
        """``span`` of this file as a place."""
        return Place(self.document.source, span)

    def at(self, span: Span) -> Origin:
        """``span`` of this file as where something comes from."""
        return Origin(self.place(span))

    def effect(self, effect: Effect) -> None:
        """Add to what this file contributes."""
        self.block.effects.append(effect)

    def record(self, problem: Problem) -> None:
        """Record ``problem``; under a condition of unknown value it may never come to pass, so that it refuses nothing."""
        self.block.effects.append(problem.but(assumed=True, refused=False) if self.assumed else problem)

    def look_at(self, element: Element) -> None:
        """Count one element against the bound of the whole evaluation. Raises Exhausted."""
        self.progress.looked_at += 1
        if self.progress.looked_at > LARGEST_EVALUATION:
            self.spend(0, element.name_span)

    def spend(self, elements: int, span: Span) -> None:
        """Count work at ``span`` that is worth that many elements. Raises Exhausted, at the bound of the whole evaluation."""
        self.progress.looked_at += elements
        if self.progress.looked_at > LARGEST_EVALUATION:
            raise Exhausted(EvaluationBound(origin=self.at(span), elements=LARGEST_EVALUATION))

    def spend_characters(self, count: int, span: Span) -> None:
        """Count a text of ``count`` characters that is made at ``span``: args that double in every include grow without end. Raises
        Exhausted.
        """
        if count >= CHARACTERS_PER_ELEMENT:
            self.spend(count // CHARACTERS_PER_ELEMENT, span)

    def spend_on_scope(self, context: Context, span: Span) -> None:
        """Count what a new scope takes over from ``context``. Raises Exhausted."""
        inherited = len(context.arguments) + sum(len(outer.settings) for outer in context.enclosing())
        if inherited >= INHERITED_PER_ELEMENT:
            self.spend(inherited // INHERITED_PER_ELEMENT, span)

    def spend_on_node(self, context: Context, remaps: int, variables: int, span: Span) -> None:
        """Count what a node is started with: every rule that looks at nodes looks at each of its remaps. Raises Exhausted."""
        self.spend(remaps + (variables + len(context.private)) // INHERITED_PER_ELEMENT, span)

    # -- values ------------------------------------------------------------------------------------------------

    def value(self, attribute: Attribute, context: Context, text: str | None = None) -> Value:
        """The resolved value of ``attribute`` (or of ``text``, a stripped form of it)."""
        raw = attribute.value if text is None else text
        if "$" not in raw and "(" not in raw:  # is_plain, without a call
            return raw
        if text is not None and text != attribute.value:
            return resolved(self, attribute, parse(text), context, max(attribute.value.find(text), 0))
        parts = parts_of(attribute)
        alone = only_arg(parts)
        if alone:
            known = self.plain_argument(alone, context)
            if known is not None:
                return known
        return kept_value(self, attribute, parts, context)

    def notice_left_over(self, parts: Parts, where: Callable[[int, int], Span]) -> None:
        """Record what looks like a substitution and is none, and so reaches the robot as it stands."""
        found = slip(parts)
        if found is not None and parts.refused is None and not any(parts.substitutions("eval")):
            words = tuple(word.text for word in found.words)
            origin, extra = self.at(where(found.start, found.end)), found.kind == EXTRA
            self.record(UnexpandedSubstitution(origin=origin, text=found.text, extra=extra, words=words))

    def optional(self, element: Element, name: str, context: Context) -> Value | None:
        """The resolved value of an attribute that may be absent."""
        attribute = element.attributes.get(name)
        return None if attribute is None else self.value(attribute, context)

    def required(self, element: Element, name: str, context: Context) -> Value:
        """The resolved value of an attribute that must be there; unknown, with a problem, where it is not."""
        attribute = element.attributes.get(name)
        if attribute is None:
            self.record(missing_attribute(self.document, element, name))
            return Unknown("", f"the attribute {name} is missing")
        return self.value(attribute, context)

    def flag(self, element: Element, name: str, context: Context, *, empty_is_absent: bool = False) -> bool:
        """A true/false attribute, false where it is absent or wrong (roslaunch.xmlloader._bool_attr)."""
        value = self.optional(element, name, context)
        if value is None or isinstance(value, Unknown) or (empty_is_absent and not value):
            return False
        try:
            return parse_flag(value)
        except ValueError:
            self.invalid(element, name, value, "true or false")
            return False

    def number(self, element: Element, name: str, context: Context, default: float) -> float:
        """A floating point attribute, ``default`` where it is absent or wrong (roslaunch.xmlloader._float_attr)."""
        value = self.optional(element, name, context)
        if value is None or isinstance(value, Unknown):
            return default
        try:
            return float(value)
        except ValueError:
            self.invalid(element, name, value, "a number")
            return default

    def invalid(self, element: Element, name: str, value: str, expected: str) -> None:
        """Record that the resolved ``value`` is none that attribute ``name`` takes; roslaunch refuses the file."""
        origin = self.at(element.attributes[name].shown_span)
        self.record(InvalidValue(origin=origin, refused=True, tag=element.tag, attribute=name, value=value, expected=expected))

    # -- what substitutions ask for ----------------------------------------------------------------------------

    def dirname(self) -> str:
        """``$(dirname)``: the absolute directory of this file."""
        return absolute_directory(self.file)

    def variable(self, name: str, default: str) -> str:
        """``$(optenv name default)``."""
        self.read_outside()
        value = self.session.variable(name)
        return default if value is None else value

    def read_outside(self) -> None:
        """Note that something outside the launch files was asked for, such as the environment."""
        self.reads.add(OUTSIDE)
        self._outside = True

    def anonymous_name(self, name: str, context: Context) -> str:
        """``$(anon name)``: the same within a scope and what is inside it, else a new one, numbered from 1."""
        known = context.anonymous.get(name)
        if known is None:
            self.block.anonymous = True
            self.progress.anonymous += 1
            known = context.anonymous[name] = f"{name}_anon{self.progress.anonymous}".translate(ANONYMOUS_FOLD)
        return known

    def package(self, name: str) -> str | None:
        """Directory of a package."""
        if name in self.session.packages.duplicates():
            self.block.near = True
        return self.session.find_package(name, self.entry)

    def resource(self, directory: str, path: str) -> str:
        """What ``$(find pkg)/path`` stands for."""
        return self.session.packages.resolve_resource(directory, path) if path else directory

    def has_argument(self, name: str, context: Context) -> bool:
        """Whether an arg has a value here, known or not."""
        return name in context.arguments

    def argument(self, name: str, span: Span, context: Context) -> Value:
        """Value of an arg; a missing one is recorded once and unknown from then on."""
        self.reads.add(name)
        if name not in context.arguments:
            self.missing_argument(name, span, context)
            context.arguments[name] = Missing(f"$(arg {name})", f"the arg {name} has no value")
        return context.arguments[name]

    def known_argument(self, name: str, context: Context) -> str | None:
        """Value of an arg that has one, noted as read; ``None`` for all others, of which :meth:`argument` has something to say."""
        value = context.arguments.get(name)
        if not isinstance(value, str):
            return None
        self.reads.add(name)
        return value

    def plain_argument(self, name: str, context: Context) -> str | None:
        """As :meth:`known_argument`, for a value that is to be taken as it is: short, and with no substitution in it."""
        value = context.arguments.get(name)
        if not isinstance(value, str) or "$" in value or len(value) >= SHORT:
            return None
        self.reads.add(name)
        return value

    def missing_argument(self, name: str, span: Span, context: Context, *, in_expression: bool = False) -> None:
        """Record the read of an arg that has no value, as what it is: not given, not declared, declared later, or out of scope."""
        declared = context.declared.get(name)
        if declared is not None:
            if self.is_entry:
                related = ((self.place(span), "read here"),)
                self.record(RequiredArgUnset(origin=Origin(declared), refused=True, related=related, name=name))
            else:
                self.block.missing.setdefault(name, (declared, self.place(span)))
            return
        elements = self.declarations().get(name, [])
        self.spend_on_scope(context, span)
        known = tuple(sorted({*filter(context.has_value, context.arguments), *context.declared}))
        outer = [element for element in elements if element.parent is self.document.launch]
        if outer and outer[0].start_span.end > span.start:
            related = ((self._declared_at(outer[0]), "declared here"),)
            cycle = self._cycle(name, span)
            self.record(UsedBeforeDeclaration(origin=self.at(span), refused=True, related=related, name=name, cycle=cycle))
        elif elements and not outer:
            declaration = self._declared_at(elements[0])
            self.record(ArgOutOfScope(origin=self.at(span), refused=True, name=name, declaration=declaration))
        else:
            skipped = tuple(self._declared_at(element) for element in outer)
            self.record(
                UndeclaredArg(
                    origin=self.at(span),
                    refused=True,
                    name=name,
                    known=known,
                    entry=self.is_entry,
                    skipped=skipped,
                    in_expression=in_expression,
                    asked=tuple(asked_of(outer, context, self.reads)),
                )
            )

    def declarations(self) -> dict[str, list[Element]]:
        """All ``<arg>`` elements of this file outside includes, by name as written."""
        if self._declarations is None:
            self._declarations = {}
            for element in self.document.elements:
                if element.tag == "arg" and element.parent is not None and element.parent.tag in ("launch", "group"):
                    name = element.get("name")
                    if name:
                        self._declarations.setdefault(name, []).append(element)
        return self._declarations

    def _declared_at(self, element: Element) -> Place:
        return self.place(element.attributes["name"].value_span)

    def _cycle(self, name: str, span: Span) -> tuple[tuple[str, Place], ...]:
        """Args that need each other, each with its declaration, from the one in whose declaration ``span`` reads ``name``; else nothing."""
        start = self._inside_declaration(span)
        if start is None:
            return ()
        came_from: dict[str, str] = {name: start}
        waiting = [name]
        while waiting and start not in came_from:
            current = waiting.pop(0)
            for element in self.declarations().get(current, []):
                for needed in args_needed(element):
                    if needed not in came_from:
                        came_from[needed] = current
                        waiting.append(needed)
        if start not in came_from:
            return ()
        names = [start]
        while (before := came_from[names[-1]]) != start:
            names.append(before)
        names = [start, *reversed(names[1:])]
        return tuple((each, self._declared_at(self.declarations()[each][0])) for each in names)

    def _inside_declaration(self, span: Span) -> str | None:
        """Name of the arg in whose declaration ``span`` lies, if it lies in one."""
        for name, elements in self.declarations().items():
            if any(element.start_span.start <= span.start < element.start_span.end for element in elements):
                return name
        return None

    # -- conditions and scopes ---------------------------------------------------------------------------------

    def children(
        self, element: Element, context: Context, tags: frozenset[str], *, any_case: bool = False
    ) -> Iterator[tuple[str, Element]]:
        """The children with one of ``tags`` whose condition holds, in order, each with its tag in lower case.

        While a child is being worked on, ``conditions`` and ``assumed`` include its own. With ``any_case`` the letter case of tags does not
        matter, as inside ``<node>`` and ``<include>``.
        """
        outer = self.conditions, self.assumed, self.condition_reads
        for child in element.children:
            tag = child.tag.lower() if any_case else child.tag
            if tag not in tags:
                continue
            self.look_at(child)
            attributes = child.attributes
            if "if" not in attributes and "unless" not in attributes:  # most of them: nothing comes into force
                yield tag, child
                continue
            if tag == "master" or self.holds(child, context):
                yield tag, child
            self.conditions, self.assumed, self.condition_reads = outer

    def holds(self, element: Element, context: Context) -> bool:
        """Whether ``element`` is evaluated (roslaunch.xmlloader.ifunless_test); its condition comes into force.

        Both ``if`` and ``unless``: a problem. That, and a condition of unknown value, is taken to be true.
        """
        attributes = element.attributes
        if "if" not in attributes and "unless" not in attributes:
            return True
        if "if" in attributes and "unless" in attributes:
            self.record(if_and_unless(self.document, element))
            self.block.visited.add(element.index)
            self.conditions = (*self.conditions, Condition("if", self.place(attributes["if"].shown_span), True))
            self.assumed = True
            return True
        name = "if" if "if" in attributes else "unless"
        attribute = attributes[name]
        span = attribute.shown_span
        (value, reads) = self.traced(lambda: self.value(attribute, context))
        truth: bool | None = None
        if isinstance(value, str):
            try:
                truth = parse_condition(value)
            except ValueError as error:
                self.not_boolean(attribute, value, str(error))
        elif never_boolean(parts_of(attribute)):
            self.not_boolean(attribute, attribute.value, value.reason)
        taken = (True if truth is None else truth) is (name == "if")
        origin = Origin(self.place(span))
        outcome = None if truth is None else taken
        self.effect(LocalBranch(origin, self.place(element.start_span), element.tag, name, attribute.value, outcome, reads))
        if taken:
            self.block.visited.add(element.index)
            self.conditions = (*self.conditions, Condition(name, origin.place, truth is None))
            self.condition_reads |= reads
            self.assumed = self.assumed or truth is None
        return taken

    def not_boolean(self, condition: Attribute, value: str, reason: str) -> None:
        """Record that ``condition`` comes to ``value``, which is no truth value."""
        origin, name, text = self.at(condition.shown_span), condition.name, condition.value
        self.record(ConditionNotBoolean(origin=origin, refused=True, attribute=name, value=value, text=text, reason=reason))

    def traced(self, work: Callable[[], T]) -> tuple[T, frozenset[str]]:
        """The result of ``work`` and the args it read; ``$`` stands for anything outside the launch files, such as the environment."""
        before, self.reads = self.reads, set()
        try:
            return work(), frozenset(self.reads)
        finally:
            before |= self.reads
            self.reads = before

    def value_and_default(self, element: Element, context: Context) -> tuple[tuple[Value | None, Value | None], frozenset[str]]:
        """What the ``value`` and ``default`` of an ``<arg>`` resolve to, and the args that were read for them."""
        attributes = element.attributes
        value, default = attributes.get("value"), attributes.get("default")
        if (value is None or is_plain(value.value)) and (default is None or is_plain(default.value)):
            return (None if value is None else value.value, None if default is None else default.value), frozenset()
        if value is not None and default is None:
            alone = only_arg(parts_of(value))
            known = self.plain_argument(alone, context) if alone else None
            if known is not None:
                return (known, None), frozenset((alone,))
        return self.traced(lambda: (self.optional(element, "value", context), self.optional(element, "default", context)))

    def from_environment(self, reads: frozenset[str]) -> bool:
        """Whether one of the args ``reads``, or an arg of this file that it was made from, asked for an environment variable."""
        if not self._outside:
            return False
        seen: set[str] = set()
        waiting = list(reads)
        while waiting:
            name = waiting.pop()
            if name == OUTSIDE or name in self.environment_arguments:
                return True
            if name not in seen:
                seen.add(name)
                waiting.extend(self.block.argument_reads.get(name, ()))
        return False

    def open_setting(self, context: Context, kind: str, key: str, value: object, origin: Origin, replaced: Place | None) -> None:
        """A remap, env or ``~param`` outside a node comes into force; the one that it replaces in its own scope ends."""
        work = len(context.nodes_above) + len(context.settings)
        if work >= INHERITED_PER_ELEMENT:
            self.spend(work // INHERITED_PER_ELEMENT, origin.place.span)
        for setting in context.settings:
            if setting.kind == kind and setting.key == key and setting.origin.place == replaced:
                setting.ended = True
        context.settings.append(ActiveSetting(kind, key, value, origin, tuple(context.nodes_above), replaced, self.conditions))

    def close_settings(self, context: Context, end: int) -> None:
        """The scope ends at the offset ``end``: say of each of its settings how many nodes it acted on."""
        for setting in context.settings:
            self.effect(
                ScopedSetting(
                    setting.kind,
                    setting.key,
                    setting.value,
                    setting.origin,
                    setting.reached,
                    setting.before,
                    setting.replaced,
                    setting.conditions,
                    end,
                )
            )
