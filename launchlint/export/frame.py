"""One launch file on its way into the exported one: its args, what is in force in it, and how its values will be written."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable

from launchlint.evaluate.ros1.file import FileEvaluation
from launchlint.evaluate.ros1.scope import Context
from launchlint.evaluate.ros1.substitution import resolve
from launchlint.evaluate.session import Session
from launchlint.export.expression import NotCovered, exchanged, names_read, uses, variables_read
from launchlint.export.tree import Out, Piece
from launchlint.export.written import CannotExport, Fixed, Setting, Written
from launchlint.model import Unknown
from launchlint.source import Span
from launchlint.syntax.parts import Expression, Substitution
from launchlint.syntax.ros1.substitutions import expression_in, opens, parse
from launchlint.syntax.tree import Comment, Document, Element

LARGEST_EXPORT = 16 * 1024 * 1024
"""Characters of an exported file: an include that includes another twice, and so on, doubles at each level."""


class Plan:
    """What one attempt at an export knows and collects.

    ``fixed`` are sources whose value is that of this configuration, ``kept`` says whether the args of the entry file stay open;
    ``isolated`` are the IDs of ``$(anon)`` that mean different names in different places, ``once`` the anonymous names that stand in one
    element only. ``names`` are the args of the exported file. ``made`` counts for each anonymous name the elements it stands in,
    ``ids`` says which ID it is made from. ``local`` are the directories outside packages that files stand in, each with such a file.
    ``angles``: a ``<rosparam>`` has been written, so that YAML may hold angles.
    """

    def __init__(self, session: Session, entry: str, *, kept: bool, fixed: frozenset[str], isolated: frozenset[str]) -> None:
        self.session = session
        self.entry = entry
        self.kept = kept
        self.fixed = fixed
        self.isolated = isolated
        self.once: frozenset[str] = frozenset()
        self.names: set[str] = set()
        self.made: dict[str, int] = {}
        self.ids: dict[str, str] = {}
        self.local: dict[str, str] = {}
        self.touched: set[str] = set()
        self.size = 0
        self._comments: dict[int, dict[int, list[Comment]]] = {}
        self.angles = False

    def comments_in(self, document: Document, parent: Element) -> list[Comment]:
        """The comments right inside ``parent``."""
        known = self._comments.get(id(document))
        if known is None:
            known = self._comments[id(document)] = {}
            for comment in document.comments:
                known.setdefault(id(comment.parent), []).append(comment)
        return known.get(id(parent), [])

    def unique(self, wanted: str) -> str:
        """An arg name like ``wanted`` that is not taken."""
        base = re.sub(r"_{2,}", "_", re.sub(r"\W", "_", wanted, flags=re.ASCII)) or "value"
        name, number = base, 1
        while name in self.names:
            number += 1
            name = f"{base}_{number}"
        self.names.add(name)
        return name

    def spend(self, text: str) -> None:
        """Count what is written. Raises CannotExport at the bound."""
        self.size += len(text) + 1
        if self.size > LARGEST_EXPORT:
            raise CannotExport(f"the exported file would be larger than {LARGEST_EXPORT // (1024 * 1024)} MiB")

    def portable(self, value: str) -> str:
        """``value`` with ``$(find package)`` in place of the directories of packages, so that it holds on another machine, too; as it is
        where a ``$(`` stands in it, which would take what is written behind it for its own.
        """
        if "/" not in value or opens(value):
            return value
        packages = self.session.packages
        words = value.split(" ")
        for number, word in enumerate(words):
            match = re.search(r"(?:^|(?<=[=:'\",]))/[^'\",:]*", word)
            package = packages.package_of(match[0]) if match is not None and os.path.exists(match[0]) else None
            if match is None or package is None or not package.name:
                continue
            directory = packages.find(package.name, self.entry)
            path = match[0]
            if directory is None or not (path == directory or path.startswith(directory + "/")):
                continue
            rest = path[len(directory) :]
            if packages.resolve_resource(directory, rest + word[match.end() :]) == path + word[match.end() :]:
                words[number] = f"{word[: match.start()]}$(find {package.name}){rest}{word[match.end() :]}"
        return " ".join(words)


class Frame:
    """One scope of one launch file.

    ``arguments`` are its args as they are written; ``namespace`` is where its names begin, from the enclosing group that is kept.
    ``remaps``, ``environment`` and ``inherited`` with ``private`` (the ``~params`` of this file) act on the nodes that follow. ``doubt``
    holds the sources of the conditions around it that are not met here. ``out`` is where what it exports goes.
    """

    def __init__(self, plan: Plan, evaluation: FileEvaluation, context: Context, out: list[Piece]) -> None:
        self.plan = plan
        self.evaluation = evaluation
        self.context = context
        self.out = out
        self.arguments: dict[str, Written] = {}
        self.halves: dict[str, str] = {}
        self.namespace = ""
        self.remaps: list[Setting] = []
        self.environment: list[Setting] = []
        self.inherited: list[Setting] = []
        self.private: list[Setting] = []
        self.doubt: frozenset[str] = frozenset()

    def inner(self, context: Context, out: list[Piece]) -> Frame:
        """A scope inside this one, in the same file."""
        frame = Frame(self.plan, self.evaluation, context, out)
        frame.arguments, frame.halves = dict(self.arguments), dict(self.halves)
        frame.namespace, frame.doubt = self.namespace, self.doubt
        frame.remaps, frame.environment = list(self.remaps), list(self.environment)
        frame.inherited, frame.private = self.inherited, list(self.private)
        return frame

    def written(self, text: str, context: Context | None = None) -> Written:
        """How ``text``, an attribute value or YAML, is written in the exported file. Raises Fixed and CannotExport."""
        if "$" not in text:
            return Written(text, text)
        parts = parse(text)
        value = resolve(self.evaluation, parts, lambda start, end: Span(0, 0), self.context if context is None else context)
        if isinstance(value, Unknown):
            if self.doubt:
                raise Fixed(self.doubt, f"{text} has no value on the side that is not taken ({value.reason})")
            raise CannotExport(f"the value of {text} is not known: {value.reason}")
        self.plan.spend(value)
        if parts.expression is not None:
            return self._expression(parts.expression, value)
        written, sources, anonymous = [], frozenset[str](), False
        for part in parts.parts:
            if not isinstance(part, Substitution):
                written.append(part.text)
                continue
            piece = self._substitution(part, context)
            written.append(piece.text)
            sources |= piece.sources
            anonymous |= piece.anonymous
        result = "".join(written)
        if not sources and not anonymous and result != text and any(parse(result).substitutions("find")) and self._plain(result) != value:
            result = self.plan.portable(value)
        return Written(result, value, sources, anonymous)

    def bind(self, wanted: str, written: Written) -> Written:
        """An arg of the exported file that has the value ``written``; it stands before what is written next."""
        name = self.plan.unique(wanted)
        self.out.append(Out("arg", {"name": name, "value": written.text}))
        return Written(f"$(arg {name})", written.value, written.sources)

    def settled(self, name: str, written: Written) -> Written:
        """``written`` as the value of an arg: by name where its text would mean something else in the middle of another one."""
        return self.bind(name, written) if written.anonymous or expression_in(written.text) is not None else written

    def _plain(self, text: str) -> object:
        return resolve(self.evaluation, parse(text), lambda start, end: Span(0, 0), Context("/", None))

    def _substitution(self, part: Substitution, context: Context | None) -> Written:
        text, command = part.text, part.command
        words = [word.text for word in part.words]
        name = words[1] if len(words) > 1 else ""
        if command == "arg":
            return self.arguments.get(name) or Written(text, "")
        if command in ("env", "optenv"):
            source = f"${name}"
            if source in self.plan.fixed:
                value = self.plan.session.variable(name)
                return Written(" ".join(words[2:]) if value is None else value, "")
            return Written(text, "", frozenset((source,)))
        if command == "dirname":
            return Written(self.directory(), "")
        if command == "anon":
            identity = (context or self.context).anonymous.get(name, name)
            self.plan.ids[identity] = name
            self.plan.touched.add(identity)
            return Written(text, "", anonymous=True)
        return Written(text, "")

    def directory(self) -> str:
        """``$(dirname)`` of this file, as another file may say it."""
        directory = self.plan.portable(self.evaluation.dirname())
        if directory.startswith("/"):
            self.plan.local[directory] = self.plan.session.shown(self.evaluation.file)
        return directory

    def _expression(self, part: Expression, value: str) -> Written:
        text, expression = part.text, part.code
        try:
            read = names_read(expression)
            sources = self._sources(read) | {f"${name}" for name in variables_read(expression)} - self.plan.fixed
            anonymous = uses(expression, "anon") or any(self.arguments[name].anonymous for name in read if name in self.arguments)
        except NotCovered:
            sources = self._sources(read)
            if sources:
                raise Fixed(sources, f"{text} cannot be written with other names") from None
            return Written(self.plan.portable(value), value)
        if not sources and not anonymous:
            return Written(self.plan.portable(value), value)
        try:
            rewritten = exchanged(expression, self._exchange, self._fixed_variables(), self._bound_directory)
        except NotCovered:
            if not sources:
                raise CannotExport(f"{text} makes up a name in a way that cannot be repeated") from None
            raise Fixed(frozenset(sources), f"{text} cannot be written with other names") from None
        return Written(f"$(eval {rewritten})", value, frozenset(sources), anonymous)

    def _sources(self, names: Iterable[str]) -> frozenset[str]:
        return frozenset().union(*(self.arguments[name].sources for name in names if name in self.arguments))

    def _exchange(self, name: str) -> Written | None:
        written = self.arguments.get(name)
        if written is None or written.only_arg == name:
            return None
        if written.only_arg is None and (written.sources or parse(written.text).computed):
            written = self.arguments[name] = self.bind(name, written)
        return written

    def _fixed_variables(self) -> dict[str, str | None]:
        return {source[1:]: self.plan.session.variable(source[1:]) for source in self.plan.fixed if source[0] == "$"}

    def _bound_directory(self) -> str:
        name = self.bind("directory", Written(self.directory(), "")).only_arg
        assert name is not None
        return name
