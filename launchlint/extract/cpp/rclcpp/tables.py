"""The tables of rclcpp, and of the packages around it."""

from __future__ import annotations

from launchlint.extract.cpp.rclcpp import interface, library, lifecycle, nodes, params, qos, running
from launchlint.extract.cpp.rclcpp.models import MODELS
from launchlint.extract.cpp.ros import loading
from launchlint.extract.cpp.ros.library import STREAMS
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.tables import Tables, last_words

_HANDLES = frozenset(
    ("rclcpp::Node", "rclcpp_lifecycle::LifecycleNode", "nav2_util::LifecycleNode", "nav2::LifecycleNode", "LifecycleNode")
)  # fmt: skip
_WORDS = frozenset(
    """create_publisher create_subscription create_generic_publisher create_generic_subscription create_service create_client
    create_wall_timer create_timer create_server declare_parameter declare_parameters get_parameter get_parameter_or get_parameters
    wait_for_message create_camera_publisher create_camera_subscription advertise advertiseCamera subscribe subscribeCamera
    create_sub_node add_on_set_parameters_callback add_parameter declare_parameter_if_not_declared declare_or_get_parameter thread
    createInstance createSharedInstance createUniqueInstance ParamListener get_params
    on_configure on_activate configure activate trigger_transition createBond""".split()
)
_EVERYWHERE = frozenset(("Buffer", "NodeOptions"))
"""Classes that many functions are given which make no names."""
_SILENT = frozenset("create_wall_timer create_timer thread configure activate trigger_transition".split())


def _is_handle(type_: Type) -> bool:
    name = type_.name
    for end in ("::SharedPtr", "::ConstSharedPtr", "::UniquePtr", "::WeakPtr", "::SharedConstPtr"):
        name = name.removesuffix(end)
    return name in _HANDLES or name.startswith("rclcpp::node_interfaces::Node")


RCLCPP = Tables(
    makers={**qos.MAKERS, **nodes.MAKERS, **params.MAKERS, **interface.MAKERS, **library.MAKERS, **loading.MAKERS, **STREAMS},
    standins=library.STANDINS,
    methods={**qos.METHODS, **nodes.METHODS, **interface.METHODS, **running.METHODS, **library.METHODS, **loading.METHODS},
    functions={**qos.FUNCTIONS, **interface.FUNCTIONS, **running.FUNCTIONS, **library.FUNCTIONS},
    of_handle={**interface.OF_HANDLE, **library.OF_HANDLE},
    of_object=interface.of_object,
    models=MODELS,
    bases={},
    values={**qos.VALUES, **params.VALUES},
    harmless=library.HARMLESS,
    categories={
        "create_publisher": "publishers",
        "create_generic_publisher": "publishers",
        "create_subscription": "subscribers",
        "create_generic_subscription": "subscribers",
        "create_service": "services",
        "create_client": "clients",
        "declare_parameter": "params",
        "declare_parameters": "params",
        "get_parameter": "params",
        "get_parameter_or": "params",
    },
    bare=frozenset(("message_filters::Subscriber", "image_transport::SubscriberFilter")),
    words=_WORDS | last_words(nodes.MAKERS, library.MAKERS, library.STANDINS, interface.MAKERS, MODELS, loading.MAKERS) - _EVERYWHERE,
    silent_words=_SILENT,
    qualified=(),
    spaces=("rclcpp", "image_transport", "nav2"),
    owners={"Node": frozenset(("rclcpp",)), "Subscriber": frozenset(("message_filters",))},
    is_handle=_is_handle,
    running=frozenset(("rclcpp::ok()",)),
    follow=lifecycle.follow,
    each=params.each_of,
)
