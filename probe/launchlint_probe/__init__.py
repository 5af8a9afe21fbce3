"""The part of launchlint's probe that runs beside the nodes: in the container, or on a machine with ROS.

Standard library only, Python 3.6 or newer; ROS is used through its network protocols and its files, never imported.
"""
