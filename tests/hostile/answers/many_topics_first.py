# score: 10
"""More topics than are watched, made and published before those that are judged."""
import rclpy
from std_msgs.msg import String

_init = rclpy.init


def init(*arguments, **options):
    _init(*arguments, **options)
    node = rclpy.create_node("before_all_others")
    for number in range(70):
        publisher = node.create_publisher(String, f"/a/topic{number}", 1)
        publisher.publish(String(data="x"))
        node.create_service(__import__("std_srvs.srv").srv.Trigger, f"/a/service{number}", lambda _, reply: reply)
    HELD.append(node)


HELD = []
rclpy.init = init
@@GOOD@@
