"""The walk over the actions of a ROS 2 launch, in the order in which launch executes them: what all actions share.

What each action does is in ``setting_actions``, ``including``, ``processes``, ``nodes`` and ``components``; :mod:`.actions` names them all.
After a problem for which launch would stop, the walk goes on with an unknown value: what else is wrong is told, too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import ClassVar

from launchlint.evaluate.problems import ConditionNotBoolean, EvaluationBound, PackageNotFound
from launchlint.evaluate.ros2.comparing import note_truth
from launchlint.evaluate.ros2.context import Context, Setting, Value
from launchlint.evaluate.ros2.leaving import lost_in, tell_nobody
from launchlint.evaluate.ros2.listing import Lister, Listings
from launchlint.evaluate.ros2.performing import Failure, Performer, Rules
from launchlint.evaluate.ros2.problems import NodePackageMissing
from launchlint.evaluate.ros2.substitutions import PERFORM
from launchlint.evaluate.session import Read
from launchlint.evaluate.steering import steering
from launchlint.model import Branch, Condition, Declaration, Executable, Include, Node, Remap, Scope, Unknown, shown_text
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import IncludeStep, Origin, Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.judged_keys import Receiver
    from launchlint.evaluate.ros2.passing import Entered
    from launchlint.evaluate.ros2.repeating import Logs, Repeats, Said
    from launchlint.evaluate.session import Session
    from launchlint.syntax.ros2.reading import Reading
    from launchlint.syntax.ros2.unresolved import Unresolved

LARGEST_EVALUATION = 200_000
"""Actions executed in one configuration; more than any real launch has, few enough to end in seconds."""
CHARACTERS_PER_ACTION = 100
INHERITED_PER_ACTION = 50
"""How many configurations and variables that are taken over count as one more action."""
PASSED_PER_ACTION = 1
"""The same for remaps and params, which are put on command lines and read again."""
STARTING = 5
"""What it costs to start something or to enter a file, in further actions."""
DEEPEST_INCLUDE = 200
"""Includes inside includes: launch itself overflows Python's stack a little above this."""
MOST_DEFERRED = 500

UNSURE = "it is set under a condition that is not known"
_TRUE = ("true", "1")
_FALSE = ("false", "0")
_TAGS: dict[type, str] = {
    described.Argument: "arg",
    described.Let: "let",
    described.Include: "include",
    described.Group: "group",
    described.Executable: "executable",
    described.Node: "node",
    described.Component: "composable_node",
    described.LoadComponents: "load_composable_node",
    described.PushNamespace: "push_ros_namespace",
    described.SetRemap: "set_remap",
    described.SetParameter: "set_parameter",
    described.SetParametersFromFile: "set_parameters_from_file",
    described.SetUseSimTime: "set_use_sim_time",
    described.SetEnvironment: "set_env",
    described.UnsetEnvironment: "unset_env",
    described.AppendEnvironment: "append_env",
    described.ResetEnvironment: "reset_env",
    described.ReplaceEnvironment: "rep_env",
    described.Push: "push",
    described.Pop: "pop",
    described.Reset: "reset",
    described.SetLogDirectory: "set_ros_log_dir",
    described.Log: "log",
    described.Shutdown: "shutdown",
    described.Timer: "timer",
    described.Handler: "RegisterEventHandler",
    described.Transition: "LifecycleTransition",
    described.Opaque: "OpaqueFunction",
    described.Turn: "turn",
    described.Unset: "UnsetLaunchConfiguration",
    described.Maybe: "maybe",
    described.Open: "open",
    described.Unsettled: "unsettled",
    described.Fails: "fails",
}
_CONTAINERS = {"container": "node_container", "lifecycle": "lifecycle_node"}


class Told(Unknown):
    """A value that is not known because of a problem, which has been recorded."""

    __slots__ = ()


class Exhausted(Exception):
    """The evaluation is given up, since it would not end in reasonable time; holds the problem that says so."""


