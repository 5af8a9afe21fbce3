"""The proof that an edit changes nothing: both texts are evaluated in every configuration, and must mean the same.

What no configuration shows (an element under a condition that is never met, a node whose name cannot be known) must stay as it is
written, and where it stands among what acts on it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import islice

from launchlint.dialects.door import configurations, dialect_of, evaluate
from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.session import Read, Session
from launchlint.fix.hidden import Hidden
from launchlint.fix.meaning import difference, meaning
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    Pairs = tuple[tuple[str, str], ...]

MOST_CALLERS = 20
"""Entry files that include a file and with which an edit of it is proved again; the first of them, as given."""

_NOT_OF_THE_FILE = frozenset({"ROS_NAMESPACE", "ROS_DISTRO"})
"""Environment variables that roslaunch reads by itself."""


class Caller(NamedTuple):
    """An entry file and the ``name:=value`` pairs it is started with."""

    file: str
    arguments: Pairs = ()


class Guard:
    """Proves edits in one ``session``. ``callers`` gives, for a file, entry files that include it, or itself with the args it is started
    with: a file that lacks args shows all of what it does only through them.
    """

    def __init__(self, session: Session, callers: Callable[[str], Iterable[Caller]] | None = None) -> None:
        self._session = session
        self._callers = callers

    def refusal(self, file: str, before: bytes, after: bytes) -> str:
        """Why the edit of ``file`` from ``before`` to ``after`` must not be made, in one sentence without a full stop.

        Empty where both mean the same in every configuration of either of them. Also where roslaunch refuses the file, everything that is
        known of it must stay.
        """
        if before == after:
            return ""
        first = self._session.with_text(file, before)
        second = first.with_text(file, after)
        told = dialect_of(first, file).difference
        if told is not None:
            return told(first, second, file)
        for session, which in ((first, "the file"), (second, "the result")):
            document = session.document(file)
            if isinstance(document, Read) or document.launch is None:
                return f"{which} is no launch file that roslaunch can read"
        alone = Caller(file)
        callers = [alone]
        if self._callers is not None:
            callers += islice((caller for caller in self._callers(file) if caller != alone), MOST_CALLERS)
        for caller in callers:
            found = _Comparison(first, second, file, caller).refusal()
            if found:
                return found
        return ""


class _Comparison:
    """One entry file before and after the edit of ``file``."""

    def __init__(self, before: Session, after: Session, file: str, caller: Caller) -> None:
        self.before = before
        self.after = after
        self.file = file
        self.caller = caller

    def refusal(self) -> str:
        """As :meth:`Guard.refusal`."""
        entry, given = self.caller
        old = {each.launch.given: each for each in configurations(self.before, entry, given)}
        new = {each.launch.given: each for each in configurations(self.after, entry, given)}
        hidden, hidden_after = (Hidden(session.document(self.file)) for session in (self.before, self.after))
        for pairs in dict.fromkeys((*old, *new)):
            evaluation = old.get(pairs) or evaluate(self.before, entry, pairs)
            evaluation_after = new.get(pairs) or evaluate(self.after, entry, pairs)
            hidden.see(evaluation)
            hidden_after.see(evaluation_after)
            found = self._difference(evaluation, evaluation_after)
            if found:
                return found
        for before, after, pairs in self._made_up(next(iter(old.values()))):
            evaluation, evaluation_after = evaluate(before, entry, pairs), evaluate(after, entry, pairs)
            found = self._difference(evaluation, evaluation_after)
            if found:
                return found
            hidden.see(evaluation)
            hidden_after.see(evaluation_after)
        return hidden.difference(hidden_after) if self.caller == Caller(self.file) else ""

    def _difference(self, before: Evaluation, after: Evaluation) -> str:
        found = difference(meaning(before.launch), meaning(after.launch))
        if not found:
            return ""
        words = [] if self.caller.file == self.file else [before.launch.entry.path]
        words += [f"{name}:={value}" for name, value in before.launch.given]
        return f"{found} (with {' '.join(words)})" if words else found

    def _made_up(self, first: Evaluation) -> Iterator[tuple[Session, Session, Pairs]]:
        """Required args and unset environment variables with a value each, so that names made from them are known.

        Once with a value of its own for each, so that no two are taken for one another, and once with one that is also a number and a
        boolean.
        """
        launch = first.launch
        required = dict.fromkeys(
            each.name
            for each in launch.declared
            if each.origin.step is None and not each.passed and each.value is each.default is None and each.name not in launch.arguments
        )
        unset = (self.before.variables | self.after.variables) - self.before.environment.keys() - _NOT_OF_THE_FILE
        if not required and not unset:
            return
        for value in ("value_of_{}", "1"):
            given = (*self.caller.arguments, *((name, value.format(name)) for name in required))
            variables = {name: value.format(name) for name in sorted(unset)}
            yield self._in(self.before, variables), self._in(self.after, variables), given

    def _in(self, session: Session, variables: dict[str, str]) -> Session:
        if not variables:
            return session
        data = session.read(self.file).data
        assert data is not None
        copy = session.with_text(self.file, data)
        copy.environment = {**session.environment, **variables}
        copy.blocks = {}
        return copy
