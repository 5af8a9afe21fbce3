"""A launch that runs, as the functions of a launch file see it: how they are called, what they ask its context, what they set in it."""

from __future__ import annotations

import ast

from launchlint.model import StandIn
from launchlint.model import Unknown as NotKnown
from launchlint.python.failures import Raised
from launchlint.python.memory import Ended, Exhausted, Log, taken_back
from launchlint.python.plain import NotPlain, value_of
from launchlint.python.reaching import reaches
from launchlint.python.values import MISSING, Handle, Instance, Map, Scope, Seq, Unknown, Value
from launchlint.source import Origin, Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action
from launchlint.syntax.ros2.live import Stopped
from launchlint.syntax.ros2.looping import Refused, TooMany, turns
from launchlint.syntax.ros2.python.conditions import condition_of
from launchlint.syntax.ros2.python.ending import actions_of
from launchlint.syntax.ros2.python.problems import StopsWithError
from launchlint.syntax.ros2.python.texts import Texts, is_own_substitution, is_substitution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from launchlint.problem import Problem
    from launchlint.syntax.ros2.live import LiveContext
    from launchlint.syntax.ros2.python.making import Maker
    from launchlint.syntax.ros2.python.noticing import Noticing

CONTEXT, CONFIGURATIONS, VARIABLES = "LaunchContext", "launch_configurations", "environment"
_BEFORE = "it is asked before the launch runs"