class Known(NamedTuple):
    """A value with what it depends on: see :class:`~launchlint.evaluate.ros2.context.Setting`."""

    value: Value
    steer: frozenset[str]
    outside: bool


class Weighed(NamedTuple):
    """A condition: by what it was judged, whether it holds (None: not known), the configuration that is compared, what it depends on."""

    value: Value | None
    taken: bool | None
    name: str | None
    steer: frozenset[str]
    outside: bool


class Absent(NamedTuple):
    """As :class:`Known`, of what a configuration is compared with where it is not to be set."""

    value: None
    steer: frozenset[str]
    outside: bool


_NOT_SET = Absent(None, frozenset(), False)


class Here(NamedTuple):
    """Where the walk is: the included ``file`` and the includes that lead to it, the group around, the conditions that were met on the way.

    ``told`` are the args whose absence has been told where the file was included, each with the place of its declaration. ``way`` are the
    includes once more, each by its identity, and ``sources`` what these load, by the identity of its name. ``idle``: what waits for a
    process that this launch does not start. ``around``: the args of the entry file on which it depends whether the walk comes here.
    """

    file: str
    step: IncludeStep | None
    files: tuple[str, ...]
    scope: Scope | None = None
    conditions: tuple[Condition, ...] = ()
    assumed: bool = False
    deferred: str | None = None
    told: frozenset[tuple[str, tuple[str, int]]] = frozenset()
    way: tuple[int, ...] = ()
    sources: tuple[int, ...] = ()
    idle: bool = False
    around: frozenset[str] = frozenset()


class Body(NamedTuple):
    """Actions to be executed later, from ``here``; ``directory``, ``launch_file``: what ``$(dirname)`` and ``$(filename)`` say then.

    ``configurations`` are those of the group around. ``target``: where the process is made without which they are never executed.
    """

    kind: str
    actions: tuple[Action, ...]
    here: Here
    directory: Value | None
    launch_file: Value | None
    configurations: Mapping[str, Setting]
    target: Place | None = None


