"""What rcl, the C library under every ROS 2 node, makes of a node's command line: names, remap rules, parameters.

Nothing here knows of launch files: words of a command line and texts of parameter files go in. Humble, jazzy and rolling agree on it.
"""
