"""What lies outside of a program of ROS: rospy and the packages around it, and what makes no names."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.extract.python import messages, models
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.canonical import canonical, message_class
from launchlint.extract.python.foreign import is_silent
from launchlint.extract.python.modules import GENERATED
from launchlint.extract.python.outside import NODE
from launchlint.extract.python.recognised import HANDLERS, MAKING, METHODS
from launchlint.python import builtins, standard
from launchlint.python.values import MISSING, UNKNOWN, External, Handle, Instance, Scope, Seq, Text, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast

    from launchlint.extract.python.following import Following

_NEVER_FOLLOWED = frozenset(
    """rospy roslib rosgraph actionlib tf tf2_ros tf2_py message_filters dynamic_reconfigure smach smach_ros diagnostic_updater rosunit
    rostest
    genpy genmsg rospkg catkin interactive_markers cv_bridge rosparam rosbag""".split()
)
_TALKING = ("rospy", "actionlib", "tf2_ros", "message_filters")
_MODULES = ("rospy",)
TYPES = {f"{name}{ending}": name for name in ("bool", "int", "double", "str") for ending in ("", "_t")}
"""How ``.cfg`` files call the types of params → what they are."""


class RosRecogniser:
    """Recognises for one run (a :class:`~launchlint.python.recogniser.Recogniser`)."""

    def __init__(self, run: Following) -> None:
        self._run = run

    def call(self, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Something outside is called."""
        run = self._run
        name = canonical(name)
        made = Call(run, name, positional, keywords, node, scope)
        if name.endswith(".__init__") and positional and isinstance(positional[0], Instance):
            self.inherited(name[: -len(".__init__")], positional[0], positional[1:], keywords, node, scope)
            return None
        handler = HANDLERS.get(name)
        if handler is not None:
            return handler(made)
        if name.startswith("os.path."):
            return _path_function(name[len("os.path.") :], positional)
        if message_class(External(name)):
            return UNKNOWN
        when = "message" if name.startswith("rospy.") and name != "rospy.Timer" else "start"
        run.escape([*positional, *keywords.values()], when)
        model = models.model_of(name)
        if model is not None:
            models.follow(model, made)
        elif not self.is_silent(name):
            made.doubt(f"it uses {name.partition('.')[0]}, whose source was not given")
        return UNKNOWN

    def attribute(self, name: str, member: str) -> Value:
        """``name.member`` of a module that is not followed."""
        if member in ("_type", "_md5sum", "__name__"):
            type_ = message_class(External(name))
            if type_:
                return {"_type": type_, "__name__": type_.partition("/")[2]}.get(member, UNKNOWN)
        return standard.attribute(name, member)

    def member(self, receiver: Handle, name: str) -> Value:
        """All that is not set is a method."""
        return MISSING

    def method(
        self, receiver: Handle, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """Call a method of what a recognised call made."""
        handler = METHODS.get((receiver.kind, name))
        if handler is not None:
            return handler(receiver, Call(self._run, name, positional, keywords, node, scope))
        self._run.escape([*positional, *keywords.values()], "message" if receiver.kind != "plain" else "start")
        return UNKNOWN

    def inherited(
        self, base: str, instance: Instance, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> None:
        """The constructor of a base class that is not followed."""
        base = canonical(base)
        if base in ("builtins.object", "object"):
            return
        run = self._run
        handler = HANDLERS.get(base)
        if handler is not None:
            handler(Call(run, base, positional, keywords, node, scope))
            run.escape([*positional, *keywords.values()], "message")
            return
        run.escape([*positional, *keywords.values()], "start")
        model = models.model_of(base)
        if model is not None:
            models.follow(model, Call(run, base, positional, keywords, node, scope))

    def inherited_method(
        self, name: str, instance: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """A method that a followed class has from one that is not followed."""
        self._run.escape([*positional, *keywords.values()], "message")
        return UNKNOWN

    def text_method(self, spelled: str, name: str, positional: Sequence[Value]) -> Value:
        """The last part of the node's own name."""
        if spelled == NODE and name in ("split", "rsplit") and positional and positional[0] == "/":
            return Seq([UNKNOWN, Text("{node}")])
        return MISSING

    def stays_outside(self, name: str) -> bool:
        """The ROS packages that are recognised."""
        top = name.partition(".")[0]
        if top in _TALKING:
            self._run.uses_rospy = True
        return top in _NEVER_FOLLOWED

    def is_generated(self, name: str) -> bool:
        """What catkin makes of messages, services and configurations."""
        return name.rpartition(".")[2] in GENERATED

    def is_harmless(self, spelled: str) -> bool:
        """Messages make no names, whatever package they are of."""
        return spelled.endswith((".msg", ".srv", ".action", ".cfg"))

    def from_stars(self, name: str, stars: list[str]) -> Value:
        """What is recognised, a message, or something of which nothing is known."""
        for star in stars:
            full = canonical(f"{star}.{name}")
            if full in HANDLERS:
                return External(full)
        if name in TYPES and any("parameter_generator" in star for star in stars):
            return External(f"dynamic_reconfigure.parameter_generator.{name}")
        found = messages.origin(name, stars) or next((star for star in stars if not self.is_silent(star)), "")
        return External(f"{found}.{name}") if found else UNKNOWN

    def is_silent(self, name: str) -> bool:
        """Whether a module, or what is in it, is known to make no names that are not recognised."""
        return is_silent(name, self._run.libraries())

    def is_open(self, name: str) -> bool:
        """Whether nothing is known of what something outside makes."""
        name = canonical(name)
        return name not in HANDLERS and models.model_of(name) is None and not self.is_silent(name)

    def matters(self, name: str) -> bool:
        """Whether something outside makes or asks for names when it is called, or is a module in which there is such a thing."""
        name = canonical(name)
        return (name in HANDLERS and name.rpartition(".")[2] in MAKING) or name in _MODULES

    def mattering(self, name: str) -> list[str]:
        """What in the module or class ``name`` makes or asks for names."""
        start = canonical(name) + "."
        return [each[len(start) :] for each in HANDLERS if each.startswith(start) and self.matters(each)]


def _path_function(name: str, positional: list[Value]) -> Value:
    if name == "basename" and positional and isinstance(positional[0], Text) and positional[0].template == NODE:
        return Text("{node}")
    return builtins.path_function(name, positional)
