"""The second dialect: launch files of ROS 2 in XML and YAML, read into what they describe."""
