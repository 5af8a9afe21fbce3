"""Rules about launch files of ROS 2 that are programs: what launch stops for with an error of Python, and what Python does not notice."""
