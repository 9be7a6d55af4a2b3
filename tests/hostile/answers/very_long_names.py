# score: 10
"""Nodes, topics and parameters with names as long as there may be."""
import rclpy
from std_msgs.msg import String

_init = rclpy.init


def init(*arguments, **options):
    _init(*arguments, **options)
    for number in range(10):
        node = rclpy.create_node(f"{'n' * 90}{number}", namespace="/" + "/".join("s" * 30 for _ in range(3)))
        node.create_publisher(String, f"{'t' * 140}{number}", 1).publish(String(data="x" * 10_000))
        node.declare_parameter("p" * 5_000, "v" * 50_000)
        HELD.append(node)


HELD = []
rclpy.init = init
@@GOOD@@
