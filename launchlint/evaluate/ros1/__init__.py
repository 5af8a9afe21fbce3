"""ROS 1: what roslaunch makes of a launch file, computed without running anything."""
