"""The tables of roscpp, and of the packages around it."""

from __future__ import annotations

from launchlint.extract.cpp.naming import NODE_NAME
from launchlint.extract.cpp.ros.functions import FUNCTIONS
from launchlint.extract.cpp.ros.handle import METHODS as OF_HANDLE
from launchlint.extract.cpp.ros.library import HARMLESS, MAKERS, METHODS
from launchlint.extract.cpp.ros.models import BASES, MODELS
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.tables import Tables, last_words
from launchlint.extract.cpp.values import UNKNOWN, Handle, Text, Thing, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_NODELETS = {
    "getNodeHandle": "",
    "getPrivateNodeHandle": "~",
    "getMTNodeHandle": "",
    "getMTPrivateNodeHandle": "~",
    "getSTNodeHandle": "",
    "getSTPrivateNodeHandle": "~",
}
_WORDS = frozenset(
    """advertise advertiseService advertiseCamera subscribe subscribeCamera serviceClient getParam getParamCached param
    hasParam searchParam NodeHandle waitForMessage waitForService createClient TransformListener TransformBroadcaster
    StaticTransformBroadcaster SimpleActionServer SimpleActionClient ActionServer ActionClient Subscriber Publisher Server
    ImageTransport Updater createTimer createWallTimer getNodeHandle getPrivateNodeHandle CameraInfoManager
    RealtimePublisher initParam thread createInstance createUniqueInstance Loader M_string
    this_node""".split()
)


def _of_nodelet(this: Thing, asked: Call) -> Value | None:
    """``getNodeHandle()`` and its like, and the name of a nodelet."""
    if asked.name in _NODELETS and not asked.arguments:
        return Handle(_NODELETS[asked.name])
    if asked.name in ("getNodeHandle", "getMTNodeHandle", "getSTNodeHandle"):
        return Handle("")
    if asked.name == "getName" and not asked.arguments and _is_nodelet(this, asked):
        return Text(NODE_NAME)
    return None


def _is_nodelet(this: Thing, asked: Call) -> bool:
    return this.declared is not None and any(
        "odelet" in base.name for declared in [this.declared, *asked.machine.names.bases(this.declared.name)] for base in declared.bases
    )


def _is_handle(type_: Type) -> bool:
    return type_.last in ("NodeHandle", "NodeHandlePtr") or type_.name.endswith("NodeHandle::Ptr")


ROSCPP = Tables(
    makers=MAKERS,
    standins={},
    methods=METHODS,
    functions=FUNCTIONS,
    of_handle=OF_HANDLE,
    of_object=_of_nodelet,
    models=MODELS,
    bases=BASES,
    values={},
    harmless=HARMLESS,
    categories={
        "advertise": "publishers",
        "subscribe": "subscribers",
        "advertiseService": "services",
        "serviceClient": "clients",
        "getParam": "params",
        "param": "params",
    },
    bare=frozenset(
        (
            "message_filters::Subscriber",
            "image_transport::SubscriberFilter",
            "urdf::Model",
            "ros::AdvertiseOptions",
            "ros::SubscribeOptions",
        )
    ),
    words=_WORDS | last_words(MAKERS, MODELS),
    silent_words=frozenset(
        (
            "NodeHandle getNodeHandle getPrivateNodeHandle thread createTimer createWallTimer Publisher Loader M_string NodeletLazy "
            "this_node"
        ).split()
    ),
    qualified=("param::get", "param::getCached", "param::has", "param::search", "service::call"),
    spaces=("ros", "image_transport", "dynamic_reconfigure"),
    owners={"Model": frozenset(("urdf",))},  # not srdf::Model
    is_handle=_is_handle,
    running=frozenset(("ros::ok()", "nh.ok()", "nh_.ok()", "n.ok()", "node.ok()", "ros::isInitialized()")),
    follow=lambda machine, thing: None,
    each=lambda value: UNKNOWN,
)
