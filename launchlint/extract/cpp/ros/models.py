"""Classes of ROS packages whose sources are seldom given, and what an object of each makes: read in the sources of their packages.

A name is relative to the node handle that the object is given, or to a default one. ``<1>`` is the first argument that is no node handle;
``<2|/topic>`` the second one, with what the class takes where it is left out. ``{any}`` stands for what the class makes below a namespace,
by what params say. ``opens`` are categories of which it may make more, of any name.
"""

from __future__ import annotations

import re

from launchlint.extract.cpp.naming import ANY, template
from launchlint.extract.cpp.ros import params
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Handle, Number, Text, Thing, Value, choices, either
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

ALL = ("publishers", "subscribers", "services", "clients", "actions", "params")
_ARGUMENT = re.compile(r"<(\d)(?:\|([^<>]*))?>")


class Say(NamedTuple):
    """One name that an object makes; ``condition`` says in words what must happen to it first."""

    category: str
    name: str
    type: str = ""
    role: str = ""
    latched: bool = False
    condition: str = ""


class Model(NamedTuple):
    """What an object of a class makes; ``opens`` with the ``reason`` why there may be more."""

    says: tuple[Say, ...] = ()
    opens: tuple[str, ...] = ()
    reason: str = ""


def _below(space: str, *categories: str) -> tuple[Say, ...]:
    return tuple(Say(category, f"{space}/{ANY}") for category in categories)


def _reconfigured(space: str) -> tuple[Say, ...]:
    return (
        Say("publishers", f"{space}/parameter_descriptions", "dynamic_reconfigure/ConfigDescription", latched=True),
        Say("publishers", f"{space}/parameter_updates", "dynamic_reconfigure/Config", latched=True),
        Say("services", f"{space}/set_parameters", "dynamic_reconfigure/Reconfigure"),
    )


_TF = (Say("subscribers", "/tf", "tf2_msgs/TFMessage"), Say("subscribers", "/tf_static", "tf2_msgs/TFMessage"))
_ROBOT = tuple(Say("params", f"robot_description{end}") for end in ("", "_semantic", f"_planning/{ANY}", f"_kinematics/{ANY}"))
_MOVE_GROUP = Model(
    (
        *(
            Say("actions", name, f"moveit_msgs/{kind}Action", "client")
            for name, kind in (
                ("move_group", "MoveGroup"), ("execute_trajectory", "ExecuteTrajectory"), ("pickup", "Pickup"), ("place", "Place"),
            )
        ),
        *(
            Say("clients", name, f"moveit_msgs/{kind}")
            for name, kind in (
                ("query_planner_interface", "QueryPlannerInterfaces"), ("get_planner_params", "GetPlannerParams"),
                ("set_planner_params", "SetPlannerParams"), ("compute_cartesian_path", "GetCartesianPath"),
                ("plan_grasps", "GraspPlanning"),
            )
        ),
        Say("publishers", "trajectory_execution_event", "std_msgs/String"),
        Say("publishers", "attached_collision_object", "moveit_msgs/AttachedCollisionObject"),
        Say("subscribers", "joint_states", "sensor_msgs/JointState", condition="the state of the robot is asked for"),
        Say("params", f"move_group/{ANY}"),
        *_TF,
        *_ROBOT,
    )
)  # fmt: skip
_PLANNER = _below("~<1>", "publishers", "services", "params")

