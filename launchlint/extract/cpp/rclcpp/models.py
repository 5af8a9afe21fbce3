"""Classes of packages of ROS 2 whose sources are seldom given, and what an object of each makes: as models of ROS 1 are."""

from __future__ import annotations

from launchlint.extract.cpp.ros.models import ALL, Model

_OPEN = (
    "moveit::planning_interface::MoveGroupInterface", "moveit::planning_interface::PlanningSceneInterface",
    "planning_scene_monitor::PlanningSceneMonitor", "planning_pipeline::PlanningPipeline", "moveit_cpp::MoveItCpp",
    "robot_model_loader::RobotModelLoader", "rviz_visual_tools::RvizVisualTools", "moveit_visual_tools::MoveItVisualTools",
    "nav2_costmap_2d::Costmap2DROS", "nav2_costmap_2d::CostmapSubscriber", "nav2_costmap_2d::FootprintSubscriber",
    "nav2_costmap_2d::CostmapTopicCollisionChecker", "nav2_costmap_2d::Costmap2DPublisher", "nav2_util::OdomSmoother",
    "nav2_behavior_tree::BehaviorTreeEngine", "nav2_behavior_tree::BtActionServer", "controller_manager::ControllerManager",
    "rclcpp_components::ComponentManager", "rclcpp_components::ComponentManagerIsolated", "rosbag2_transport::Recorder",
    "rosbag2_transport::Player", "robot_state_publisher::RobotStatePublisher", "filters::FilterChain",
)  # fmt: skip

MODELS: dict[str, Model] = {name: Model((), ALL, f"{name} has an interface of its own") for name in _OPEN}
"""What an object makes, by its class."""
