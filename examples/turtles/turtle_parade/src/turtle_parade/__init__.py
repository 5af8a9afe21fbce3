"""What the three controllers of the parade share."""

import rospy
from geometry_msgs.msg import Twist

RATE = 10  # commands per second: turtlesim stops a turtle that has heard nothing for one second


def drive(name, topic, forward, turn=0.0):
    """Run node ``name`` until shutdown: on ``topic``, go ``forward`` (m/s) and ``turn`` (rad/s, to the left)."""
    rospy.init_node(name)
    command = Twist()
    command.linear.x = forward
    command.angular.z = turn
    publisher = rospy.Publisher(topic, Twist, queue_size=1)
    rate = rospy.Rate(RATE)
    try:
        while not rospy.is_shutdown():
            publisher.publish(command)
            rate.sleep()
    except rospy.ROSInterruptException:
        pass  # roslaunch asked us to stop while we slept
