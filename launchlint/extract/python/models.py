"""Classes and functions of ROS packages that make names, as a table: what is called, with which arguments, and which names that makes.

A paragraph is one call: its full name with its arguments in order (``x=value`` has a default), and below it a line for each name:
category, name, type; of an action its role stands in the category. ``<x>`` is the argument ``x``, ``<x>/`` before a name the namespace
that the argument gives, ``*`` any name. What follows ``if`` is the condition. ``open`` says in which categories (all, where none is named)
there may be more, and why.
"""

from __future__ import annotations

import re
from functools import lru_cache

from launchlint.extract.python.arguments import Call
from launchlint.extract.python.names import ros_joined
from launchlint.named_tuple import NamedTuple
from launchlint.python.text import joined
from launchlint.python.values import UNKNOWN, Value

_TABLE = """
moveit_commander.MoveGroupCommander name robot_description=robot_description ns=
  publishers <ns>/trajectory_execution_event std_msgs/String
  publishers <ns>/attached_collision_object moveit_msgs/AttachedCollisionObject
  subscribers <ns>/joint_states sensor_msgs/JointState if the state of the robot is asked for
  subscribers /tf tf2_msgs/TFMessage
  subscribers /tf_static tf2_msgs/TFMessage
  actions:client <ns>/move_group moveit_msgs/MoveGroupAction
  actions:client <ns>/pickup moveit_msgs/PickupAction
  actions:client <ns>/place moveit_msgs/PlaceAction
  actions:client <ns>/execute_trajectory moveit_msgs/ExecuteTrajectoryAction
  clients <ns>/query_planner_interface moveit_msgs/QueryPlannerInterfaces
  clients <ns>/get_planner_params moveit_msgs/GetPlannerParams
  clients <ns>/set_planner_params moveit_msgs/SetPlannerParams
  clients <ns>/compute_cartesian_path moveit_msgs/GetCartesianPath
  clients <ns>/plan_grasps moveit_msgs/GraspPlanning
  params <robot_description>
  params <robot_description>_semantic
  params <robot_description>_planning/*
  params <robot_description>_kinematics/*
  params <ns>/move_group/*

moveit_commander.RobotCommander robot_description=robot_description ns=
  subscribers <ns>/joint_states sensor_msgs/JointState if the state of the robot is asked for
  subscribers /tf tf2_msgs/TFMessage if the state of the robot is asked for
  subscribers /tf_static tf2_msgs/TFMessage if the state of the robot is asked for
  params <robot_description>
  params <robot_description>_semantic
  params <robot_description>_planning/*
  params <robot_description>_kinematics/*
  open publishers clients actions params: it makes groups of joints for MoveIt

moveit_commander.PlanningSceneInterface ns= synchronous=True
  publishers <ns>/planning_scene moveit_msgs/PlanningScene
  publishers <ns>/collision_object moveit_msgs/CollisionObject if it is not synchronous
  publishers <ns>/attached_collision_object moveit_msgs/AttachedCollisionObject if it is not synchronous
  clients <ns>/get_planning_scene moveit_msgs/GetPlanningScene
  clients <ns>/apply_planning_scene moveit_msgs/ApplyPlanningScene

sound_play.libsoundplay.SoundClient blocking=False sound_action=sound_play sound_topic=robotsound
  publishers <sound_topic> sound_play/SoundRequest
  actions:client <sound_action> sound_play/SoundRequestAction

ddynamic_reconfigure_python.ddynamic_reconfigure.DDynamicReconfigure name
  publishers ~<name>/parameter_descriptions dynamic_reconfigure/ConfigDescription
  publishers ~<name>/parameter_updates dynamic_reconfigure/Config
  services ~<name>/set_parameters dynamic_reconfigure/Reconfigure
  params ~<name>/*

urdf_parser_py.urdf.URDF.from_parameter_server key=robot_description
  params <key>

urdf_parser_py.urdf.Robot.from_parameter_server key=robot_description
  params <key>

urdf_parser_py.urdf.URDF.load_from_parameter_server key=robot_description
  params <key>

srdfdom.srdf.SRDF.from_parameter_server key=robot_description_semantic
  params <key>

kdl_parser_py.urdf.treeFromParam param
  params <param>

rosparam.get_param param
  params <param>

rosparam.list_params ns
  params <ns>/*

rosservice.call_service service_name
  clients <service_name>

rosservice.get_service_class service_name

controller_manager.controller_manager_interface
  open clients: it calls the services of a controller manager

controller_manager_msgs.utils
  open clients params: it calls the services of controller managers

gazebo_ros.gazebo_interface
  open clients: it calls the services of Gazebo

rostopic
  open publishers subscribers: it uses rostopic, which makes the names that it is told

roslaunch
  open: it starts other nodes with roslaunch

gym.make id
  open: it makes an environment by its name, which may talk to anybody

gymnasium.make id
  open: it makes an environment by its name, which may talk to anybody
"""

