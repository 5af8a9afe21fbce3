"""Where the values of the entry file's args go to in one configuration, and so which values somebody would give them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.ros1.arg_uses import ArgUses, arg_uses, is_boolean, settled_defaults
from launchlint.evaluate.session import Session
from launchlint.model import Branch, Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros1.substitutions import expression_in

MOST_PLACES = 2_000
"""Args of files that one arg of the entry file is followed into."""

Pairs = tuple[tuple[str, str], ...]
"""Args that are given, with their values."""
At = tuple[str, str]
"""An arg in a file: the path, and the name it has there."""


class Nature(NamedTuple):
    """What an arg of the entry file is for, from all that its value reaches as it is.

    ``truth``: a condition or flag consists of it, or an expression asks whether it is true. ``text``: it is text somewhere; where a
    condition consists of it, so that roslaunch takes nothing but a boolean, being part of a name does not count. ``literals`` are what it
    is compared with: only as a whole, where it is part of a path or name; ``places`` the args that take its value.
    """

    truth: bool
    text: bool
    literals: tuple[str, ...]
    places: frozenset[At]


class ArgFlow:
    """The args of one evaluation. What the files do with them is read once in a ``session``."""

    def __init__(self, session: Session, evaluation: Evaluation) -> None:
        self._session = session
        self._documents = evaluation.documents
        self._launch = evaluation.launch
        self._natures: dict[str, Nature] = {}

    @cached_property
    def _defaults(self) -> dict[str, str | Unknown | None]:
        """The defaults of the args of the entry file."""
        declared = self._launch.declared
        return {argument.name: argument.default for argument in declared if argument.origin.step is None and not argument.passed}

    @cached_property
    def _settled(self) -> dict[str, str]:
        document = self._documents.get(self._launch.entry.path)
        return {} if document is None else settled_defaults(document)

    def telling(self, given: Pairs) -> Pairs:
        """The args of ``given`` without those that get a plain default, with which all conditions are as without them."""
        settled = self._settled
        return tuple(pair for pair in given if settled.get(pair[0]) != pair[1] or "$" in pair[1] or pair[1] != pair[1].strip())

    def has(self, pairs: Pairs) -> bool:
        """Whether all args of ``pairs`` have these values in this configuration, whether given or by default: all conditions stay so."""
        given = dict(self._launch.given)
        return all(
            name in self._settled and value == given.get(name, self._defaults.get(name)) and value == value.strip() for name, value in pairs
        )

    @cached_property
    def _declared(self) -> set[At]:
        """The args that the reached files declare."""
        return {(argument.origin.place.source.path, argument.name) for argument in self._launch.declared if not argument.passed}

    @cached_property
    def _calls(self) -> dict[str, dict[tuple[int, str, bool], None]]:
        """By path, the includes of each file: the offset, the included path, and whether all args are passed."""
        calls: dict[str, dict[tuple[int, str, bool], None]] = {}
        for include in self._launch.includes:
            if include.source is not None:
                source, span = include.origin.place
                calls.setdefault(source.path, {})[span.start, include.source.path, include.pass_all_args] = None
        return calls

    def _uses(self, path: str) -> ArgUses:
        document = self._documents[path]
        known = self._session.uses.get(document)
        if known is None:
            known = self._session.uses[document] = arg_uses(document)
        return known

    def nature(self, name: str) -> Nature:
        """What the entry file's arg ``name`` is for."""
        known = self._natures.get(name)
        if known is None:
            known = self._natures[name] = self._nature(name)
        return known

    def booleans(self, name: str, wanted: bool) -> tuple[str, ...]:
        """``wanted`` and then the other boolean, as the arg ``name`` would be given them; nothing where it is no boolean.

        It is none where it is used as text anywhere: whoever gave it a boolean would break what is not broken.
        """
        nature, default = self.nature(name), self._defaults.get(name)
        written = default.strip().lower() if isinstance(default, str) else None
        if nature.text or (written is not None and not is_boolean(written)):
            return ()
        if not nature.truth and written not in ("true", "false"):
            return ()
        yes, no = ("1", "0") if written in ("1", "0") else ("true", "false")
        return (yes, no) if wanted else (no, yes)

    def literals(self, name: str) -> tuple[str, ...]:
        """What the arg ``name`` is compared with anywhere; not the words of a boolean, which :meth:`booleans` gives."""
        return tuple(value for value in self.nature(name).literals if value.strip().lower() not in ("true", "false"))

    def literals_in(self, name: str, path: str, expression: str) -> Iterator[str]:
        """As :meth:`literals`, for one ``expression`` in the file ``path``."""
        from launchlint.evaluate.ros1.expression import compared_literals

        nature = self.nature(name)
        known = frozenset(nature.literals)
        for local, values in compared_literals(expression).items():
            if (path, local) in nature.places:
                yield from (value for value in values if value in known and value.lower() not in ("true", "false"))

    def turning(self, branch: Branch) -> Iterator[tuple[str, str]]:
        """Args with values that may turn a condition: what its ``$(eval …)`` compares them with, or the opposite boolean."""
        names = sorted(branch.steered_by)
        expression = expression_in(branch.text)
        if expression is not None:
            path = branch.origin.place.source.path
            for name in names:
                for value in self.literals_in(name, path, expression):
                    yield name, value
        positive = branch.taken is (branch.attribute == "unless")
        for name in names:
            for value in self.booleans(name, positive):
                yield name, value

    def breaks_text(self, changes: Pairs) -> bool:
        """Whether a boolean went to an arg that turns out to be text in a file that only this configuration reaches."""
        return any(value in ("true", "false") and self.nature(name).text for name, value in changes)

    def _nature(self, name: str) -> Nature:
        places: dict[At, None] = {(self._launch.entry.path, name): None}
        waiting = list(places)
        boolean = truth = part = path_part = text = False
        literals: dict[str, None] = {}
        exact: dict[str, None] = {}
        while waiting and len(places) < MOST_PLACES:
            path, local = waiting.pop()
            uses = self._uses(path)
            compared = uses.literals.get(local, ())
            boolean = boolean or local in uses.booleans
            truth = truth or local in uses.truths or any(value.lower() in ("true", "false") for value in compared)
            part = part or local in uses.parts
            path_part = path_part or local in uses.paths
            text = text or local in uses.texts
            literals.update(dict.fromkeys(compared))
            exact.update(dict.fromkeys(uses.exact.get(local, ())))
            for place in self._next(path, local, uses):
                if place not in places:
                    places[place] = None
                    waiting.append(place)
        text = text or path_part or (part and not boolean)
        return Nature(boolean or truth, text, tuple(exact if part or path_part else literals), frozenset(places))

    def _next(self, path: str, name: str, uses: ArgUses) -> Iterator[At]:
        for other in uses.handed_on.get(name, ()):
            yield path, other
        for start, target, pass_all in self._calls.get(path, ()):
            given = uses.passed.get(start, ())
            yield from ((target, there) for here, there in given if here == name)
            if pass_all and (target, name) in self._declared and all(there != name for _, there in given):
                yield target, name
