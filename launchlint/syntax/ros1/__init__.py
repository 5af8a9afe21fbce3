"""The ROS 1 dialect: roslaunch's XML."""