_QUIET = frozenset(
    """
    moveit_commander.roscpp_initialize moveit_commander.roscpp_shutdown moveit_commander.roscpp_initializer moveit_commander.conversions
    moveit_commander.exception moveit_commander.MoveItCommanderException moveit_commander.os._exit moveit_commander.sys
    rostopic.get_topic_type rostopic.get_topic_class rostopic.find_by_type rostopic.get_topic_list rostopic.get_info_text
    rostopic.ROSTopicException rostopic.get_topic_headers rostopic.ROSTopicIOException
    roslaunch.rlutil roslaunch.core roslaunch.configure_logging roslaunch.Node roslaunch.config roslaunch.substitution_args
    roslaunch.xmlloader roslaunch.loader roslaunch.arg_dump roslaunch.node_args
    """.split()
)
"""What makes no names in modules that do."""

_ALIASES = {
    "moveit_commander.move_group.MoveGroupCommander": "moveit_commander.MoveGroupCommander",
    "moveit_commander.robot.RobotCommander": "moveit_commander.RobotCommander",
    "moveit_commander.planning_scene_interface.PlanningSceneInterface": "moveit_commander.PlanningSceneInterface",
}
_HOLE = re.compile(r"<(\w+)>|\*")


class Model(NamedTuple):
    """A call: its arguments with their defaults, lines of names, and the categories that it opens with the reason."""

    arguments: tuple[tuple[str, Value], ...]
    names: tuple[tuple[str, str, str, str, str], ...]
    opens: tuple[str, ...] | None
    reason: str


def model_of(name: str) -> Model | None:
    """What is known of calling ``name``, or something in the module ``name``."""
    name = _ALIASES.get(name, name)
    models = _models()
    parts = name.split(".")
    for end in range(len(parts), 0, -1):
        before = ".".join(parts[:end])
        if before in _QUIET:
            return _NOTHING
        if before in models and (end == len(parts) or not models[before].arguments):
            return models[before]
    return None


def follow(model: Model, made: Call) -> None:
    """Note what a call makes."""
    values = {name: made.get(at, name, default) for at, (name, default) in enumerate(model.arguments)}
    for category, name, type_, role, condition in model.names:
        more = {"role": role} if role else {}
        if category != "params":
            more["type"] = type_
        mark = len(made.run.conditions)
        if condition:
            made.run.conditions.append(condition)
        made.fact(category, _spelled(name, values), **more)
        del made.run.conditions[mark:]
    if model.opens is not None:
        made.doubt(model.reason, model.opens or None)


def _spelled(name: str, values: dict[str, Value]) -> Value:
    head, slash, rest = name.partition(">/")
    if slash and head.startswith("<"):
        return ros_joined(values.get(head[1:], UNKNOWN), _filled(rest, values))
    return _filled(name, values)


def _filled(name: str, values: dict[str, Value]) -> Value:
    parts: list[Value] = []
    at = 0
    for match in _HOLE.finditer(name):
        parts += [name[at : match.start()], values.get(match[1], UNKNOWN) if match[1] else UNKNOWN]
        at = match.end()
    return joined([*parts, name[at:]])


@lru_cache(maxsize=1)
def _models() -> dict[str, Model]:
    found: dict[str, Model] = {}
    for paragraph in _TABLE.strip().split("\n\n"):
        head, *lines = paragraph.split("\n")
        full, *arguments = head.split()
        names: list[tuple[str, str, str, str, str]] = []
        opens: tuple[str, ...] | None = None
        reason = ""
        for line in lines:
            said, _, condition = line.strip().partition(" if ")
            if said.startswith("open"):
                categories, _, reason = said.removeprefix("open").partition(": ")
                opens = tuple(categories.split())
                continue
            category, name, *type_ = said.split()
            category, _, role = category.partition(":")
            names.append((category, name, type_[0] if type_ else "", role, condition))
        given = tuple((each.partition("=")[0], each.partition("=")[2] if "=" in each else UNKNOWN) for each in arguments)
        found[full] = Model(given, tuple(names), opens, reason)
    return found


_NOTHING = Model((), (), None, "")

NAMES = tuple(paragraph.split(None, 1)[0] for paragraph in _TABLE.strip().split("\n\n"))
"""The full names of all that is in the table."""
