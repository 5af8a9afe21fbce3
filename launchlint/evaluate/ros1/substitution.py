"""``$(…)`` in attribute values and in rosparam text (roslaunch.substitution_args).

``env``, ``optenv``, ``dirname``, ``anon`` and ``arg`` are replaced in a first pass, ``find`` in a second one, since the path behind it
takes part in
the search. ``$(eval …)`` must fill the whole value. Whatever cannot be known makes the whole value an :class:`~launchlint.model.Unknown`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from functools import lru_cache

from launchlint.evaluate.block import Value
from launchlint.evaluate.ros1.scope import Context
from launchlint.evaluate.ros1.values import UnknownValue
from launchlint.model import Unknown
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros1.file import FileEvaluation

OUTSIDE = "$"
"""Stands among the args read for whatever is not an arg: an environment variable."""
COMMANDS = ("find", "env", "optenv", "dirname", "anon", "arg")
ANONYMOUS_FOLD = str.maketrans(".-:", "___")

_LONGEST_BOOLEAN = len("false")

Where = Callable[[int, int], Span]

SHORT = 100
"""Texts of fewer characters cost nothing in :meth:`~launchlint.evaluate.ros1.file.FileEvaluation.spend_characters`."""
LONGEST_KEPT = 2_000
"""Characters of a text whose parts are remembered: the same attributes are resolved in every configuration, long texts are few."""


class BadSubstitution(Exception):
    """The text cannot be taken apart: ``reason`` in plain words, ``start`` and ``end`` in the text."""

    def __init__(self, reason: str, start: int, end: int) -> None:
        super().__init__(reason)
        self.reason = reason
        self.start = start
        self.end = end


_PLAIN = re.compile(r"\$\(([^$()]+)\)")
_LEFT = re.compile(r"(?:\$\([^$()]+\)|\*)+")
"""A substitution with nothing odd in it; where all of a text are, no walk over its characters is needed."""


_ONLY_ARG = re.compile(r"\$\(arg ([^ $()]+)\)")


class _NotKnown(Exception):
    """A piece of the value is unknown; the problem, if there is one, has been recorded."""

    def __init__(self, reason: str, pattern: str = "*") -> None:
        super().__init__(reason)
        self.reason = reason
        self.pattern = pattern


def collect(text: str) -> tuple[tuple[str, int, int], ...]:
    """The inner texts of ``$(…)`` in ``text`` with start and end of the whole (substitution_args._collect_args).

    A ``$(`` that is never closed is no substitution. Raises BadSubstitution for ``$`` or ``(`` inside one.
    """
    if "$(" not in text:
        return ()
    return _kept(text) if len(text) <= LONGEST_KEPT else _collect(text)


def _collect(text: str) -> tuple[tuple[str, int, int], ...]:
    plain = tuple((match[1], *match.span()) for match in _PLAIN.finditer(text))
    if text.count("$") == text.count("(") == len(plain):
        return plain
    found: list[tuple[str, int, int]] = []
    outside, dollar, opened, inside = range(4)
    state, begin, first = outside, 0, 0
    for index, char in enumerate(text):
        if char == "$":
            if state in (opened, inside):
                raise BadSubstitution("a substitution cannot stand inside another one", begin, index + 1)
            state, begin = dollar, index
        elif char == "(":
            if state == dollar:
                state = opened
            elif state != outside:
                raise BadSubstitution("a parenthesis cannot stand inside a substitution", begin, index + 1)
        elif char == ")":
            if state == inside:
                found.append((text[first:index], begin, index + 1))
            state = outside
        elif state == dollar:
            state = outside
        elif state == opened:
            state, first = inside, index
    return tuple(found)


_kept = lru_cache(maxsize=2048)(_collect)


@lru_cache(maxsize=2048)
def only_arg(text: str) -> str:
    """The name of the arg where ``text`` is ``$(arg name)`` and nothing else: most of what launch files hold. Else empty."""
    match = _ONLY_ARG.fullmatch(text) if len(text) < SHORT else None
    return "" if match is None else match[1]


def resolve(evaluation: FileEvaluation, text: str, where: Where, context: Context) -> Value:
    """The value of ``text`` in ``context``; problems are recorded on ``evaluation`` at the place ``where`` gives for offsets into
    ``text``.
    """
    if "$" not in text:
        return text
    try:
        if text.startswith("$(eval ") and text.endswith(")"):
            value = _evaluate(evaluation, text, where, context)
            if isinstance(value, str):
                evaluation.spend_characters(len(value), where(0, len(text)))
            return value
        try:
            first = _replace(evaluation, text, where, context, finds=False)
        except _NotKnown:
            _replace(evaluation, text, where, context, finds=True)  # for what is wrong with it
            raise
        if "$(" not in first:
            return first
        where, text = _through(text, first, where), first
        return _replace(evaluation, text, where, context, finds=True)
    except BadSubstitution as bad:
        evaluation.problem("bad-substitution", where(bad.start, bad.end), refused=True, reason=bad.reason, text=text[bad.start : bad.end])
        return Unknown(text, bad.reason)
    except _NotKnown as unknown:
        return Unknown(text, unknown.reason, unknown.pattern)


def _through(text: str, replaced: str, where: Where) -> Where:
    """Places in a text after its first pass: exact for what did not move, else the whole value."""
    if text == replaced:
        return where

    def place(start: int, end: int) -> Span:
        piece = replaced[start:end]
        at = text.find(piece)
        return where(at, at + len(piece)) if at >= 0 else where(0, len(text))

    return place


def _replace(evaluation: FileEvaluation, text: str, where: Where, context: Context, *, finds: bool) -> str:
    resolved = text
    unknown: _NotKnown | None = None
    for inner, start, end in collect(text):
        name = inner[4:] if not finds and inner.startswith("arg ") else ""
        if name and " " not in name and len(resolved) < SHORT:
            # Most of what a launch file holds; a span is made where something is to be said of it only.
            known = evaluation.known_argument(name, context)
            if known is not None and len(known) < SHORT:
                resolved = resolved.replace(text[start:end], known)
                continue
        words = [word for word in inner.split(" ") if word]
        if not words:
            raise BadSubstitution("there is no command in it", start, end)
        command, arguments = words[0], words[1:]
        if command not in COMMANDS:
            raise BadSubstitution(f"{command} is not a substitution command", start, end)
        if (command == "find") is not finds:
            continue
        span = where(start, end)
        evaluation.spend_characters(len(resolved), span)  # each one goes over the whole text
        try:
            if command == "find":
                resolved = _find(evaluation, resolved, inner, arguments, (start, end), span, context)
            else:
                value, written = _simple(evaluation, command, arguments, (start, end), span, context), f"$({inner})"
                if len(value) > len(written):
                    evaluation.spend_characters(len(value) * resolved.count(written), span)
                resolved = resolved.replace(written, value)
        except _NotKnown as reason:
            unknown = unknown or reason  # the rest may be wrong too
    if unknown is not None:
        raise _NotKnown(unknown.reason, _LEFT.sub("*", resolved))
    return resolved


def _simple(evaluation: FileEvaluation, command: str, arguments: list[str], at: tuple[int, int], span: Span, context: Context) -> str:
    if command == "dirname":
        return evaluation.dirname()
    if not arguments:
        raise BadSubstitution(f"{command} needs a name", *at)
    name = arguments[0]
    if command == "optenv":
        return evaluation.variable(name, " ".join(arguments[1:]))
    if len(arguments) > 1:
        raise BadSubstitution(f"{command} takes one name only", *at)
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
        evaluation.problem("env-unset", span, refused=True, variable=name)
        raise _NotKnown(f"the environment variable {name} is not set here")
    evaluation.reads.add(OUTSIDE)
    return value


def _find(
    evaluation: FileEvaluation, text: str, inner: str, arguments: list[str], at: tuple[int, int], span: Span, context: Context
) -> str:
    """Replace the first ``$(find pkg)`` and the path behind it up to a blank (substitution_args._find)."""
    if len(arguments) != 1:
        raise BadSubstitution("find takes one package name", *at)
    before, _, after = text.partition(f"$({inner})")
    path, blank, rest = after.partition(" ")
    directory = _package(evaluation, arguments[0], span, context)
    return before + evaluation.resource(directory, path) + blank + rest


def _package(evaluation: FileEvaluation, name: str, span: Span, context: Context) -> str:
    directory = evaluation.package(name)
    if directory is None:
        evaluation.problem("package-not-found", span, refused=True, package=name, near=evaluation.entry)
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
        self.evaluation.reads.add(OUTSIDE)
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


def _evaluate(evaluation: FileEvaluation, text: str, where: Where, context: Context) -> Value:
    from launchlint.evaluate.ros1.expression import ExpressionError, arguments_read, evaluate, never_equal

    expression = text[7:-1]
    evaluation.reads.update(arguments_read(expression))
    if "= '" in expression or "='" in expression or '="' in expression or '= "' in expression:
        for start, end, name, literal in never_equal(expression):
            evaluation.problem("eval-never-equal", where(7 + start, 7 + end), name=name, literal=literal)
    try:
        return evaluate(expression, _Names(evaluation, where(0, len(text)), context))
    except UnknownValue as unknown:
        if not isinstance(unknown, AlreadyTold):
            evaluation.problem("eval-not-covered", where(7, len(text) - 1), reason=str(unknown))
        return Unknown(text, str(unknown))
    except ExpressionError as error:
        span = where(7 + error.start, 7 + max(error.end, error.start + 1))
        if error.undefined_arg is not None:
            evaluation.missing_argument(error.undefined_arg, span, context)
        elif error.unset_env is not None:
            evaluation.problem("env-unset", span, refused=True, variable=error.unset_env)
        else:
            evaluation.spend_on_scope(context, span)
            known = tuple(sorted(filter(context.has_value, context.arguments)))
            evaluation.problem("eval-error", span, refused=True, reason=str(error), expression=expression, known=known)
        return Unknown(text, "its $(eval …) fails")


_LOOKS_LIKE = (
    r"\$\s+\((?:find|env|optenv|dirname|anon|arg|eval)\b(?:\s+[\w./\-]+)*\s*\)?"
    r"|\$\{(?:find|env|optenv|anon|arg) [\w./\- ]*\}?"
    r"|\$\((?:find|env|optenv|dirname|anon|arg|eval)\b(?:\s+[\w\-]+)?[}\]]?"
    r"|\$(?:find|env|optenv|anon|arg) +[\w\-]+(?: +[^()$ ]+)*\)"
    r"|\$(?:find|env|optenv|anon|arg)\( *[\w\-]+ *\)"
    r"|(?<![\w$)])\((?:find|optenv|anon|arg) [\w\-]+\)"
    r"|\$\[(?:find|arg|env) [\w./\- ]*\]?"
)


def left_over(text: str) -> tuple[int, int, bool] | None:
    """Start and end of what looks like a substitution in ``text`` and is none, so that it stays in the value; True: a ``)`` too many."""
    return _kept_left_over(text) if len(text) <= LONGEST_KEPT else _left_over(text)


def _left_over(text: str) -> tuple[int, int, bool] | None:
    try:
        found = collect(text)
    except BadSubstitution:
        return None
    rest = text
    for _, start, end in found:
        rest = rest[:start] + " " * (end - start) + rest[end:]
    match = re.search(_LOOKS_LIKE, rest)
    if match is not None:
        return (*match.span(), False)
    if rest.count(")") > rest.count("("):
        for _, _, end in found:
            if text[end : end + 1] == ")":
                return end, end + 1, True
    return None


_kept_left_over = lru_cache(maxsize=2048)(_left_over)


def never_boolean(text: str) -> bool:
    """Whether no values of the substitutions in ``text`` can make a boolean of it, because of what is written beside them."""
    if text.startswith("$(eval "):
        return False
    try:
        found = collect(text)
    except BadSubstitution:
        return False
    beside, end = "", 0
    for _, start, after in found:
        beside += text[end:start] + "\0"
        end = after
    beside = (beside + text[end:]).strip().lower()
    if len(beside.replace("\0", "")) > _LONGEST_BOOLEAN:
        return True
    pattern = ".*".join(map(re.escape, re.split("\0+", beside)))
    return all(re.fullmatch(pattern, word) is None for word in ("true", "false", "1", "0"))


def absolute_directory(file: str) -> str:
    """The directory of ``file``, absolute (``$(dirname)``)."""
    return os.path.abspath(os.path.dirname(file))
