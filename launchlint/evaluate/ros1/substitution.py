"""What ``$(…)`` in attribute values and in rosparam text stands for (roslaunch.substitution_args).

How it is written is said in :mod:`launchlint.syntax.ros1.substitutions`. ``env``, ``optenv``, ``dirname``, ``anon`` and ``arg`` are
replaced in a first pass, ``find`` in a second one, since the path behind it takes part in the search. Whatever cannot be known makes the
whole value an :class:`~launchlint.model.Unknown`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable

from launchlint.evaluate.block import Value
from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.problems import BadSubstitution, EnvUnset, EvalError, EvalNeverEqual, EvalNotCovered, PackageNotFound
from launchlint.evaluate.ros1.scope import Context
from launchlint.late import late
from launchlint.model import Unknown
from launchlint.source import Span
from launchlint.syntax.parts import Expression, Parts, Substitution
from launchlint.syntax.ros1.substitutions import COMMANDS, opens, parse_again

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros1.file import FileEvaluation

OUTSIDE = "$"
"""Stands among the args read for whatever is not an arg: an environment variable."""
ANONYMOUS_FOLD = str.maketrans(".-:", "___")

_LONGEST_BOOLEAN = len("false")
_SEVERAL = late(r"\*{2,}")

Where = Callable[[int, int], Span]

SHORT = 100
"""Texts of fewer characters cost nothing in :meth:`~launchlint.evaluate.ros1.file.FileEvaluation.spend_characters`."""


class _Bad(Exception):
    """roslaunch refuses the text: ``reason`` in plain words, ``start`` and ``end`` in the text."""

    def __init__(self, reason: str, start: int, end: int) -> None:
        super().__init__(reason)
        self.reason = reason
        self.start = start
        self.end = end


class _NotKnown(Exception):
    """A piece of the value is unknown; the problem, if there is one, has been recorded."""

    def __init__(self, reason: str, pattern: str = "*") -> None:
        super().__init__(reason)
        self.reason = reason
        self.pattern = pattern


def resolve(evaluation: FileEvaluation, parts: Parts, where: Where, context: Context) -> Value:
    """The value of a text taken apart, in ``context``; problems are recorded on ``evaluation`` at the place ``where`` gives for offsets
    into the text.
    """
    text = parts.text
    if "$" not in text:
        return text
    try:
        expression = parts.expression
        if expression is not None:
            value = _evaluate(evaluation, expression, where, context)
            if isinstance(value, str):
                evaluation.spend_characters(len(value), where(0, len(text)))
            return value
        try:
            first = _replace(evaluation, parts, where, context, finds=False)
        except _NotKnown:
            _replace(evaluation, parts, where, context, finds=True)  # for what is wrong with it
            raise
        if not opens(first):
            return first
        if first != text:
            where, parts = _through(text, first, where), parse_again(first)
        return _replace(evaluation, parts, where, context, finds=True)
    except _Bad as bad:
        origin, written = evaluation.at(where(bad.start, bad.end)), parts.text[bad.start : bad.end]
        evaluation.record(BadSubstitution(origin=origin, refused=True, reason=bad.reason, text=written))
        return Unknown(text, bad.reason)
    except _NotKnown as unknown:
        return Unknown(text, unknown.reason, unknown.pattern)


def _through(text: str, replaced: str, where: Where) -> Where:
    """Places in a text after its first pass: exact for what did not move, else the whole value."""

    def place(start: int, end: int) -> Span:
        piece = replaced[start:end]
        at = text.find(piece)
        return where(at, at + len(piece)) if at >= 0 else where(0, len(text))

    return place


def _replace(evaluation: FileEvaluation, parts: Parts, where: Where, context: Context, *, finds: bool) -> str:
    if parts.refused is not None:
        bad = parts.refused
        raise _Bad(bad.refused, bad.start, bad.end + 1)  # up to the character that must not stand there
    resolved = parts.text
    unknown: str | None = None
    for part in parts.parts:
        if not isinstance(part, Substitution):
            continue
        words = part.words
        if not words:
            raise _Bad("there is no command in it", part.start, part.end)
        command = words[0].text
        if not finds and command == "arg" and len(words) == 2 and len(resolved) < SHORT:
            # Most of what a launch file holds; a span is made where something is to be said of it only.
            known = evaluation.known_argument(words[1].text, context)
            if known is not None and len(known) < SHORT:
                resolved = resolved.replace(part.text, known)
                continue
        if command not in COMMANDS:
            raise _Bad(f"{command} is not a substitution command", part.start, part.end)
        if (command == "find") is not finds:
            continue
        span = where(part.start, part.end)
        evaluation.spend_characters(len(resolved), span)  # each one goes over the whole text
        try:
            if command == "find":
                resolved = _find(evaluation, resolved, part, span, context)
            else:
                value = _simple(evaluation, part, span, context)
                if len(value) > len(part.text):
                    evaluation.spend_characters(len(value) * resolved.count(part.text), span)
                resolved = resolved.replace(part.text, value)
        except _NotKnown as not_known:
            unknown = unknown or not_known.reason  # the rest may be wrong too
    if unknown is not None:
        raise _NotKnown(unknown, _SEVERAL.sub("*", parse_again(resolved).beside("*")))
    return resolved


def _simple(evaluation: FileEvaluation, part: Substitution, span: Span, context: Context) -> str:
    command = part.command
    if command == "dirname":
        return evaluation.dirname()
    arguments = [word.text for word in part.words[1:]]
    if not arguments:
        raise _Bad(f"{command} needs a name", part.start, part.end)
    name = arguments[0]
    if command == "optenv":
        return evaluation.variable(name, " ".join(arguments[1:]))
    if len(arguments) > 1:
        raise _Bad(f"{command} takes one name only", part.start, part.end)
    if command == "env":
        return _environment(evaluation, name, span, context)
    if command == "anon":
        return evaluation.anonymous_name(name, context)
    return _argument(evaluation, name, span, context)


def _argument(evaluation: FileEvaluation, name: str, span: Span, context: Context) -> str:
    value = evaluation.argument(name, span, context)
    if isinstance(value, Unknown):
        raise _NotKnown(value.reason)
    return value


def _environment(evaluation: FileEvaluation, name: str, span: Span, context: Context) -> str:
    value = evaluation.session.variable(name)
    if value is None:
        evaluation.record(EnvUnset(origin=evaluation.at(span), refused=True, variable=name))
        raise _NotKnown(f"the environment variable {name} is not set here")
    evaluation.read_outside()
    return value


def _find(evaluation: FileEvaluation, text: str, part: Substitution, span: Span, context: Context) -> str:
    """Replace the first ``$(find pkg)`` and the path behind it up to a blank (substitution_args._find)."""
    if not part.only:
        raise _Bad("find takes one package name", part.start, part.end)
    before, _, after = text.partition(part.text)
    path, blank, rest = after.partition(" ")
    directory = _package(evaluation, part.only, span, context)
    return before + evaluation.resource(directory, path) + blank + rest


def _package(evaluation: FileEvaluation, name: str, span: Span, context: Context) -> str:
    directory = evaluation.package(name)
    if directory is None:
        evaluation.record(PackageNotFound(origin=evaluation.at(span), refused=True, package=name, near=evaluation.entry))
        raise _NotKnown(f"the package {name} is not here")
    return directory


class AlreadyTold(UnknownValue):
    """A name in an expression has no known value; why has been recorded where it comes from."""


class _Names:
    """What ``$(eval …)`` can ask for (expression.Resolver)."""

    def __init__(self, evaluation: FileEvaluation, span: Span, context: Context) -> None:
        self.evaluation = evaluation
        self.span = span
        self.context = context

    def has_arg(self, name: str) -> bool:
        return self.evaluation.has_argument(name, self.context)

    def arg(self, name: str) -> str:
        from launchlint.evaluate.ros1.expression import UndefinedArg

        if not self.has_arg(name):
            raise UndefinedArg(name)
        value = self.evaluation.argument(name, self.span, self.context)
        if isinstance(value, Unknown):
            raise AlreadyTold(value.reason)
        return value

    def env(self, name: str) -> str:
        from launchlint.evaluate.ros1.expression import EnvironmentUnset

        value = self.evaluation.session.variable(name)
        if value is None:
            raise EnvironmentUnset(name)
        self.evaluation.read_outside()
        return value

    def optenv(self, name: str, default: str) -> str:
        return self.evaluation.variable(name, default)

    def find(self, package: str) -> str:
        try:
            return _package(self.evaluation, package, self.span, self.context)
        except _NotKnown as unknown:
            raise AlreadyTold(unknown.reason) from None

    def anon(self, name: str) -> str:
        return self.evaluation.anonymous_name(name, self.context)

    def dirname(self) -> str:
        return self.evaluation.dirname()


def _evaluate(evaluation: FileEvaluation, part: Expression, where: Where, context: Context) -> Value:
    from launchlint.evaluate.ros1.expression import ExpressionError, arguments_read, evaluate, never_equal

    expression, text, at = part.code, part.text, part.code_start
    evaluation.reads.update(arguments_read(expression))
    if "= '" in expression or "='" in expression or '="' in expression or '= "' in expression:
        for start, end, name, literal, negated in never_equal(expression):
            origin = evaluation.at(where(at + start, at + end))
            evaluation.record(EvalNeverEqual(origin=origin, name=name, literal=literal, negated=negated))
    try:
        return evaluate(expression, _Names(evaluation, where(0, len(text)), context))
    except UnknownValue as unknown:
        if not isinstance(unknown, AlreadyTold):
            evaluation.record(EvalNotCovered(origin=evaluation.at(where(at, len(text) - 1)), reason=str(unknown)))
        return Unknown(text, str(unknown))
    except ExpressionError as error:
        span = where(at + error.start, at + max(error.end, error.start + 1))
        if error.undefined_arg is not None:
            evaluation.missing_argument(error.undefined_arg, span, context, in_expression=True)
        elif error.unset_env is not None:
            evaluation.record(EnvUnset(origin=evaluation.at(span), refused=True, variable=error.unset_env))
        else:
            evaluation.spend_on_scope(context, span)
            known = tuple(sorted(filter(context.has_value, context.arguments)))
            origin, reason = evaluation.at(span), str(error)
            evaluation.record(EvalError(origin=origin, refused=True, reason=reason, expression=expression, known=known))
        return Unknown(text, "its $(eval …) fails")


def never_boolean(parts: Parts) -> bool:
    """Whether no values of its substitutions can make a boolean of a text, because of what is written beside them."""
    if parts.refused is not None or parts.expression is not None or any(parts.substitutions("eval")):
        return False  # what is wrong with it is told, or nobody knows
    beside = parts.beside("\0").strip().lower()
    if len(beside.replace("\0", "")) > _LONGEST_BOOLEAN:
        return True
    pattern = ".*".join(map(re.escape, re.split("\0+", beside)))
    return all(re.fullmatch(pattern, word) is None for word in ("true", "false", "1", "0"))


def absolute_directory(file: str) -> str:
    """The directory of ``file``, absolute (``$(dirname)``)."""
    return os.path.abspath(os.path.dirname(file))