class Walk:
    """One evaluation of an entry file in one configuration: the context, and what has come of it so far."""

    CONTEXT: ClassVar[type[Context]] = Context
    PERFORMER: ClassVar[type[Performer]] = Performer

    def __init__(
        self,
        session: Session,
        entry: str,
        rules: Rules,
        pinned: frozenset[str],
        handle: Callable[[Walk, Action], None],
        repeats: Repeats | None = None,
    ) -> None:
        self.repeats = repeats
        self.session = session
        self.entry = entry
        self.rules = rules
        self.pinned = pinned
        self.handle = handle
        self.context = self.CONTEXT(session)
        self.performer = self.PERFORMER(session, self.context, entry, rules, self.at, self.spend_characters, self.record, PERFORM)
        quiet = Performer(session, Context(session), entry, rules, Origin, self.spend_characters, tell_nobody, PERFORM)
        quiet.context.environment = self.context.environment
        self.lister = Lister(quiet, self.description_of, Listings() if repeats is None else repeats.listings)
        self.here = Here(entry, None, ())
        self.looked_at = 0
        self.problems: list[Problem] = []
        self.refused: Problem | None = None
        self.late: list[Problem] = []
        self.counted: tuple[int, ...] | None = None
        self.doubted: tuple[tuple[int, ...], Problem] | None = None
        self.nodes: list[Node] = []
        self.programs: list[Executable] = []
        self.includes: list[Include] = []
        self.declared: list[Declaration] = []
        self.branches: list[Branch] = []
        self.files: list[str] = []
        self.readings: list[Reading] = []
        self.executed: dict[tuple[int, ...], described.Description] = {}
        self.executions: list[tuple[tuple[int, ...], described.Description]] = []
        self.launch = object()
        self.unread: list[str] = []
        self.transitions: list[Place] = []
        self.set_remaps: list[tuple[Remap, tuple[Condition, ...]]] = []
        self.unsettled: list[str] = []
        self.unresolved: list[Unresolved] = []
        self.exhausted = False
        self.receivers: list[Receiver] = []
        self.entered: list[Entered] = []
        self.waiting: list[Body] = []
        self.said: Said = []
        self.started: dict[tuple[int, tuple[int, ...]], Action] = {}
        self.running: set[tuple[str, int]] = set()
        self.begun: list[tuple[str, int]] = []
        self.remembers = False
        self._recorded: set[tuple[object, ...]] = set()

    # -- files -------------------------------------------------------------------------------------------------

    def read(self, file: str) -> Reading | Read:
        """What is written in a launch file; the failed Read where it cannot be read."""
        return self.session.reading(file)

    def description_of(self, file: str) -> described.Description | None:
        """What a file describes, None where launch cannot load it."""
        known = self.session.reading(file)
        if isinstance(known, Read) or known.refusal is not None:
            return None
        self.load(known)
        return known.description

    def load(self, known: Reading) -> None:
        """What a program sets in the environment when it is loaded, before anything is executed: it stands in front, without a place."""
        for action in known.description.actions:
            if not isinstance(action, (described.SetEnvironment, described.UnsetEnvironment)) or action.place.span.end:
                return
            self.handle(self, action)

    def step_to(self, place: Place) -> IncludeStep:
        """The step from here to what an include at ``place`` includes."""
        step = self.here.step
        return IncludeStep(place, step) if self.repeats is None else self.repeats.step(place, step)

    # -- recording ---------------------------------------------------------------------------------------------

    def at(self, place: Place) -> Origin:
        """A place in the file that is executed, as where something comes from."""
        return Origin(place, self.here.step)

    @property
    def logs(self) -> Logs:
        """All that is collected in the order in which it comes, but problems: see ``said``."""
        return (
            self.nodes, self.programs, self.includes, self.declared, self.branches, self.files, self.readings, self.executions, self.unread,
            self.transitions, self.set_remaps, self.unsettled, self.unresolved, self.receivers, self.entered, self.begun,
            self.performer.compared, self.performer.containers, self.performer.foreign,
        )  # fmt: skip

    def record(self, problem: Problem, key: tuple[object, ...] | None = None) -> None:
        """Record ``problem``, unless one has been by the same ``key``; under a condition of unknown value it may never come to pass, so
        that it refuses nothing.
        """
        if self.here.assumed:
            problem = problem.but(assumed=True, refused=False)
        self.keep(problem, key)

    def keep(self, problem: Problem, key: tuple[object, ...] | None) -> None:
        """The same for a problem that has been recorded before, in another configuration."""
        self.said.append((key, problem))
        if key is not None:
            if key in self._recorded:
                return
            self._recorded.add(key)
        self.problems.append(problem)
        if not problem.refused:
            return
        if self.here.deferred is not None:
            self.late.append(problem)
            if not isinstance(problem, (NodePackageMissing, PackageNotFound)) or problem.lacks is None:
                self.counted = self.counted or self._count()
            elif self.counted is None:
                self.doubted = self.doubted or (self._count(), problem)
        elif self.refused is None:
            self.refused = problem

    def record_once(self, problem: Problem) -> None:
        """Record ``problem``, unless it has been for another node: what stands at one place kills them all for the same reason."""
        texts = (value for name, value in vars(problem).items() if isinstance(value, str) and name != "node")
        self.record(problem, (type(problem), problem.place.key, *texts))

    def has_told(self, argument: tuple[str, tuple[str, int]]) -> bool:
        """Whether the absence of an arg has been told where the file was included: its name, and the place of its declaration."""
        self.context.uses.told.add(argument)
        return argument in self.here.told

    def spend(self, actions: int, place: Place) -> None:
        """Count work at ``place`` that is worth that many actions. Raises Exhausted, at the bound of the whole evaluation."""
        self.looked_at += actions
        if self.looked_at > LARGEST_EVALUATION:
            raise Exhausted(EvaluationBound(origin=self.at(place), elements=LARGEST_EVALUATION))

    def has_left(self, actions: int) -> bool:
        """Whether so much work can be done before the bound."""
        return self.looked_at + actions <= LARGEST_EVALUATION

    def spend_characters(self, count: int, place: Place) -> None:
        """Count a text of ``count`` characters. Raises Exhausted."""
        if count >= CHARACTERS_PER_ACTION:
            self.spend(count // CHARACTERS_PER_ACTION, place)

    def spend_on_inherited(self, place: Place) -> None:
        """Count what a new scope or a node takes over from the context. Raises Exhausted."""
        context = self.context
        inherited = len(context.configurations) + len(context.environment.changes)
        passed = len(context.remaps or ()) + len(context.parameters or ())
        self.spend(inherited // INHERITED_PER_ACTION + passed // PASSED_PER_ACTION, place)

    # -- values ------------------------------------------------------------------------------------------------

    def value(self, text: Text) -> Value:
        """What a text stands for now; where launch stops at it, that is recorded, and the value is unknown."""
        literal = text.literal
        if literal is not None:
            return literal
        try:
            return self.performer.perform(text)
        except Failure as failure:
            self.record(failure.problem)
            return Told(text.written, "launch stops at it")

    def optional(self, text: Text | None) -> Value | None:
        """The same for what may be absent."""
        return None if text is None else self.value(text)

    def known(self, text: Text) -> Known:
        """The same, with what the value depends on."""
        return self._tracked(text, self.value)

    def performed(self, text: Text) -> Known:
        """The same; raises Failure where launch stops."""
        return self._tracked(text, self.performer.perform)

    def _tracked(self, text: Text, work: Callable[[Text], Value]) -> Known:
        literal = text.literal
        if literal is not None:
            return Known(literal, frozenset(), False)
        performer = self.performer
        before, outside = performer.steer, performer.outside
        performer.steer, performer.outside = set(), False
        try:
            value = work(text)
            return Known(value, steering((performer.steer,)), performer.outside)
        finally:
            before |= performer.steer
            performer.steer = before
            performer.outside |= outside

    # -- actions -----------------------------------------------------------------------------------------------

    def execute(self, actions: Iterable[Action]) -> None:
        """Execute actions one after the other, those of them whose condition holds (launch.Action.visit)."""
        for action in actions:
            self.spend(1, action.place)
            if action.condition is None:
                self.handle(self, action)
                continue
            met = self.judge(action.condition, tag_of(action), action.place)
            if met is None:
                continue
            outer = self.here
            around = outer.around | self.branches[-1].steered_by
            self.here = outer._replace(conditions=(*outer.conditions, met), assumed=outer.assumed or met.assumed, around=around)
            if met.assumed:
                self.doubtfully(partial(self.handle, self, action), UNSURE)
            else:
                self.handle(self, action)
            self.here = self.here._replace(conditions=outer.conditions, assumed=outer.assumed, around=outer.around)

    def doubtfully(self, work: Callable[[], None], reason: str) -> None:
        """Do what may not be done in a launch: what it sets is not known behind it."""
        before = self.context.moment()
        work()
        self.context.doubt(before, reason)

    def judge(self, condition: described.Condition, tag: str, element: Place) -> Condition | None:
        """The condition as one that was met, None where it does not hold. One of unknown value is taken to hold."""
        if condition.kind in ("if", "unless"):
            note_truth(self.performer, condition.operands[0])
        try:
            value, taken, name, steer, outside = self.weigh(condition)
        except Failure as failure:
            self.record(failure.problem)
            return None
        if isinstance(value, Told):
            return None
        text = condition.operands[-1].place.text
        steered = steer - self.pinned
        origin = self.at(condition.place)
        self.branches.append(Branch(origin, element, tag, condition.kind, text, taken, steered, outside or bool(steer), self.here.around))
        if taken is False:
            return None
        shown = "" if value is None else shown_text(value)
        return Condition(condition.kind, condition.place, taken is None, shown, name)

    def weigh(self, condition: described.Condition) -> Weighed:
        """Whether a condition holds now. Raises Failure where launch stops."""
        if condition.kind in ("equals", "not-equals"):
            return self._compare(condition)
        value, steer, outside = self.performed(condition.operands[0])
        if isinstance(value, Unknown):
            return Weighed(value, None, None, steer, outside)
        word = value.strip().lower()
        if word not in _TRUE and word not in _FALSE:
            written, reason = condition.operands[0].place.text, "it is none of true, 1, false and 0"
            origin = self.at(condition.place)
            raise Failure(
                ConditionNotBoolean(origin=origin, refused=True, attribute=condition.kind, value=value, text=written, reason=reason)
            )
        return Weighed(value, (word in _TRUE) is (condition.kind == "if"), None, steer, outside)

    def _compare(self, condition: described.Condition) -> Weighed:
        """A configuration with a value, or, without one, with not being set (launch.conditions.LaunchConfigurationEquals)."""
        name = condition.operands[0].literal or ""
        expected, steer, outside = self.performed(condition.operands[1]) if len(condition.operands) > 1 else _NOT_SET
        setting = self.context.get(name)
        if setting is None:
            unset, steer = not self.context.unread, steer | {name}
            found: Value | None = None if unset else Unknown(name, "an included file may set it")
        else:
            found, steer, outside = setting.value, steer | setting.steer, outside or setting.outside
        if isinstance(found, Unknown) or isinstance(expected, Unknown):
            return Weighed(found if isinstance(found, Unknown) else expected, None, name, steer, outside)
        return Weighed(expected, (found == expected) is (condition.kind == "equals"), name, steer, outside)

    def defer(self, kind: str, actions: tuple[Action, ...], target: Place | None = None) -> None:
        """Execute ``actions`` after everything else, with the context as it is then."""
        context = self.context
        self.waiting.append(Body(kind, actions, self.here, *context.place(), context.configurations, target))

    def finish(self) -> None:
        """Execute what was deferred, in the order in which it was."""
        late: list[Problem] = []
        for number, body in enumerate(self.waiting):  # grows on the way
            if number >= MOST_DEFERRED:
                break
            self.late, self.counted, self.doubted = [], None, None
            self.execute_later(body)
            late += self.late[:1]
            self._forget_late()
            self._doubt_late()
        self.late = late

    def execute_later(self, body: Body) -> None:
        """Execute what was deferred, once everything else has been."""
        idle = body.here.idle or (body.target is not None and body.target.key not in self.running)
        self.here = body.here._replace(deferred=body.kind, idle=idle)
        self.context.enter(body.directory, body.launch_file)
        self.performer.way = body.here.way
        for problem in lost_in(body.actions, body.configurations, self.context.configurations, body.kind, self.at):
            self.record(problem)
        self.execute(body.actions)

    def _count(self) -> tuple[int, ...]:
        """How much has come of the evaluation so far."""
        return len(self.nodes), len(self.programs), len(self.includes), len(self.declared), len(self.waiting)

    def _forget_late(self) -> None:
        """Take out what came of a body after launch had stopped: only what is wrong with it is told."""
        if self.counted is not None:
            nodes, programs, includes, declared, waiting = self.counted
            del self.nodes[nodes:], self.programs[programs:], self.includes[includes:], self.declared[declared:], self.waiting[waiting:]

    def _doubt_late(self) -> None:
        """What came of a body behind a package that is not here, and may be elsewhere, may be started: it is for certain no more."""
        if self.doubted is None:
            return
        (nodes, programs, includes, _, _), problem = self.doubted
        met = (Condition("maybe", problem.place, True, f"it needs {' '.join(problem.lacks or ())}, which is not here"),)
        self.nodes[nodes:] = [each._replace(conditions=each.conditions + met) for each in self.nodes[nodes:]]
        self.programs[programs:] = [each._replace(conditions=each.conditions + met) for each in self.programs[programs:]]
        self.includes[includes:] = [each._replace(conditions=each.conditions + met) for each in self.includes[includes:]]


def tag_of(action: Action | described.Component) -> str:
    """The name of the tag that makes an action."""
    if isinstance(action, described.Node):
        return _CONTAINERS.get(action.kind, "node")
    return _TAGS[type(action)]
