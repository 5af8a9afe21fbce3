"""What a launch file of ROS 2 describes, written as a declarative one: in XML or in YAML."""
