"""What never talks: packages of the ROS index, and namespaces, whose classes and functions make no name of a node by themselves.

Given a node handle, even these may; ``ros/models.py`` says so of some of their classes, and it is looked at first. What stands in neither
table, and comes with a header of a ROS package that is not here, may talk.
"""

from __future__ import annotations

_ROS = """
    ros roscpp roslib rospack rostime rosconsole cpp_common roscpp_serialization roscpp_traits roscpp_tutorials xmlrpcpp message_filters
    message_runtime message_generation std_srvs rosbag_storage catkin genmsg gencpp topic_tools
"""
"""The client library: its classes that talk are known one by one."""

_ROS2 = """
    rclcpp rclcpp_action rclcpp_components rclcpp_lifecycle rcl rcl_action rcl_lifecycle rcl_yaml_param_parser rcl_logging_interface
    rmw rmw_implementation rmw_dds_common rcutils rcpputils ament_index_cpp rosidl_runtime_cpp rosidl_runtime_c rosidl_typesupport_cpp
    rosidl_typesupport_introspection_cpp rosidl_dynamic_typesupport rosidl_generator_cpp builtin_interfaces libstatistics_collector
    tracetools camera_info_manager rosbag2_cpp rosbag2_storage rosbag2_compression nav2_core nav2_util nav2 nav2_common
    nav2_behavior_tree behaviortree_cpp behaviortree_cpp_v3 backward_ros parameter_traits rsl tcb_span tl_expected keyboard_handler
    composition_interfaces tf2_ros tinyxml2_vendor
"""
"""The client library of ROS 2 and what belongs to it: its classes that talk are known one by one."""

_MATHEMATICS = """
    angles tf2 tf2_geometry_msgs tf2_eigen tf2_kdl tf2_sensor_msgs tf2_bullet tf_conversions eigen_conversions eigen_stl_containers
    kdl_conversions kdl_parser orocos_kdl kdl bfl random_numbers geodesy geographic_info geometric_shapes trac_ik sophus
    laser_geometry image_geometry convex_decomposition ecl nlopt osqp ifopt towr ruckig toppra
    reflexxes_type2 libreflexxestype2 eigenpy pinocchio
    fcl hpp_fcl ompl gtsam g2o libg2o ceres ceres_solver proxsuite rbdl rdl sbpl bullet csm libcsm
"""

_DATA = """
    sensor_msgs pcl_conversions pcl pcl_ros cv_bridge vision_opencv opencv opencv2 opencv3 octomap octomap_msgs octomap_ros grid_map
    grid_map_core grid_map_cv grid_map_octomap grid_map_sdf grid_map_costmap_2d grid_map_ros camera_calibration_parsers resource_retriever
    urdf urdf_parser_plugin urdfdom srdfdom collada_parser collada_urdf mavlink libmavconn flatbuffers flann libpointmatcher libnabo
    libsiftfast pugixml yaml_cpp xmlrpc variant variant_topic_tools ros_type_introspection rosbag_direct_write rosbag actionlib
    image_transport
"""

_HARDWARE = """
    hardware_interface joint_limits_interface transmission_interface controller_interface combined_robot_hw serial soem librealsense
    librealsense2 libfreenect libuvc libcaer libcamera libfranka librms libphidget21 libphidget22 libphidgets libmodbus libntcan libpcan
    libdlib libcreate libsegwayrmp libqsopt lusb kni ueye dynamixel_sdk socketcan_interface can_msgs log4cpp um6 apriltag apriltags vrpn
    ypspur depthai cnpy nanomsg ifm3d ifm3d_core simple_message assimp grpc draco libccd pangolin lms1xx
"""

_FRAMES_OF_PLUGINS = """
    nodelet pluginlib class_loader nav_core nav_core2 base_local_planner_interface mbf_abstract_core mbf_costmap_core rviz rqt_gui_cpp
    qt_gui_cpp controller_manager filters nodelet_topic_tools tf tf2_ros dynamic_reconfigure diagnostic_updater camera_info_manager
    interactive_markers realtime_tools self_test driver_base bond laser_proc control_toolbox moveit_core
"""
"""Their classes that talk are known one by one; the rest are interfaces and data."""

PACKAGES = frozenset(f"{_ROS} {_ROS2} {_MATHEMATICS} {_DATA} {_HARDWARE} {_FRAMES_OF_PLUGINS}".split())
"""Packages of which nothing talks but what is known here."""

NAMESPACES = frozenset(
    """
    std boost Eigen cv pcl Ui YAML KDL ros fcl ompl gtsam ceres g2o Sophus sophus rbdl google absl fmt nlohmann Json json tinyxml2 rapidjson
    rs2 rs asio zmq grpc protobuf gazebo ignition sdf QtCore QtGui Qt osg Ogre CGAL tbb torch caffe cuda thrust lcm spdlog serial octomap
    grid_map shapes bodies urdf srdf XmlRpc Poco CLI cxxopts moodycamel nanoflann Assimp tensorflow nvinfer1 ifm3d industrial
    mavros::utils mavros::ftf mavconn testing Catch
    costmap_2d::Costmap2D costmap_2d::Observation costmap_2d::MapLocation base_local_planner::CostmapModel
    base_local_planner::Trajectory base_local_planner::WorldModel base_local_planner::FootprintHelper
    moveit::core moveit::tools moveit::cpp robot_state robot_model robot_trajectory planning_scene planning_interface collision_detection
    kinematic_constraints kinematics trajectory_processing kinematics_metrics dynamics_solver distance_field constraint_samplers
    """.split()
)
"""Namespaces and classes of libraries, whatever their headers are called; those of MoveIt are of moveit_core."""

BASES = frozenset(
    """
    nodelet::Nodelet Nodelet nodelet_topic_tools::NodeletLazy hardware_interface::RobotHW hardware_interface::RobotHWSim rviz::Display
    rviz::Panel rviz::Tool rviz::ViewController rqt_gui_cpp::Plugin diagnostic_updater::DiagnosticTask TSingleton testing::Test
    testing::TestWithParam testing::Environment testing::TestEventListener testing::EmptyTestEventListener
    """.split()
)
"""Base classes whose constructors make no name."""
