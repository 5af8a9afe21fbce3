"""The walk over a launch file and all that it includes: what would run, in the order in which roslaunch meets it.

It follows roslaunch's own walk (roslaunch.xmlloader), with the evaluator's functions wherever a value is needed. A side of a condition
that is not taken here is followed, too, where the exported file keeps the condition.
"""

from __future__ import annotations

from launchlint.evaluate.names import as_namespace
from launchlint.evaluate.ros1.file import FileEvaluation, Progress
from launchlint.evaluate.ros1.launch_tags import TAGS
from launchlint.evaluate.ros1.launch_tags import arg as declare
from launchlint.evaluate.ros1.scope import Context
from launchlint.evaluate.session import Read
from launchlint.export.frame import Frame, Plan
from launchlint.export.leaves import flag, in_order, line_ends, machine, node, param, rosparam, setting
from launchlint.export.names import below, open_namespace
from launchlint.export.tree import Note, Out, Piece, remark
from launchlint.export.written import Condition, Fixed, Setting, Written
from launchlint.syntax.ros1.domains import parse_condition
from launchlint.syntax.tree import Comment, Document, Element

DEEPEST = 250
"""Includes inside includes that are followed on sides that are not taken, too."""


class Walk:
    """One attempt. ``plan`` says what stays open, and knows afterwards what the exported file reads."""

    # ``speaking`` is the file of which something was exported last.

    def __init__(self, plan: Plan, given: dict[str, str]) -> None:
        self.plan = plan
        self.given = given
        self.progress = Progress()
        self.stack: list[str] = []
        self.speaking = ""

    def export(self, file: str) -> list[Piece]:
        """All that the exported file holds. Raises Fixed and CannotExport."""
        document = self.plan.session.document(file)
        assert not isinstance(document, Read)
        evaluation = self._evaluation(document, file, is_entry=True)
        context = Context("/", None)
        context.arguments = dict(self.given)
        out: list[Piece] = []
        frame = Frame(self.plan, evaluation, context, out)
        frame.arguments = {name: Written(value, value) for name, value in self.given.items()}
        assert document.launch is not None
        if "__ns" in self.given:
            frame.namespace = as_namespace(self.given["__ns"]).rstrip("/")
        self.stack.append(file)
        self._walk(frame, document.launch)
        return out

    def _evaluation(self, document: Document, file: str, *, is_entry: bool) -> FileEvaluation:
        return FileEvaluation(self.plan.session, document, file, self.plan.entry, self.progress, is_entry=is_entry, private_above=False)

    # -- one scope ---------------------------------------------------------------------------------------------

    def _walk(self, frame: Frame, parent: Element) -> None:
        """Export the children of a ``<launch>`` or ``<group>``, each with the comments right above it."""
        waiting: list[Note] = []
        end = 0
        gap = emitted = False
        for piece in in_order(frame, parent):
            lines = line_ends(frame, end, piece)
            blank = lines > 1 and end > 0
            if blank and waiting:  # comments with a blank line below them stand for themselves
                _put(frame.out, len(frame.out), waiting, gap=gap)
                gap = False
            gap = gap or blank
            if isinstance(piece, Comment):
                if lines or not end:
                    waiting.append(Note(piece.text))
                elif emitted:
                    frame.out.append(Note(piece.text, beside=True))
                end = piece.span.end
                continue
            end = piece.span.end
            at = len(frame.out)
            self._element(frame, piece)
            emitted = len(frame.out) > at
            if emitted:
                gap = self._say_where(frame, piece, waiting) or gap
                _put(frame.out, at, waiting, gap=gap)
                gap = False
            waiting.clear()
        _put(frame.out, len(frame.out), waiting, gap=gap)

    def _say_where(self, frame: Frame, element: Element, waiting: list[Note]) -> bool:
        """Where a file goes on after what it includes, say so. Returns whether that was the case."""
        if element.tag in ("group", "include"):
            return False
        title = self._title(frame.evaluation.file)
        before, self.speaking = self.speaking, title
        if before in ("", title):
            return False
        waiting.insert(0, Note(remark(f" back in {title} ")))
        return True

    def _element(self, frame: Frame, element: Element) -> None:
        if element.tag not in TAGS:
            return
        frame.evaluation.look_at(element)
        condition, met = self.condition(frame, element)
        if condition is None and not met:
            return
        outer, anonymous = frame.doubt, dict(frame.context.anonymous)
        if condition is not None and not condition.taken:
            frame.doubt = outer | condition.written.sources
        at = len(frame.out)
        try:
            self._tag(frame, element, condition)
        finally:
            frame.doubt = outer
        self._isolate(frame, anonymous, at)

    def _tag(self, frame: Frame, element: Element, condition: Condition | None) -> None:
        tag = element.tag
        if tag == "arg":
            self._arg(frame, element, condition)
        elif tag == "group":
            self._group(frame, element, condition)
        elif tag == "include":
            self._include(frame, element, condition)
        elif tag in ("remap", "env"):
            frame_list = frame.remaps if tag == "remap" else frame.environment
            _replace(frame_list, setting(frame, element, condition))
        elif tag == "param":
            private = param(frame, element, condition)
            if private is not None:
                _replace(frame.private, private)
        elif tag == "rosparam":
            rosparam(frame, element, condition)
        elif tag == "machine":
            machine(frame, element, condition)
        else:
            node(frame, element, condition, self.condition)

    def condition(self, frame: Frame, element: Element) -> tuple[Condition | None, bool]:
        """The condition of ``element`` that the exported file keeps, if any; and whether the element is evaluated here."""
        attribute = element.attributes.get("if") or element.attributes.get("unless")
        if attribute is None:
            return None, True
        written = frame.written(attribute.value)
        try:
            met = parse_condition(written.known) is (attribute.name == "if")
        except ValueError:
            raise Fixed(frame.doubt, f"{attribute.value} is no truth value on the side that is not taken") from None
        return (Condition(attribute.name, written, met) if written.sources else None), met

    def _isolate(self, frame: Frame, before: dict[str, str], at: int) -> None:
        """Put what has been exported since ``at`` into a group of its own where it makes up a name that elsewhere is another one."""
        made = {name for name, identity in frame.context.anonymous.items() if before.get(name) != identity}
        lonely = made & self.plan.isolated
        if any(isinstance(piece, Out) and piece.tag == "arg" for piece in frame.out[at:]):
            return  # what follows reads it
        if lonely and all(frame.context.anonymous[name] in self.plan.once for name in lonely):
            _wrap(frame.out, at, Out("group", {}))

    # -- args --------------------------------------------------------------------------------------------------

    def _arg(self, frame: Frame, element: Element, condition: Condition | None) -> None:
        name = frame.written(element.get("name") or "").known
        value, default = element.get("value"), element.get("default")
        known = name in frame.arguments
        overridable = value is None and self.plan.kept and frame.evaluation.is_entry
        if overridable:
            self._overridable(frame, element, name, default, condition)
        elif value is not None and (not known or frame.context.lenient or condition is not None):
            self._value(frame, name, frame.written(value), condition)
        elif value is None and default is not None and (not known or name in frame.halves):
            self._value(frame, name, frame.written(default), condition)
        if condition is None or condition.taken:
            declare(frame.evaluation, element, frame.context)

    def _value(self, frame: Frame, name: str, written: Written, condition: Condition | None) -> None:
        if condition is None:
            frame.arguments[name] = frame.settled(name, written)
            return
        half = frame.halves.get(name)
        if half is None:
            half = frame.halves[name] = self.plan.unique(name)
        before = frame.arguments.get(name)
        frame.out.append(Out("arg", {"name": half, "value": written.text}, condition))
        value = written.value if condition.taken or before is None else before.value
        sources = written.sources | condition.written.sources | (before.sources if before is not None else frozenset())
        frame.arguments[name] = Written(f"$(arg {half})", value, sources)

    def _overridable(self, frame: Frame, element: Element, name: str, default: str | None, condition: Condition | None) -> None:
        """An arg of the entry file that people can still give: it stays, with what is given now as its default."""
        given = self.given.get(name)
        start = frame.written(default or "") if given is None else Written(given, given)
        if name in self.plan.fixed and condition is not None:
            raise Fixed(condition.written.sources, f"it decides how the arg {name} is declared, which is fixed")
        attributes = {"name": name}
        doc = element.get("doc")
        if default is not None or given is not None:
            attributes["value" if name in self.plan.fixed else "default"] = start.text
        if doc is not None:
            attributes["doc"] = frame.written(doc).text
        frame.out.append(Out("arg", attributes, condition))
        if name in self.plan.fixed:
            frame.arguments[name] = frame.settled(name, start)
            return
        before = frame.arguments.get(name)
        value = start.value if condition is None or condition.taken or before is None else before.value
        frame.arguments[name] = Written(f"$(arg {name})", value, frozenset((name,)))

    # -- scopes ------------------------------------------------------------------------------------------------

    def _group(self, frame: Frame, element: Element, condition: Condition | None) -> None:
        inner: list[Piece] = []
        scope = frame.inner(Context(frame.context.namespace, frame.context), inner)
        block = self._namespace(frame, scope, element)
        self._clear(scope, element)
        self._walk(scope, element)
        local = self.plan.kept and frame.evaluation.is_entry and any(child.tag == "arg" for child in element.children)
        self._close(frame, scope, inner, condition, block or (Out("group", {}) if local else None))

    def _include(self, frame: Frame, element: Element, condition: Condition | None) -> None:
        name = frame.written(element.get("file") or "")
        if name.sources:
            raise Fixed(name.sources, f"{element.get('file')} decides which file is included")
        inner: list[Piece] = []
        passing = frame.inner(Context(frame.context.namespace, frame.context), inner)
        block = self._namespace(frame, passing, element)
        pass_all = flag(frame, element, "pass_all_args")
        arguments = dict(passing.arguments) if pass_all else {}
        for child in element.children:
            tag = child.tag.lower()
            if tag not in ("arg", "env"):
                continue
            passing.evaluation.look_at(child)
            own, met = self.condition(passing, child)
            if own is None and not met:
                continue
            if tag == "env":
                _replace(passing.environment, setting(passing, child, own))
            elif own is not None:
                raise Fixed(own.written.sources, f"it decides whether an include gets the arg {child.get('name')}")
            else:
                passed = passing.written(child.get("name") or "").known
                text = child.get("value") if "value" in child.attributes else child.get("default")
                if text is not None and ("value" in child.attributes or passed not in arguments):
                    arguments[passed] = passing.settled(passed, passing.written(text))
        self._clear(passing, element)
        document = self._open(frame, name.known)
        if document is None:
            return
        evaluation = self._evaluation(document, name.known, is_entry=False)
        context = Context("/", None)
        context.arguments = {passed: written.value for passed, written in arguments.items()}
        context.lenient = pass_all
        entered = Frame(self.plan, evaluation, context, inner)
        entered.arguments = arguments
        entered.namespace, entered.doubt = passing.namespace, frame.doubt
        entered.remaps, entered.environment = list(passing.remaps), list(passing.environment)
        entered.inherited = [*_unset(frame.inherited, frame.private), *frame.private]
        before, self.speaking = self.speaking, self._title(name.known)
        inner.append(Note(remark(f" from {self.speaking} "), apart=True))
        at = len(inner)
        assert document.launch is not None
        self.stack.append(name.known)
        self._walk(entered, document.launch)
        self.stack.pop()
        if len(inner) > at:
            inner[at].apart = False
        else:
            self.speaking = before
        if entered.inherited and entered.private:
            if condition is not None:
                raise Fixed(condition.written.sources, "a ~param of the included file acts beyond the include")
            for each in entered.private:
                _replace(frame.private, each)
        entered.context.anonymous = {name: identity for name, identity in entered.context.anonymous.items() if name in self.plan.isolated}
        self._close(frame, entered, inner, condition, block)

    def _open(self, frame: Frame, file: str) -> Document | None:
        document = self.plan.session.document(file)
        if isinstance(document, Read) or document.launch is None:
            raise Fixed(frame.doubt, f"{self.plan.session.shown(file)} cannot be read, and only the side that is not taken needs it")
        if len(self.stack) >= DEEPEST or self.stack.count(file) > 20:
            raise Fixed(frame.doubt, f"{self.plan.session.shown(file)} includes itself on the side that is not taken")
        return document

    def _title(self, file: str) -> str:
        package = self.plan.session.packages.package_of(file)
        if package is None or not package.name:
            return self.plan.session.shown(file)
        return f"{package.name}{file[len(package.directory) :]}" if file.startswith(package.directory) else self.plan.session.shown(file)

    def _namespace(self, frame: Frame, scope: Frame, element: Element) -> Out | None:
        """Let the names of ``scope`` begin where ``ns`` says. Returns the group that has to be around it, if one has."""
        attribute = element.attributes.get("ns")
        if attribute is None:
            return None
        written = frame.written(attribute.value)
        if not written.sources or not frame.namespace:
            scope.namespace = below(frame.namespace, written)
            return None
        scope.namespace = written.text
        return open_namespace(frame.namespace)

    def _clear(self, scope: Frame, element: Element) -> None:
        attribute = element.attributes.get("clear_params")
        if attribute is None or "ns" not in element.attributes:
            return
        written = scope.written(attribute.value)
        if written.sources or written.known.lower() == "true":
            scope.out.append(Out("group", {"ns": scope.namespace, "clear_params": written.text}))

    def _close(self, frame: Frame, scope: Frame, inner: list[Piece], condition: Condition | None, block: Out | None) -> None:
        """Put what a scope holds into the one around it: in a group where a condition, a name or an arg needs one."""
        if not any(isinstance(piece, Out) for piece in inner):
            return
        outside = frame.context.anonymous
        made = {name for name, identity in scope.context.anonymous.items() if outside.get(name) != identity} & self.plan.isolated
        if block is None and any(scope.context.anonymous[name] not in self.plan.once for name in made):
            block = Out("group", {})
        at = len(frame.out)
        frame.out.extend(inner)
        if block is not None:
            _wrap(frame.out, at, block)
        if condition is not None:
            only = [piece for piece in frame.out[at:] if isinstance(piece, Out)]
            if len(only) == 1 and not only[0].conditional and only[0].tag != "arg":
                only[0].attributes = {condition.attribute: condition.written.text, **only[0].attributes}
            else:
                _wrap(frame.out, at, Out("group", {}, condition))


def _put(out: list[Piece], at: int, notes: list[Note], *, gap: bool) -> None:
    """Move ``notes`` to the place ``at``; with ``gap``, what then stands there has a blank line before it."""
    if notes and at < len(out):
        out[at].apart = False
    out[at:at] = notes
    if at < len(out):
        out[at].apart = out[at].apart or gap
    notes.clear()


def _wrap(out: list[Piece], at: int, group: Out) -> None:
    """Put all of ``out`` from ``at`` on into ``group``, which takes its place."""
    group.children = out[at:]
    if group.children:
        group.apart, group.children[0].apart = group.children[0].apart, False
    out[at:] = [group]


def _replace(settings: list[Setting], new: Setting) -> None:
    """Add ``new``; an earlier one of the same spelling goes, where both always act. Of ``env`` all stay, as roslaunch keeps them."""
    if new.tag != "env" and new.key and new.condition is None:
        settings[:] = [old for old in settings if old.key != new.key or old.tag != new.tag]
    settings.append(new)


def _unset(settings: list[Setting], again: list[Setting]) -> list[Setting]:
    keys = {each.key for each in again if each.key and each.condition is None}
    return [each for each in settings if each.key not in keys]
