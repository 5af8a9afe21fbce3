"""Calls into modules that are not followed: which of them make or ask for names, and what the others give back."""

from __future__ import annotations

import re
from collections.abc import Callable

from launchlint.extract.python import builtins, command_line, libraries, models, rospy
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.memory import Ended
from launchlint.extract.python.values import (
    MISSING,
    UNKNOWN,
    Argv,
    Class,
    External,
    Handle,
    Instance,
    Map,
    MessageClass,
    Partial,
    Scope,
    Seq,
    Value,
    alternatives,
    choice,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast

    from launchlint.extract.python.calls import Calls

Handler = Callable[[Call], Value]

_ROSPY_ROOMS = re.compile(r"rospy\.(?:topics|client|core|names|service|timer|rostime|exceptions|impl\.[a-z_]+|msg|numpy_msg)\.")
_GENERATED = re.compile(r"(\w+)\.(?:msg|srv|action)\.(?:_\w+\.)?([A-Za-z]\w*)")
_MESSAGE = re.compile(r"([A-Za-z]\w*)/(?:msg/|srv/)?([A-Za-z]\w*)", re.ASCII)


def canonical(name: str) -> str:
    """One name for what a module gives out under several."""
    name = _ROSPY_ROOMS.sub("rospy.", name)
    return _ALIASES.get(name, name)


_ALIASES = {
    "actionlib.simple_action_server.SimpleActionServer": "actionlib.SimpleActionServer",
    "actionlib.simple_action_client.SimpleActionClient": "actionlib.SimpleActionClient",
    "actionlib.action_server.ActionServer": "actionlib.ActionServer",
    "actionlib.action_client.ActionClient": "actionlib.ActionClient",
    "tf.listener.TransformListener": "tf.TransformListener",
    "tf.broadcaster.TransformBroadcaster": "tf.TransformBroadcaster",
    "tf2_ros.buffer.Buffer": "tf2_ros.Buffer",
    "tf2_ros.transform_listener.TransformListener": "tf2_ros.TransformListener",
    "tf2_ros.transform_broadcaster.TransformBroadcaster": "tf2_ros.TransformBroadcaster",
    "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster": "tf2_ros.StaticTransformBroadcaster",
    "tf2_ros.buffer_client.BufferClient": "tf2_ros.BufferClient",
    "tf2_ros.buffer_server.BufferServer": "tf2_ros.BufferServer",
    "smach_ros.simple_action_state.SimpleActionState": "smach_ros.SimpleActionState",
    "smach_ros.service_state.ServiceState": "smach_ros.ServiceState",
    "smach_ros.monitor_state.MonitorState": "smach_ros.MonitorState",
    "smach_ros.introspection.IntrospectionServer": "smach_ros.IntrospectionServer",
    "smach_ros.action_server_wrapper.ActionServerWrapper": "smach_ros.ActionServerWrapper",
    "dynamic_reconfigure.Server": "dynamic_reconfigure.server.Server",
    "dynamic_reconfigure.Client": "dynamic_reconfigure.client.Client",
    "diagnostic_updater._diagnostic_updater.Updater": "diagnostic_updater.Updater",
    "roslib.names.ns_join": "rosgraph.names.ns_join",
    "rospy.ns_join": "rosgraph.names.ns_join",
}


def message_class(value: Value) -> str:
    """The type that a message, service or action class stands for; empty where it is not known."""
    if isinstance(value, MessageClass):
        return value.type
    if isinstance(value, External):
        name = canonical(value.name)
        if name == "rospy.AnyMsg":
            return "*"
        match = _GENERATED.fullmatch(name)
        if match is not None:
            return f"{match[1]}/{match[2]}"
    return ""


def attribute(name: str, member: str) -> Value:
    """``name.member`` of a module that is not followed."""
    full = f"{name}.{member}"
    if full == "sys.argv":
        return Argv(0)
    if full in ("sys.maxsize", "os.environ"):
        return UNKNOWN if full == "sys.maxsize" else External(full)
    if member in ("_type", "_md5sum", "__name__"):
        type_ = message_class(External(name))
        if type_:
            return {"_type": type_, "__name__": type_.partition("/")[2]}.get(member, UNKNOWN)
    return External(full) if len(full) < 300 else UNKNOWN


def call(run: Calls, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
    """Call something of a module that is not followed, by its full name."""
    name = canonical(name)
    made = Call(run, name, positional, keywords, node, scope)
    if name.endswith(".__init__") and positional and isinstance(positional[0], Instance):
        inherited(run, name[: -len(".__init__")], positional[0], positional[1:], keywords, node, scope)
        return None
    handler = HANDLERS.get(name)
    if handler is not None:
        return handler(made)
    if name.startswith("os.path."):
        return builtins.path_function(name[len("os.path.") :], positional)
    if message_class(External(name)):
        return UNKNOWN
    when = "message" if name.startswith("rospy.") and name != "rospy.Timer" else "start"
    run.escape([*positional, *keywords.values()], when)
    model = models.model_of(name)
    if model is not None:
        models.follow(model, made)
    elif not run.is_silent(name):
        made.doubt(f"it uses {name.partition('.')[0]}, whose source was not given")
    return UNKNOWN


def is_open(run: Calls, name: str) -> bool:
    """Whether nothing is known of what something outside makes."""
    name = canonical(name)
    return name not in HANDLERS and models.model_of(name) is None and not run.is_silent(name)


def method(
    run: Calls, receiver: Handle, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
) -> Value:
    """Call a method of what a recognised call made."""
    handler = METHODS.get((receiver.kind, name))
    made = Call(run, name, positional, keywords, node, scope)
    if handler is not None:
        return handler(receiver, made)
    run.escape([*positional, *keywords.values()], "message" if receiver.kind != "plain" else "start")
    return UNKNOWN


def inherited(
    run: Calls, base: str, instance: Instance, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
) -> None:
    """The constructor of a base class that is not followed."""
    base = canonical(base)
    if base in ("builtins.object", "object"):
        return
    handler = HANDLERS.get(base)
    if handler is not None:
        handler(Call(run, base, positional, keywords, node, scope))
        run.escape([*positional, *keywords.values()], "message")
        return
    if base == "threading.Thread" and "target" in keywords:
        _thread(Call(run, base, positional, keywords, node, scope))
        return
    run.escape([*positional, *keywords.values()], "start")
    model = models.model_of(base)
    if model is not None:
        models.follow(model, Call(run, base, positional, keywords, node, scope))


def inherited_method(
    run: Calls, name: str, instance: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
) -> Value:
    """A method that a followed class has from one that is not followed."""
    run.escape([*positional, *keywords.values()], "message")
    return UNKNOWN


# -- what is of Python's own library ------------------------------------------------------------------------------------------


def _thread(made: Call) -> Value:
    target = made.get(1, "target")
    arguments = made.get(3, "args", Seq([]))
    keywords = made.get(4, "kwargs", Map({}))
    if target not in (MISSING, None):
        positional = list(arguments.items) if isinstance(arguments, Seq) else None
        made.run.arrange(target, "start", positional, dict(keywords.entries) if isinstance(keywords, Map) else {})
    return Handle("plain", {})


def _timer(made: Call) -> Value:
    target = made.get(1, "function")
    arguments = made.get(2, "args", Seq([]))
    if target not in (MISSING, None):
        made.run.arrange(target, "start", list(arguments.items) if isinstance(arguments, Seq) else None)
    return Handle("plain", {})


def _partial(made: Call) -> Value:
    if not made.positional:
        return UNKNOWN
    return Partial(made.positional[0], tuple(made.positional[1:]), tuple(made.keywords.items()))


def _end(made: Call) -> Value:
    raise Ended


def _message_by_name(made: Call) -> Value:
    name = made.get(0, "message_type")
    match = _MESSAGE.fullmatch(name) if isinstance(name, str) else None
    return UNKNOWN if match is None else MessageClass(f"{match[1]}/{match[2]}")


def _tests(made: Call) -> Value:
    given = [each for each in (*made.positional, *made.keywords.values()) if isinstance(each, Class)]
    made.run.escape(given or made.run.test_classes(), "start")
    return UNKNOWN


def _empty_mapping(made: Call) -> Value:
    first = made.positional[-1] if made.positional else MISSING
    entries = first.entries if isinstance(first, Map) else {}
    return Map({**entries, **made.keywords}, not made.positional or isinstance(first, Map))


def _default_mapping(made: Call) -> Value:
    return Map({}, False)


def _empty_sequence(made: Call) -> Value:
    first = made.positional[0] if made.positional else MISSING
    return Seq(list(first.items), first.complete) if isinstance(first, Seq) else Seq([], first is MISSING)


def _copied(made: Call) -> Value:
    return made.positional[0] if made.positional else UNKNOWN


def _imported(made: Call) -> Value:
    """``importlib.import_module``: a module by a name that is worked out."""
    name = made.get(0, "name", UNKNOWN)
    return choice([(condition, made.run.module(each, made)) for condition, each in alternatives(name)])


def _loaded(made: Call) -> Value:
    made.run.module(UNKNOWN, made)
    return UNKNOWN


def _plain_class(made: Call) -> Value:
    """A class that is made by a call and has no methods that talk."""
    return External("builtins.object")


def _with_metaclass(made: Call) -> Value:
    return made.get(1, "base", External("builtins.object"))


def _wrapped(made: Call) -> Value:
    """``functools.wraps(f)``: a decorator that gives back what it gets."""
    return External("copy.copy")


HANDLERS: dict[str, Handler] = {
    "sys.exit": _end,
    "os._exit": _end,
    "os.abort": _end,
    "threading.Thread": _thread,
    "multiprocessing.Process": _thread,
    "threading.Timer": _timer,
    "functools.partial": _partial,
    "functools.wraps": _wrapped,
    "importlib.import_module": _imported,
    "imp.load_source": _loaded,
    "imp.load_module": _loaded,
    "importlib.util.spec_from_file_location": _loaded,
    "runpy.run_path": _loaded,
    "runpy.run_module": _loaded,
    "collections.namedtuple": _plain_class,
    "typing.NamedTuple": _plain_class,
    "six.with_metaclass": _with_metaclass,
    "future.utils.with_metaclass": _with_metaclass,
    "copy.copy": _copied,
    "copy.deepcopy": _copied,
    "collections.OrderedDict": _empty_mapping,
    "collections.defaultdict": _default_mapping,
    "rostest.rosrun": _tests,
    "rostest.run": _tests,
    "rostest.unitrun": _tests,
    "rosunit.unitrun": _tests,
    "unittest.main": _tests,
    "collections.deque": _empty_sequence,
    "roslib.message.get_message_class": _message_by_name,
    "roslib.message.get_service_class": _message_by_name,
    "rosservice.get_service_class_by_name": lambda made: UNKNOWN,
    **rospy.HANDLERS,
    **libraries.HANDLERS,
    **command_line.HANDLERS,
}

METHODS: dict[tuple[str, str], Callable[[Handle, Call], Value]] = {
    **rospy.METHODS,
    **libraries.METHODS,
    **command_line.METHODS,
}

_QUIET = frozenset(
    "get_name get_namespace get_caller_id sleep spin is_shutdown myargv ns_join Timer on_shutdown init_node numpy_msg".split()
)
MAKING = frozenset(name.rpartition(".")[2] for name in (*rospy.HANDLERS, *libraries.HANDLERS, *models.NAMES)) - _QUIET
"""The last words of calls that make or ask for names."""


def makes(name: str) -> bool:
    """Whether something outside makes or asks for names when it is called, or is a module in which there is such a thing."""
    name = canonical(name)
    return (name in HANDLERS and name.rpartition(".")[2] in MAKING) or name in _MODULES


def makers(name: str) -> list[str]:
    """What in the module or class ``name`` makes or asks for names."""
    start = canonical(name) + "."
    return [each[len(start) :] for each in HANDLERS if each.startswith(start) and makes(each)]


_MODULES = ("rospy",)
