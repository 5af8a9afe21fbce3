"""What stands in launch files of ROS 2, in XML, YAML and Python: who means which arg, package or file."""