class Ending(Ended):
    """Launch stops the function: ``problem`` says why."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.kind)
        self.problem = problem


class Running:
    """What functions ask of the launch they are called by: ``live`` is its context, None where there is none yet.

    ``lacking`` is the first launch configuration that the function asked for and that is empty, or asked for with a default and not set.
    """

    def __init__(self, run: Noticing, texts: Texts, fresh: Callable[[], LiveContext | None]) -> None:
        self._run = run
        self._texts = texts
        self._fresh = fresh
        self.live: LiveContext | None = None
        self.lacking = ""

    def context(self, own: bool = False) -> Handle:
        """The context that a function is called with; ``own``: one that the program has made itself."""
        return Handle(CONTEXT, {"own": own, "live": self._fresh() if own else None})

    def _live(self, context: Value) -> LiveContext | None:
        if not isinstance(context, Handle) or context.kind not in (CONTEXT, CONFIGURATIONS, VARIABLES):
            return None
        live: LiveContext | None = context.state["live"] if context.state["own"] else self.live
        return live

    def performed(self, receiver: Value, context: Value, place: Place) -> Value:
        """``substitution.perform(context)``, the same of a list of them, or ``condition.evaluate(context)``. Raises Ending."""
        live = self._live(context)
        if live is None:
            return Unknown(_BEFORE, place)
        try:
            if not isinstance(receiver, Handle) or is_substitution(receiver):
                found = live.perform(self._texts.text(receiver, place))
                if found == "" and isinstance(receiver, Handle) and receiver.kind == "LaunchConfiguration":
                    self._lacks(receiver.state.get("variable_name"))
                return self.value(found, place)
            wanted = condition_of(receiver, self._texts, place)
            holds = None if wanted is None else live.holds(wanted)
        except Stopped as stopped:
            raise Ending(stopped.problem) from None
        return Unknown("whether a condition holds is not known", place) if holds is None else holds

    def _lacks(self, name: Value) -> None:
        if isinstance(name, str):
            self.lacking = self.lacking or name

    def value(self, found: str | NotKnown, place: Place | None) -> Value:
        """A value of the launch as one of the program."""
        if isinstance(found, str):
            return found
        return self._texts.stand_in(found) if isinstance(found, StandIn) else Unknown(found.reason, place)

    def member(self, receiver: Handle, name: str) -> Value:
        """``context.launch_configurations`` and ``context.environment``; MISSING for a method."""
        if receiver.kind != CONTEXT:
            return MISSING
        if name in (CONFIGURATIONS, VARIABLES):
            return Handle(name, dict(receiver.state))
        return Unknown(f"the {name} of the context are not known") if name == "locals" else MISSING

    def method(self, receiver: Handle, name: str, given: list[Value], place: Place) -> Value:
        """What is asked of the context, or of its configurations or variables. Raises Ending, Ended."""
        live = self._live(receiver)
        if receiver.kind == CONTEXT:
            if name == "perform_substitution" and len(given) == 1 and (is_substitution(given[0]) or is_own_substitution(given[0])):
                return self.performed(given[0], receiver, place)
            self._run.escape(given, "start")
            return Unknown(f"what {name}() of the context gives is not known", place)
        if live is None:
            return Unknown(_BEFORE, place)
        if name in ("get", "setdefault") and given:
            found = self.item(receiver, given[0], place)
            if found is not MISSING:
                return found
            if receiver.kind == CONFIGURATIONS:
                self._lacks(given[0])
            default = given[1] if len(given) > 1 else None
            if name == "setdefault":
                self.set_item(receiver, given[0], default)
            return default
        if name == "update" and len(given) == 1 and isinstance(given[0], Map):
            for key, value in given[0].entries.items():
                self.set_item(receiver, key, value)
            return None
        return self._all(live, name, place) if receiver.kind == CONFIGURATIONS else Unknown("which variables there are is not known", place)

    def _all(self, live: LiveContext, name: str, place: Place) -> Value:
        entries = live.configurations()
        if entries is None or name not in ("keys", "values", "items", "copy"):
            return Unknown("which launch configurations there are is not known", place)
        found = {key: self.value(value, place) for key, value in entries.items()}
        if name == "copy":
            return Map(dict(found))
        if name == "items":
            return Seq([Seq([key, value], is_tuple=True) for key, value in found.items()])
        return Seq(list(found) if name == "keys" else list(found.values()))

    def item(self, receiver: Handle, key: Value, place: Place | None = None) -> Value:
        """``context.launch_configurations[key]``; MISSING where it is not set."""
        live = self._live(receiver)
        if live is None or not isinstance(key, str):
            return Unknown(_BEFORE if live is None else "which one it is, is not known", place)
        found = live.configuration(key) if receiver.kind == CONFIGURATIONS else live.variable(key)
        if found == "" and receiver.kind == CONFIGURATIONS:
            self._lacks(key)
        if found is None and receiver.kind == VARIABLES:
            self._run.missing_variable = self._run.missing_variable or key
        return MISSING if found is None else self.value(found, place)

    def set_item(self, receiver: Handle, key: Value, value: Value) -> None:
        """``context.launch_configurations[key] = value``."""
        live = self._live(receiver)
        if live is None or not isinstance(key, str):
            return
        made = value if isinstance(value, str) else NotKnown(key, "what a function has set is not known")
        if receiver.kind == CONFIGURATIONS:
            live.configure(key, made)
        else:
            live.set_variable(key, made)


class Caller:
    """Calls functions of one launch file when launch does.

    What they change in the objects of the file stays changed for one launch, and is taken back when another one begins.
    """

    def __init__(self, run: Noticing, running: Running, scope: Scope, environment: Map) -> None:
        self._run = run
        self._environment = environment
        self._running = running
        self._scope = scope
        self._log: Log = {}
        self._launch: object = None
        self.maker: Maker | None = None

    def calls(self, function: Value, given: list[Value], keywords: dict[str, Value], place: Place) -> described.Call:
        """What launch calls for a function that it calls with what is ``given``: the context stands for itself in it."""

        def call(live: LiveContext) -> tuple[Action, ...]:
            return self._call(live, function, given, keywords, place)

        return call

    def loops(self, kind: str, over: Value, function: Value, place: Place) -> described.Call:
        """What launch calls for a ForLoop or ForEach, by its ``kind``: the function, once for each turn, before any action is executed."""

        def call(live: LiveContext) -> tuple[Action, ...]:
            found = self._asked(live, over, place)
            if not isinstance(found, str):
                return (described.Open(found.reason if isinstance(found, Unknown) else f"what {kind} goes through is not known", place),)
            lacking = self._running.lacking
            try:
                given = [{name: value_of(value) for name, value in each.items()} for each in turns(kind, found)]
            except Refused as refused:
                problem: Problem = StopsWithError(
                    origin=Origin(place), refused=True, error=refused.error, what=refused.what, stated=False, called=True, lacking=lacking,
                    action=kind,
                )  # fmt: skip
                return (described.Fails(problem, place),)
            except (TooMany, NotPlain):
                return (described.Open(f"{kind} goes through too much to be followed", place),)
            return tuple(action for each in given for action in self._call(live, function, [], each, place))

        return call

    def _asked(self, live: LiveContext, value: Value, place: Place) -> Value:
        """What is performed for an action itself. Raises Stopped."""
        outer, self._running.live = self._running.live, live
        self._running.lacking = ""
        try:
            return self._running.performed(value, self._running.context(), place)
        except Ending as ending:
            raise Stopped(ending.problem) from None
        finally:
            self._running.live = outer

    def _call(self, live: LiveContext, function: Value, given: list[Value], keywords: dict[str, Value], place: Place) -> tuple[Action, ...]:
        run, outer = self._run, self._running.live
        self._begin(live)
        self._running.live = live
        self._running.lacking = ""
        run.begin()
        context = self._running.context()
        positional = [context if isinstance(each, Handle) and each.kind == "context" else each for each in given]
        assert self.maker is not None
        before, risks, asked = len(run.problems), run.risks, len(run.asking)
        try:
            made = run.call(function, positional, dict(keywords), ast.Pass(lineno=1, col_offset=0), self._scope)
            if isinstance(made, Seq):
                run.force(made)
            actions = self.maker.actions(made, place)
            risky = (
                (described.Unsettled("what a function asks of code that is not looked into may fail", place),) if run.risks > risks else ()
            )
            return (*run.asked(asked), *(described.Fails(problem, problem.place) for problem in run.noticed(before)), *risky, *actions)
        except Ending as ending:
            raise Stopped(ending.problem) from None
        except Ended as ended:
            found = [described.Fails(problem, problem.place) for problem in run.noticed(before) if problem.refused]
            if found:
                return (*run.asked(asked), *found)
            lacking = self._running.lacking
            stops = actions_of(ended, run, place, called=True, lacking=lacking) if isinstance(ended, Raised) else ()
            return (
                *run.asked(asked),
                *stops,
                described.Open(f"the function ends with an error{f': {ended}' if str(ended) else ''}", place),
            )
        except (Exhausted, RecursionError):
            return (described.Open("the function is too much to be followed", place),)
        finally:
            self._running.live = outer
            self._remember(live, [function, given, keywords])
            live.spend(run.steps)

    def gives(self, value: Instance, place: Place) -> described.Gives:
        """What performs a substitution of the program's own: its method ``perform`` is called with the context."""

        def give(live: LiveContext) -> str | NotKnown:
            return self._given(live, value, place)

        return give

    def _given(self, live: LiveContext, value: Instance, place: Place) -> str | NotKnown:
        run, outer = self._run, self._running.live
        self._begin(live)
        self._running.live = live
        node = ast.Pass(lineno=1, col_offset=0)
        before, steps, asked = run.risks, run.steps, len(run.asking)
        assert self.maker is not None
        try:
            made = run.call(run.attribute(value, "perform", node, self._scope), [self._running.context()], {}, node, self._scope)
            if run.risks > before or run.asked(asked):
                live.unsettle()
            return live.perform(self.maker.texts.text(made, place))
        except Ending as ending:
            raise Stopped(ending.problem) from None
        except (Ended, Exhausted, RecursionError) as ended:
            live.unsettle()
            return NotKnown(place.text, f"it ends with an error{f': {ended}' if str(ended) else ''}")
        finally:
            self._running.live = outer
            self._remember(live, [value])
            live.spend(max(run.steps - steps, 0))

    def _remember(self, live: LiveContext, roots: list[Value]) -> None:
        """Tell ``live`` where something that was written in this launch can still be read: from what was called, or from a module."""
        written = {id(mapping) for mapping, _, _ in self._log.values()}
        if reaches([*roots, self._scope, self._environment, *self._run.modules.values()], written):
            live.remember()

    def _begin(self, live: LiveContext) -> None:
        if self._launch is live.launch:
            return
        self._launch = live.launch
        if not self._run.keeps(self._log):
            self._run.keep(self._log)
        taken_back(self._log)
        self._log.clear()
