"""The proof that an edit changes nothing roslaunch would do: both texts are evaluated in every configuration, and must mean the same.

What no configuration shows (an element under a condition that is never met, a node whose name cannot be known) must stay as it is
written, and where it stands among what acts on it.

Edits of many files are proved together, each entry file that shows them once; only where one shows a difference, it is asked which edit
makes it. What an entry file does as things are is worked out once, until a file changes that it reads.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from collections.abc import Set as AbstractSet
from itertools import islice

from launchlint.dialects.door import configurations, dialect_of, evaluate
from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.session import Read, Session
from launchlint.fix.hidden import Hidden, Shown
from launchlint.fix.meaning import Meaning, difference, meaning
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    Pairs = tuple[tuple[str, str], ...]

MOST_CALLERS = 20
"""Entry files that include a file and with which an edit of it is proved again; the first of them, as given."""

_NOT_OF_THE_FILE = frozenset({"ROS_NAMESPACE", "ROS_DISTRO"})
"""Environment variables that roslaunch reads by itself."""
_MADE_UP = ("value_of_{}", "1")
"""What required args and unset variables are given: once a value of its own for each, so that no two are taken for one another, and once
one that is also a number and a boolean."""


class Caller(NamedTuple):
    """An entry file and the ``name:=value`` pairs it is started with."""

    file: str
    arguments: Pairs = ()


class _Done(NamedTuple):
    """One evaluation of an entry file: the args it was given, what it does, and what it shows of its own text."""

    given: Pairs
    meaning: Meaning
    shown: Shown


class _Seen:
    """What one entry file does with files as they are: in its configurations, in others it was asked for, and with what is made up.

    ``touched`` are all files that were looked at, ``variables`` those of the environment, ``required`` the args it cannot be started
    without; ``size`` is how many characters its launch files have.
    """

    def __init__(self) -> None:
        self.configurations: dict[Pairs, _Done] = {}
        self.others: dict[tuple[Pairs, object], _Done] = {}
        self.touched: set[str] = set()
        self.variables: set[str] = set()
        self.required: tuple[str, ...] = ()
        self.size = 0


class _Answer(NamedTuple):
    """Why an entry file does something else (or empty: it does not) where, of the files that it ``reached``, these hold ``texts``."""

    reached: AbstractSet[str]
    texts: Mapping[str, bytes]
    reason: str


class _World:
    """A session, and the same with values for variables of the environment that are not set: blocks are shared by all who need the same."""

    def __init__(self, session: Session, before: _World | None = None, texts: Mapping[str, bytes] | None = None) -> None:
        self.session = session
        self._before = before
        self._texts = texts or {}
        self._made_up: dict[tuple[str, frozenset[str]], Session] = {}

    def holding(self, texts: Mapping[str, bytes]) -> _World:
        """Where files hold ``texts``."""
        return _World(self.session.with_texts(texts), self, texts)

    def alone(self) -> _World:
        """The same without what it was made from, which would be kept with it."""
        world = _World(self.session)
        world._made_up = self._made_up
        return world

    def with_variables(self, value: str, unset: frozenset[str]) -> Session:
        """The session in which each of the ``unset`` variables is ``value`` with its name."""
        if not unset:
            return self.session
        key = (value, unset)
        if key not in self._made_up:
            if self._before is not None:
                self._made_up[key] = self._before.with_variables(value, unset).with_texts(self._texts)
            else:
                session = self.session.with_texts({})
                session.environment = {**session.environment, **{name: value.format(name) for name in sorted(unset)}}
                session.blocks = {}
                self._made_up[key] = session
        return self._made_up[key]


class Guard:
    """Proves edits in one ``session``. ``callers`` gives, for a file, entry files that include it, or itself with the args it is started
    with: a file that lacks args shows all of what it does only through them. ``read``: characters of launch files that entry files were
    evaluated with until now.
    """

    def __init__(self, session: Session, callers: Callable[[str], Iterable[Caller]] | None = None) -> None:
        self._callers = callers
        self._world = _World(session.with_texts({}))
        self._seen: dict[Caller, _Seen] = {}
        self._answers: dict[Caller, list[_Answer]] = {}
        self.read = 0

    def holding(self, texts: Mapping[str, bytes], callers: Callable[[str], Iterable[Caller]]) -> Guard:
        """A guard for where files hold ``texts``, which knows what this one knows of entry files that do not look at these."""
        changed = {os.path.abspath(file) for file in texts}
        guard = Guard(self._world.session, callers)
        guard._world = self._world.holding(texts).alone()
        guard._seen = {caller: seen for caller, seen in self._seen.items() if seen.touched.isdisjoint(changed)}
        for caller, answers in self._answers.items():
            guard._answers[caller] = [each for each in answers if changed.isdisjoint(each.reached)]
        guard.read = self.read
        return guard

    def refusal(self, file: str, before: bytes, after: bytes) -> str:
        """Why the edit of ``file`` from ``before`` to ``after`` must not be made, in one sentence without a full stop.

        Empty where both mean the same in every configuration of either of them. Also where roslaunch refuses the file, everything that is
        known of it must stay.
        """
        if before == after:
            return ""
        return Guard(self._world.session.with_text(file, before), self._callers).refusals({file: after}).get(file, "")

    def refusals(self, texts: Mapping[str, bytes]) -> dict[str, str]:
        """Of the edits that make ``texts`` of files, those that must not be made, by file, each with the reason as in :meth:`refusal`.

        What is left may be made, all of it together. Where edits change something only together, the first of them is not refused.
        """
        refused: dict[str, str] = {}
        names = {os.path.abspath(file): file for file in texts}
        left = {name: texts[file] for name, file in names.items() if self._world.session.read(file).data != texts[file]}
        after = self._world.holding(left)
        told = {file: self._told(after.session, file) for file in left}
        for file, why in told.items():
            if why is not None:
                del left[file]
                if why:
                    refused[file] = why
        while left:
            found = self._found(left)
            if not found:
                break
            refused.update(found)
            left = {file: text for file, text in left.items() if file not in found}
        return {file: refused[name] for name, file in names.items() if name in refused}

    def _told(self, after: Session, file: str) -> str | None:
        """What can be said of an edit without evaluating anything: the reason why not, or that it may be made; else None."""
        before = self._world.session
        told = dialect_of(before, file).difference
        if told is not None:
            return told(before, after, file)
        for session, which in ((before, "the file"), (after, "the result")):
            document = session.document(file)
            if isinstance(document, Read) or document.launch is None:
                return f"{which} is no launch file that roslaunch can read"
        return None

    def _found(self, texts: Mapping[str, bytes]) -> dict[str, str]:
        """Some of the edits that must not be made, each with the reason; nothing where all may be, together."""
        world = self._world.holding(texts)
        found: dict[str, str] = {}
        # First what each file shows by itself, and of these those that reach the fewest of the others: it is plain whose edit it is.
        alone = [Caller(file) for file in texts]
        reached = {caller: len(_reached(texts, self._seen_of(caller).touched)) for caller in alone}
        for callers in (sorted(alone, key=reached.__getitem__), self._including(texts)):
            for caller in callers:
                answer = self._answer(caller, world, texts)
                if answer.reason and found.keys().isdisjoint(answer.texts):
                    found.update(self._blamed(caller, answer) or dict.fromkeys(texts, answer.reason))
            if found:
                break
        return found

    def _including(self, texts: Mapping[str, bytes]) -> Iterable[Caller]:
        callers: dict[Caller, None] = {}
        for file in texts if self._callers is not None else ():
            assert self._callers is not None
            others = (caller for caller in self._callers(file) if caller != Caller(file))
            callers.update(dict.fromkeys(islice(others, MOST_CALLERS)))
        return (caller for caller in callers if caller.arguments or caller.file not in texts)

    def _blamed(self, caller: Caller, answer: _Answer) -> dict[str, str]:
        """Which of the edits that an entry file shows make it do something else, each beside those before it that do not."""
        if len(answer.texts) == 1:
            return dict.fromkeys(answer.texts, answer.reason)
        blamed: dict[str, str] = {}
        kept: dict[str, bytes] = {}
        for file, text in answer.texts.items():
            tried = {**kept, file: text}
            reason = self._answer(caller, self._world.holding(tried), tried).reason
            if reason:
                blamed[file] = reason
            else:
                kept = tried
        return blamed

    def _answer(self, caller: Caller, after: _World, texts: Mapping[str, bytes]) -> _Answer:
        """What ``caller`` says of ``texts``, which files hold ``after`` the edits."""
        answers = self._answers.setdefault(caller, [])
        for each in answers:
            if _reached(texts, each.reached) == each.texts:
                return each
        comparison = _Comparison(self, caller, after, texts)
        reason = comparison.refusal()
        answer = _Answer(frozenset(comparison.touched), _reached(texts, comparison.touched), reason)
        answers.append(answer)
        return answer

    # -- what entry files do as things are -------------------------------------------------------------------------

    def _seen_of(self, caller: Caller) -> _Seen:
        if caller not in self._seen:
            seen = _Seen()
            session = self._world.session
            session.begin_entry()
            evaluations = list(configurations(session, *caller))
            seen.configurations = {each.launch.given: _done(each) for each in evaluations}
            seen.touched |= session.touched
            seen.variables |= session.variables
            seen.required = _required(evaluations[0])
            seen.size = _size(evaluations)
            self.read += seen.size
            self._seen[caller] = seen
        return self._seen[caller]

    def _done_before(self, caller: Caller, pairs: Pairs, value: str = "", unset: frozenset[str] = frozenset()) -> _Done:
        """What ``caller`` does with other args, and with made-up variables."""
        seen = self._seen_of(caller)
        if not unset and pairs in seen.configurations:
            return seen.configurations[pairs]
        key = (pairs, (value, unset) if unset else None)
        if key not in seen.others:
            session = self._world.with_variables(value, unset)
            session.begin_entry()
            seen.others[key] = _done(evaluate(session, caller.file, pairs))
            seen.touched |= session.touched
            if not unset:
                seen.variables |= session.variables
        return seen.others[key]


class _Comparison:
    """One entry file before and after edits. ``touched``: the files that it looked at in either."""

    def __init__(self, guard: Guard, caller: Caller, after: _World, texts: Mapping[str, bytes]) -> None:
        self.guard = guard
        self.caller = caller
        self.after = after
        self.texts = texts
        self.touched: set[str] = set()

    def refusal(self) -> str:
        """As :meth:`Guard.refusal`."""
        seen = self.guard._seen_of(self.caller)
        reason = self._reason(seen)
        self.touched |= seen.touched
        return reason

    def _reason(self, seen: _Seen) -> str:
        entry, given = self.caller
        session = self.after.session
        session.begin_entry()
        evaluations = list(configurations(session, entry, given))
        new = {each.launch.given: _done(each) for each in evaluations}
        self.guard.read += _size(evaluations)
        required = dict.fromkeys((*seen.required,))
        hidden, hidden_after = (Hidden(each.document(entry)) for each in (self.guard._world.session, session))
        try:
            for pairs in dict.fromkeys((*seen.configurations, *new)):
                before = self.guard._done_before(self.caller, pairs)
                after = new.get(pairs) or _done(evaluate(session, entry, pairs))
                hidden.see(before.shown)
                hidden_after.see(after.shown)
                found = self._difference(before, after)
                if found:
                    return found
        finally:
            self.touched |= session.touched
        unset = frozenset((seen.variables | session.variables) - session.environment.keys() - _NOT_OF_THE_FILE)
        for value in _MADE_UP if required or unset else ():
            pairs = (*given, *((name, value.format(name)) for name in required))
            made_up = self.after.with_variables(value, unset)
            made_up.begin_entry()
            before, after = self.guard._done_before(self.caller, pairs, value, unset), _done(evaluate(made_up, entry, pairs))
            self.touched |= made_up.touched
            found = self._difference(before, after)
            if found:
                return found
            hidden.see(before.shown)
            hidden_after.see(after.shown)
        return hidden.difference(hidden_after) if not given and entry in self.texts else ""

    def _difference(self, before: _Done, after: _Done) -> str:
        found = difference(before.meaning, after.meaning)
        if not found:
            return ""
        words = [] if self.caller.file in self.texts else [self.after.session.shown(self.caller.file)]
        words += [f"{name}:={value}" for name, value in before.given]
        return f"{found} (with {' '.join(words)})" if words else found


def _done(evaluation: Evaluation) -> _Done:
    launch = evaluation.launch
    return _Done(launch.given, meaning(launch), Shown.of(evaluation))


def _required(first: Evaluation) -> tuple[str, ...]:
    """The args that an entry file cannot be started without, of those that nobody gives it."""
    launch = first.launch
    return tuple(
        dict.fromkeys(
            each.name
            for each in launch.declared
            if each.origin.step is None and not each.passed and each.value is each.default is None and each.name not in launch.arguments
        )
    )


def _size(evaluations: Iterable[Evaluation]) -> int:
    """How many characters the launch files have that evaluations of one entry file reach, each counted once."""
    documents = {path: document for each in evaluations for path, document in each.documents.items()}
    return sum(len(document.source.text) for document in documents.values())


def _reached(texts: Mapping[str, bytes], touched: AbstractSet[str]) -> dict[str, bytes]:
    return {file: text for file, text in texts.items() if file in touched}
