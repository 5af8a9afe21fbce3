"""Running nodes to see what they publish, subscribe, serve, call and read: the host's side of ``launchlint probe``.

What runs beside the nodes, in a container or on a machine with ROS, is the program in ``probe/`` at the top of the source tree. The two
talk in
lines of JSON, and this side trusts none of them.
"""