MODELS: dict[str, Model] = {
    # navigation
    "costmap_2d::Costmap2DROS": Model(
        (
            Say("publishers", "~<1>/costmap", "nav_msgs/OccupancyGrid", latched=True),
            Say("publishers", "~<1>/costmap_updates", "map_msgs/OccupancyGridUpdate"),
            Say("publishers", "~<1>/footprint", "geometry_msgs/PolygonStamped"),
            Say("subscribers", "~<1>/footprint", "geometry_msgs/Polygon"),
            *_reconfigured("~<1>"),
            *_below("~<1>", "publishers", "services", "params"),
        ),
        ("subscribers",),
        "the layers of a costmap hear topics that params name",
    ),
    "navfn::NavfnROS": Model(
        (
            Say("publishers", "~<1>/plan", "nav_msgs/Path"),
            Say("services", "~<1>/make_plan", "nav_msgs/GetPlan"),
            *_PLANNER,
        )
    ),
    "global_planner::GlobalPlanner": Model(
        (
            Say("publishers", "~<1>/plan", "nav_msgs/Path"),
            Say("publishers", "~<1>/potential", "nav_msgs/OccupancyGrid"),
            Say("services", "~<1>/make_plan", "nav_msgs/GetPlan"),
            *_PLANNER,
        )
    ),
    **dict.fromkeys(
        ("base_local_planner::TrajectoryPlannerROS", "dwa_local_planner::DWAPlannerROS", "teb_local_planner::TebLocalPlannerROS"),
        Model(
            (
                Say("publishers", "~<1>/global_plan", "nav_msgs/Path"),
                Say("publishers", "~<1>/local_plan", "nav_msgs/Path"),
                *_reconfigured("~<1>"),
                *_PLANNER,
                *_below("~<1>", "subscribers"),
            ),
            ("subscribers",),
            "a local planner hears the odometry that a param names",
        ),
    ),
    "base_local_planner::OdometryHelperRos": Model((Say("subscribers", "<1>", "nav_msgs/Odometry"),)),
    "octomap_server::OctomapServer": Model((), ALL, "octomap_server::OctomapServer has an interface of its own"),
    # MoveIt
    **dict.fromkeys(
        (
            "moveit::planning_interface::MoveGroupInterface", "moveit::planning_interface::MoveGroup", "move_group_interface::MoveGroup",
            "move_group_interface::MoveGroupInterface",
        ),
        _MOVE_GROUP,
    ),
    "moveit::planning_interface::PlanningSceneInterface": Model(
        (
            Say("publishers", "planning_scene", "moveit_msgs/PlanningScene"),
            Say("clients", "get_planning_scene", "moveit_msgs/GetPlanningScene"),
            Say("clients", "apply_planning_scene", "moveit_msgs/ApplyPlanningScene"),
        )
    ),
    "robot_model_loader::RobotModelLoader": Model(
        (
            Say("params", "<1|robot_description>"),
            Say("params", "<1|robot_description>_semantic"),
            Say("params", f"<1|robot_description>_planning/{ANY}"),
            Say("params", f"<1|robot_description>_kinematics/{ANY}"),
        )
    ),
    "rdf_loader::RDFLoader": Model((Say("params", "<1|robot_description>"), Say("params", "<1|robot_description>_semantic"))),
    "TRAC_IK::TRAC_IK": Model((Say("params", "<3|/robot_description>"),)),
    "planning_scene_monitor::CurrentStateMonitor": Model(
        (Say("subscribers", "joint_states", "sensor_msgs/JointState"), *_TF), ("subscribers",), "the joint states have a name of their own"
    ),
    **{
        name: Model(_ROBOT, ALL, f"{name} has an interface of its own")
        for name in (
            "planning_scene_monitor::PlanningSceneMonitor", "planning_pipeline::PlanningPipeline", "moveit_cpp::MoveItCpp",
            "moveit::planning_interface::MoveItCpp", "trajectory_execution_manager::TrajectoryExecutionManager",
            "moveit_visual_tools::MoveItVisualTools", "plan_execution::PlanExecution", "pick_place::PickPlace",
        )
    },
    "rviz_visual_tools::RvizVisualTools": Model(
        (
            Say("publishers", "<2|/rviz_visual_tools>", "visualization_msgs/MarkerArray"),
            Say("subscribers", "/rviz_visual_tools_gui", "sensor_msgs/Joy"),
        )
    ),
    # frames and models of robots
    "tf2_ros::BufferServer": Model((Say("actions", "<2>", "tf2_msgs/LookupTransformAction", "server"),)),
    "tf2_ros::BufferClient": Model((Say("actions", "<1>", "tf2_msgs/LookupTransformAction", "client"),)),
    "robot_state_publisher::RobotStatePublisher": Model(
        (Say("publishers", "/tf", "tf2_msgs/TFMessage"), Say("publishers", "/tf_static", "tf2_msgs/TFMessage", latched=True))
    ),
    # settings
    "ddynamic_reconfigure::DDynamicReconfigure": Model(
        (
            Say("publishers", "~parameter_descriptions", "dynamic_reconfigure/ConfigDescription", latched=True),
            Say("publishers", "~parameter_updates", "dynamic_reconfigure/Config", latched=True),
            Say("services", "~set_parameters", "dynamic_reconfigure/Reconfigure"),
        ),
        ("params",),
        "ddynamic_reconfigure makes params of what is registered",
    ),
    "dynamic_reconfigure::Client": Model(
        (
            Say("clients", "<1>/set_parameters", "dynamic_reconfigure/Reconfigure"),
            Say("subscribers", "<1>/parameter_descriptions", "dynamic_reconfigure/ConfigDescription"),
            Say("subscribers", "<1>/parameter_updates", "dynamic_reconfigure/Config"),
        )
    ),
    # what keeps an eye on others
    "bond::Bond": Model(
        (
            Say("publishers", "<1>", "bond/Status"),
            Say("subscribers", "<1>", "bond/Status"),
            Say("params", "/bond_disable_heartbeat_timeout"),
        )
    ),
    "rosbag::Recorder": Model((), ("subscribers",), "a rosbag::Recorder hears what it is told to record"),
    "rosbag::Player": Model((), ("publishers", "services"), "a rosbag::Player publishes what stands in a bag"),
    "interactive_markers::InteractiveMarkerClient": Model(
        (), ("publishers", "subscribers"), "an InteractiveMarkerClient hears markers of a name that it is told later"
    ),
}  # fmt: skip
"""What an object makes, by its class."""

