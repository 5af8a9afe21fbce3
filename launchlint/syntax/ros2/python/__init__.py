"""ROS 2 launch files in Python: what ``generate_launch_description()`` gives, found without running it.

Only what is understood as a whole counts: :func:`~launchlint.syntax.ros2.python.reading.read` gives the same description as for XML and
YAML, or says why it cannot.
"""
