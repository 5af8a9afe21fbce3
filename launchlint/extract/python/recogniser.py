"""What lies outside of a program of ROS: the client library and the packages around it, and what makes no names."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.extract.python import messages, models
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.foreign import is_silent
from launchlint.extract.python.modules import GENERATED
from launchlint.extract.python.outside import NODE
from launchlint.python import builtins, standard
from launchlint.python.values import MISSING, UNKNOWN, External, Handle, Instance, Scope, Seq, Text, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast

    from launchlint.extract.python.following import Following

TYPES = {f"{name}{ending}": name for name in ("bool", "int", "double", "str") for ending in ("", "_t")}
"""How ``.cfg`` files call the types of params → what they are."""


class RosRecogniser:
    """Recognises for one run (a :class:`~launchlint.python.recogniser.Recogniser`)."""

    def __init__(self, run: Following) -> None:
        self._run = run
        self._dialect = run.dialect

    def call(self, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Something outside is called."""
        run = self._run
        name = self._dialect.canonical(name)
        made = Call(run, name, positional, keywords, node, scope)
        if name.endswith(".__init__") and positional and isinstance(positional[0], Instance):
            self.inherited(name[: -len(".__init__")], positional[0], positional[1:], keywords, node, scope)
            return None
        handler = self._dialect.handlers.get(name)
        if handler is not None:
            return handler(made)
        if name.startswith("os.path."):
            return _path_function(name[len("os.path.") :], positional)
        if self._dialect.type_of(External(name)):
            return UNKNOWN
        when = "message" if name.startswith(self._dialect.calls_back) else "start"
        run.escape([*positional, *keywords.values()], when)
        model = self._dialect.model_of(name)
        if model is not None:
            models.follow(model, made)
        elif not self.is_silent(name):
            made.doubt(f"it uses {name.partition('.')[0]}, whose source was not given")
        return UNKNOWN

    def attribute(self, name: str, member: str) -> Value:
        """``name.member`` of a module that is not followed."""
        if member in ("_type", "_md5sum", "__name__"):
            type_ = self._dialect.type_of(External(name))
            if type_:
                return {"_type": type_, "__name__": type_.rpartition("/")[2]}.get(member, UNKNOWN)
        return standard.attribute(name, member)

    def member(self, receiver: Handle, name: str) -> Value:
        """All that is not set is a method."""
        return MISSING

    def method(
        self, receiver: Handle, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """Call a method of what a recognised call made."""
        handler = self._dialect.methods.get((receiver.kind, name))
        if handler is not None:
            return handler(receiver, Call(self._run, name, positional, keywords, node, scope))
        self._run.escape([*positional, *keywords.values()], "message" if receiver.kind != "plain" else "start")
        return UNKNOWN

    def inherited(
        self, base: str, instance: Instance, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> None:
        """The constructor of a base class that is not followed."""
        base = self._dialect.canonical(base)
        if base in ("builtins.object", "object"):
            return
        run = self._run
        handler = self._dialect.handlers.get(base)
        if handler is not None:
            handler(Call(run, base, positional, keywords, node, scope))
            run.escape([*positional, *keywords.values()], "message")
            return
        run.escape([*positional, *keywords.values()], "start")
        model = self._dialect.model_of(base)
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
        if top in self._dialect.talking:
            self._run.uses_ros = True
        return top in self._dialect.never_followed

    def is_generated(self, name: str) -> bool:
        """What catkin makes of messages, services and configurations."""
        return name.rpartition(".")[2] in GENERATED

    def is_harmless(self, spelled: str) -> bool:
        """Messages make no names, whatever package they are of."""
        return spelled.endswith((".msg", ".srv", ".action", ".cfg"))

    def from_stars(self, name: str, stars: list[str]) -> Value:
        """What is recognised, a message, or something of which nothing is known."""
        for star in stars:
            full = self._dialect.canonical(f"{star}.{name}")
            if full in self._dialect.handlers:
                return External(full)
        if name in TYPES and any("parameter_generator" in star for star in stars):
            return External(f"dynamic_reconfigure.parameter_generator.{name}")
        found = messages.origin(name, stars) or next((star for star in stars if not self.is_silent(star)), "")
        return External(f"{found}.{name}") if found else UNKNOWN

    def is_silent(self, name: str) -> bool:
        """Whether a module, or what is in it, is known to make no names that are not recognised."""
        return is_silent(name, self._run.libraries(), self._dialect.silent)

    def is_open(self, name: str) -> bool:
        """Whether nothing is known of what something outside makes."""
        name = self._dialect.canonical(name)
        return name not in self._dialect.handlers and self._dialect.model_of(name) is None and not self.is_silent(name)

    def matters(self, name: str) -> bool:
        """Whether something outside makes or asks for names when it is called, or is a module in which there is such a thing."""
        name = self._dialect.canonical(name)
        return (name in self._dialect.handlers and name.rpartition(".")[2] in self._dialect.making) or name in self._dialect.modules

    def mattering(self, name: str) -> list[str]:
        """What in the module or class ``name`` makes or asks for names."""
        start = self._dialect.canonical(name) + "."
        return [each[len(start) :] for each in self._dialect.handlers if each.startswith(start) and self.matters(each)]


def _path_function(name: str, positional: list[Value]) -> Value:
    if name == "basename" and positional and isinstance(positional[0], Text) and positional[0].template == NODE:
        return Text("{node}")
    return builtins.path_function(name, positional)