BASES: dict[str, Model] = {
    **dict.fromkeys(
        ("jsk_topic_tools::ConnectionBasedNodelet", "jsk_topic_tools::DiagnosticNodelet"),
        Model(
            tuple(Say("params", name) for name in ("~always_subscribe", "~verbose_connection", "verbose_connection")),
            ("publishers", "params"),
            "the base class of the nodelet may publish diagnostics",
        ),
    ),
    "pcl_ros::PCLNodelet": Model(
        tuple(Say("params", f"~{name}") for name in ("max_queue_size", "use_indices", "latched_indices", "approximate_sync"))
    ),
}
"""What a base class makes, for those that are derived from it."""


def modelled(asked: Call, model: Model) -> Value:
    """Note what an object makes, and what it leaves open."""
    machine = asked.machine
    handles = [each.value for each in asked.arguments if any(isinstance(one, Handle) for _, one in choices(each.value))]
    handle = handles[0] if handles else Handle("")
    given = [each.value for each in asked.arguments if not any(isinstance(one, Handle) for _, one in choices(each.value))]
    before = len(machine.conditions)
    for each in model.says:
        names = _names(each.name, given)
        found: list[tuple[str, Value]] = []
        for condition, space in choices(handle):
            inner = params.named(space if isinstance(space, Handle) else Handle(""), names)
            found += [(condition or one, value) for one, value in choices(inner)]
        more = {key: value for key, value in (("role", each.role), ("latched", each.latched)) if value}
        machine.conditions += [each.condition] if each.condition else []
        machine.fact(each.category, either(found), asked.node, asked.frame, type=each.type, **more)
        del machine.conditions[before:]
    for category in model.opens:
        machine.doubt(category, model.reason, asked.node, asked.frame)
    machine.serial += 1
    return Thing(Type(asked.name, asked.types), None, machine.serial)


def _names(name: str, given: list[Value]) -> Value:
    """The name with the arguments put in: a text for each value that they can have."""
    match = _ARGUMENT.search(name)
    if match is None:
        return Text(name)
    position = int(match[1]) - 1
    value: Value = given[position] if position < len(given) else Text(match[2]) if match[2] is not None else UNKNOWN
    found: list[tuple[str, Value]] = []
    for condition, each in choices(value):
        text = template(each) if isinstance(each, (Text, Number)) else ANY
        found.append((condition, Text(name.replace(match[0], text))))
    return either(found)
