"""Messages of widely used packages, to tell which ``from x.msg import *`` a name is from. Facts of the packages as released for noetic."""

from __future__ import annotations

_LISTED = """
std_msgs.msg Bool Byte ByteMultiArray Char ColorRGBA Duration Empty Float32 Float32MultiArray Float64 Float64MultiArray Header Int16
  Int16MultiArray
  Int32 Int32MultiArray Int64 Int64MultiArray Int8 Int8MultiArray MultiArrayDimension MultiArrayLayout String Time UInt16 UInt16MultiArray
  UInt32 UInt32MultiArray UInt64 UInt64MultiArray UInt8 UInt8MultiArray
geometry_msgs.msg Accel AccelStamped AccelWithCovariance AccelWithCovarianceStamped Inertia InertiaStamped Point Point32 PointStamped
  Polygon
  PolygonStamped Pose Pose2D PoseArray PoseStamped PoseWithCovariance PoseWithCovarianceStamped Quaternion QuaternionStamped Transform
  TransformStamped Twist TwistStamped TwistWithCovariance TwistWithCovarianceStamped Vector3 Vector3Stamped Wrench WrenchStamped
sensor_msgs.msg BatteryState CameraInfo ChannelFloat32 CompressedImage FluidPressure Illuminance Image Imu JointState Joy JoyFeedback
  JoyFeedbackArray LaserEcho LaserScan MagneticField MultiDOFJointState MultiEchoLaserScan NavSatFix NavSatStatus PointCloud PointCloud2
  PointField Range RegionOfInterest RelativeHumidity Temperature TimeReference
nav_msgs.msg GetMapAction GridCells MapMetaData OccupancyGrid Odometry Path
actionlib_msgs.msg GoalID GoalStatus GoalStatusArray
visualization_msgs.msg ImageMarker InteractiveMarker InteractiveMarkerControl InteractiveMarkerFeedback InteractiveMarkerInit
  InteractiveMarkerPose
  InteractiveMarkerUpdate Marker MarkerArray MenuEntry
diagnostic_msgs.msg DiagnosticArray DiagnosticStatus KeyValue
trajectory_msgs.msg JointTrajectory JointTrajectoryPoint MultiDOFJointTrajectory MultiDOFJointTrajectoryPoint
control_msgs.msg FollowJointTrajectoryAction FollowJointTrajectoryGoal GripperCommandAction GripperCommand JointControllerState
  JointTolerance
  PointHeadAction SingleJointPositionAction JointJog JointTrajectoryAction JointTrajectoryControllerState PidState
move_base_msgs.msg MoveBaseAction MoveBaseGoal MoveBaseActionGoal MoveBaseActionResult MoveBaseFeedback MoveBaseResult
  MoveBaseActionFeedback
tf2_msgs.msg LookupTransformAction TF2Error TFMessage
tf.msg tfMessage
rosgraph_msgs.msg Clock Log TopicStatistics
shape_msgs.msg Mesh MeshTriangle Plane SolidPrimitive
std_srvs.srv Empty SetBool Trigger EmptyRequest EmptyResponse SetBoolRequest SetBoolResponse TriggerRequest TriggerResponse
nav_msgs.srv GetMap GetPlan SetMap LoadMap
sensor_msgs.srv SetCameraInfo
gazebo_msgs.msg ContactState ContactsState LinkState LinkStates ModelState ModelStates ODEJointProperties ODEPhysics WorldState
gazebo_msgs.srv ApplyBodyWrench ApplyJointEffort DeleteModel GetJointProperties GetLinkState GetModelProperties GetModelState
  GetPhysicsProperties
  GetWorldProperties SetJointProperties SetLinkState SetModelConfiguration SetModelState SetPhysicsProperties SpawnModel
mavros_msgs.msg ActuatorControl AttitudeTarget ExtendedState GlobalPositionTarget ManualControl OverrideRCIn PositionTarget RCIn RCOut State
  Thrust VFR_HUD Waypoint WaypointList WaypointReached HomePosition Altitude
mavros_msgs.srv CommandBool CommandHome CommandInt CommandLong CommandTOL ParamGet ParamSet SetMode StreamRate WaypointClear WaypointPull
  WaypointPush WaypointSetCurrent ParamPull ParamPush SetMavFrame
ackermann_msgs.msg AckermannDrive AckermannDriveStamped
controller_manager_msgs.srv ListControllers LoadController SwitchController UnloadController ListControllerTypes ReloadControllerLibraries
moveit_msgs.msg MoveGroupAction PlanningScene RobotState RobotTrajectory DisplayTrajectory CollisionObject AttachedCollisionObject
  Constraints
"""


def _table() -> dict[str, frozenset[str]]:
    table: dict[str, set[str]] = {}
    module = ""
    for word in _LISTED.split():
        if "." in word:
            module = word
        else:
            table.setdefault(module, set()).add(word)
    return {name: frozenset(words) for name, words in table.items()}


KNOWN = _table()
"""``package.msg`` or ``package.srv`` → names in it."""


def origin(name: str, stars: list[str]) -> str:
    """Which of the modules ``stars``, from which everything was imported, gives ``name``; empty where that cannot be told."""
    for module in stars:
        if name in KNOWN.get(module, ()):
            return module
    if not name[:1].isupper():
        return ""
    open_ = [module for module in dict.fromkeys(stars) if module.endswith((".msg", ".srv")) and module not in KNOWN]
    if len(open_) > 1:
        is_action = name.endswith(("Goal", "Action", "Result", "Feedback"))
        kind = ".srv" if name.endswith(("Request", "Response")) else ".msg" if is_action else ""
        open_ = [module for module in open_ if module.endswith(kind)]
    return open_[0] if len(open_) == 1 else ""
