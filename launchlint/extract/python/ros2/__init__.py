"""rclpy: what Python programs of ROS 2 make and ask for, recognised on the machinery that follows those of rospy.

:func:`~launchlint.extract.python.ros2.program.rclpy_program` is the way in. :mod:`.api` is what nodes can do, :mod:`.params` and
:mod:`.qos` are the values that it takes, :mod:`.libraries` the packages that are given a node, :mod:`.nodes` the nodes that were made.
"""
