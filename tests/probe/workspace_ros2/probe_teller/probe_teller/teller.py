import rclpy
from std_msgs.msg import String


def tell():
    rclpy.init()
    node = rclpy.create_node("teller")
    node.declare_parameter("volume", 3)
    node.create_publisher(String, "~/story", 10)
    node.create_subscription(String, "/silence", lambda message: None, 1)
    rclpy.spin(node)
