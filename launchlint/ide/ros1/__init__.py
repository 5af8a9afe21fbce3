"""What stands in launch files of ROS 1: who means which arg, package, file or name."""
