"""What the well-known metapackages of ROS, and some much used packages, pull in, for a checkout where they are not installed.

Facts from the package.xml files of ROS Indigo to Noetic and of ROS 2 since Humble, all of them together; what no launch file can use
(message generators, tests) is left out.
"""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.workspace.public_packages import public_names

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.packages import Packages

_RVIZ = "rviz"
_MEMBERS: Mapping[str, str] = {
    "common_msgs": "actionlib_msgs diagnostic_msgs geometry_msgs nav_msgs sensor_msgs shape_msgs stereo_msgs"
    " trajectory_msgs visualization_msgs",
    "desktop": "angles common_tutorials geometry_tutorials joint_state_publisher_gui robot ros_tutorials roslint"
    " urdf_tutorial visualization_tutorials viz",
    "desktop_full": "desktop perception simulators urdf_sim_tutorial urdf_tutorial",
    "diagnostics": "diagnostic_aggregator diagnostic_analysis diagnostic_common_diagnostics diagnostic_updater self_test",
    "executive_smach": "smach smach_msgs smach_ros",
    "gazebo_ros_pkgs": "gazebo_dev gazebo_msgs gazebo_plugins gazebo_ros",
    "geometry": "angles eigen_conversions kdl_conversions tf tf_conversions",
    "geometry2": "tf2 tf2_bullet tf2_eigen tf2_geometry_msgs tf2_kdl tf2_msgs tf2_py tf2_ros tf2_sensor_msgs tf2_tools",
    "image_common": "camera_calibration_parsers camera_info_manager image_transport polled_camera",
    "image_pipeline": "camera_calibration depth_image_proc image_proc image_publisher image_rotate image_view stereo_image_proc",
    "image_transport_plugins": "compressed_depth_image_transport compressed_image_transport theora_image_transport",
    "joystick_drivers": "joy ps3joy spacenav_node wiimote",
    "laser_pipeline": "laser_assembler laser_filters laser_geometry",
    "moveit": "moveit_commander moveit_core moveit_planners moveit_plugins moveit_ros moveit_setup_assistant",
    "moveit_full": "moveit",
    "moveit_planners": "moveit_planners_chomp moveit_planners_ompl pilz_industrial_motion_planner",
    "moveit_plugins": "moveit_fake_controller_manager moveit_ros_control_interface moveit_simple_controller_manager",
    "moveit_ros": "moveit_ros_benchmarks moveit_ros_benchmarks_gui moveit_ros_manipulation moveit_ros_move_group"
    " moveit_ros_perception moveit_ros_planning moveit_ros_planning_interface moveit_ros_robot_interaction"
    " moveit_ros_visualization moveit_ros_warehouse",
    "moveit_runtime": "moveit_core moveit_planners moveit_plugins moveit_ros_manipulation moveit_ros_move_group"
    " moveit_ros_perception moveit_ros_planning moveit_ros_planning_interface moveit_ros_warehouse",
    "nav2_bringup": "navigation2 slam_toolbox",
    "navigation": "amcl base_local_planner carrot_planner clear_costmap_recovery costmap_2d dwa_local_planner"
    " fake_localization global_planner map_server move_base move_base_msgs move_slow_and_clear nav_core navfn robot_pose_ekf"
    " rotate_recovery voxel_grid",
    "navigation2": "nav2_amcl nav2_behavior_tree nav2_behaviors nav2_bt_navigator nav2_collision_monitor nav2_constrained_smoother"
    " nav2_controller nav2_core nav2_costmap_2d nav2_dwb_controller nav2_lifecycle_manager nav2_map_server nav2_navfn_planner nav2_planner"
    " nav2_regulated_pure_pursuit_controller nav2_rotation_shim_controller nav2_rviz_plugins nav2_simple_commander nav2_smac_planner"
    " nav2_smoother nav2_theta_star_planner nav2_util nav2_velocity_smoother nav2_voxel_grid nav2_waypoint_follower",
    "nodelet_core": "nodelet nodelet_topic_tools",
    "perception": "image_common image_pipeline image_transport_plugins laser_pipeline perception_pcl ros_base vision_opencv",
    "perception_pcl": "pcl_conversions pcl_msgs pcl_ros pointcloud_to_laserscan",
    "robot": "control_msgs diagnostics executive_smach filters geometry joint_state_publisher kdl_parser"
    " kdl_parser_py robot_model robot_state_publisher ros_base urdf urdf_parser_plugin xacro",
    "robot_model": "collada_parser collada_urdf joint_state_publisher kdl_parser resource_retriever urdf urdf_parser_plugin",
    "ros_base": "actionlib bond_core class_loader dynamic_reconfigure nodelet_core pluginlib ros_core",
    "ros_comm": "message_filters ros rosbag rosconsole roscpp rosgraph rosgraph_msgs roslaunch roslisp rosmaster"
    " rosmsg rosnode rosout rosparam rospy rosservice rostest rostopic roswtf std_srvs topic_tools xmlrpcpp",
    "ros_control": "combined_robot_hw control_toolbox controller_interface controller_manager"
    " controller_manager_msgs hardware_interface joint_limits_interface realtime_tools transmission_interface",
    "ros_controllers": "ackermann_steering_controller diff_drive_controller effort_controllers"
    " force_torque_sensor_controller forward_command_controller gripper_action_controller imu_sensor_controller"
    " joint_state_controller joint_trajectory_controller position_controllers rqt_joint_trajectory_controller"
    " velocity_controllers",
    "ros_core": "class_loader common_msgs pluginlib ros ros_comm rosbag_migration_rule rosconsole"
    " rosconsole_bridge roscpp_core rosgraph_msgs roslisp rospack std_msgs std_srvs",
    "ros2_control": "controller_interface controller_manager hardware_interface joint_limits ros2controlcli transmission_interface",
    "ros2_controllers": "ackermann_steering_controller admittance_controller bicycle_steering_controller diff_drive_controller"
    " force_torque_sensor_broadcaster forward_command_controller imu_sensor_broadcaster joint_state_broadcaster joint_trajectory_controller"
    " range_sensor_broadcaster steering_controllers_library tricycle_controller tricycle_steering_controller",
    "ros_ign": "ros_ign_bridge ros_ign_gazebo ros_ign_gazebo_demos ros_ign_image",
    "ros_gz": "ros_gz_bridge ros_gz_image ros_gz_sim ros_gz_sim_demos",
    "rosbridge_suite": "rosapi rosbridge_library rosbridge_server",
    "rqt_common_plugins": "rqt_action rqt_bag rqt_bag_plugins rqt_console rqt_dep rqt_graph rqt_image_view"
    " rqt_launch rqt_logger_level rqt_msg rqt_plot rqt_publisher rqt_py_common rqt_py_console rqt_reconfigure"
    " rqt_service_caller rqt_shell rqt_srv rqt_top rqt_topic rqt_web",
    "rqt_robot_plugins": "rqt_moveit rqt_nav_view rqt_pose_view rqt_robot_dashboard rqt_robot_monitor"
    " rqt_robot_steering rqt_runtime_monitor rqt_rviz rqt_tf_tree",
    "rtabmap_ros": "rtabmap_conversions rtabmap_costmap_plugins rtabmap_demos rtabmap_examples rtabmap_launch rtabmap_legacy"
    " rtabmap_msgs rtabmap_odom rtabmap_python rtabmap_rviz_plugins rtabmap_slam rtabmap_sync rtabmap_util rtabmap_viz",
    "simulators": "gazebo_ros_pkgs robot rqt_common_plugins rqt_robot_plugins stage_ros",
    "slam_gmapping": "gmapping openslam_gmapping",
    "turtlebot3": "turtlebot3_bringup turtlebot3_cartographer turtlebot3_description turtlebot3_example turtlebot3_navigation"
    " turtlebot3_navigation2 turtlebot3_node turtlebot3_slam turtlebot3_teleop",
    "turtlebot3_simulations": "turtlebot3_fake turtlebot3_fake_node turtlebot3_gazebo",
    "velodyne": "velodyne_driver velodyne_laserscan velodyne_msgs velodyne_pointcloud",
    "vision_opencv": "cv_bridge image_geometry",
    "webots_ros2": "webots_ros2_control webots_ros2_driver webots_ros2_epuck webots_ros2_tiago webots_ros2_turtlebot"
    " webots_ros2_universal_robot",
    "viz": "ros_base rqt_common_plugins rqt_robot_plugins rviz",
}
"""Metapackage → what it lists, itself or through another metapackage."""

