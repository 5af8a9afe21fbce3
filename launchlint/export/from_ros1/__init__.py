"""A launch file of ROS 1 as one of ROS 2, as far as what it means has a counterpart there."""
