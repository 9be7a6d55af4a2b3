"""No class: a node, a publisher and a function."""

import rclpy
from std_msgs.msg import Int32

rclpy.init()
node = rclpy.create_node("touch_monitor")
seen = node.create_publisher(Int32, "/monitor/seen", 100)


def on_touch(touch):
    seen.publish(touch)
    node.get_logger().info(f"touch {touch.data}")


node.create_subscription(Int32, "/robot/touch", on_touch, 100)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
rclpy.try_shutdown()