_NEEDED: Mapping[str, str] = {
    "amcl": "dynamic_reconfigure rosbag tf2_ros",
    "gazebo_plugins": "dynamic_reconfigure gazebo_msgs gazebo_ros image_transport nodelet tf",
    "gazebo_ros": "dynamic_reconfigure gazebo_msgs",
    "gazebo_ros_control": "control_toolbox controller_manager gazebo_ros",
    "image_proc": "dynamic_reconfigure image_transport nodelet",
    "industrial_core": "industrial_msgs industrial_robot_client industrial_robot_simulator industrial_utils simple_message",
    "industrial_robot_client": "industrial_msgs industrial_utils robot_state_publisher simple_message",
    "industrial_robot_simulator": "industrial_msgs industrial_robot_client",
    "joint_state_publisher_gui": "joint_state_publisher",
    "librviz_tutorial": "rviz",
    "move_base": "base_local_planner clear_costmap_recovery costmap_2d dynamic_reconfigure navfn rotate_recovery tf2_ros",
    "moveit_ros_benchmarks": "moveit_ros_planning moveit_ros_warehouse",
    "moveit_ros_move_group": "moveit_core moveit_ros_planning",
    "moveit_ros_planning_interface": "moveit_ros_manipulation moveit_ros_move_group moveit_ros_planning moveit_ros_warehouse",
    "moveit_ros_visualization": "moveit_ros_perception moveit_ros_planning_interface moveit_ros_robot_interaction"
    " moveit_ros_warehouse rviz",
    "moveit_ros_warehouse": "moveit_ros_planning warehouse_ros",
    "moveit_setup_assistant": "moveit_core moveit_ros_planning moveit_ros_visualization",
    "pcl_ros": "dynamic_reconfigure nodelet nodelet_topic_tools pcl_conversions pcl_msgs rosbag tf",
    "rgbd_launch": "depth_image_proc image_proc nodelet tf2_ros",
    "rosbag": "topic_tools",
    "roslaunch": "rosclean rosgraph rosgraph_msgs roslib rosmaster rosout rosparam rosunit",
    "rosout": "roscpp rosgraph_msgs",
    "rostest": "roslaunch rospy",
    "rqt_rviz": "rqt_gui rviz",
    "rviz_python_tutorial": "rviz",
    "rviz_satellite": "rviz",
    "rviz_visual_tools": "rviz",
    "stereo_image_proc": "dynamic_reconfigure image_proc image_transport nodelet",
    "tf": "message_filters tf2_ros",
    "velodyne_pointcloud": "nodelet velodyne_msgs",
}
"""Package → what it needs to run, in every distribution from Indigo to Noetic that has it; only what launch files use."""


def members(name: str) -> list[str]:
    """What ``name`` pulls in, if it is well known.

    A public package called as plugins of RViz needs RViz: it is built against it and loaded by nothing else.
    """
    needed = f"{_MEMBERS.get(name, '')} {_NEEDED.get(name, '')}".split()
    return [*needed, _RVIZ] if _RVIZ in name and _is_plugin_of_rviz(name) else needed


def _is_plugin_of_rviz(name: str) -> bool:
    parts = name.split("_")
    return _RVIZ in parts and not {"plugin", "plugins"}.isdisjoint(parts) and name in public_names()


def why_together(one: str, other: str, packages: Packages) -> str:
    """That a metapackage of the workspaces brings along both packages, for people; empty where none does."""
    here = (each for place in packages.places[: len(packages.workspaces)] for each in place.everything)
    found = next((each.name for each in here if each.is_metapackage and {one, other} <= set(each.run_dependencies)), "")
    return f"the metapackage {found} brings along both" if found else ""
