"""The node's own clock says when the time is up."""

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node


class Pump:
    """Pumps one node."""

    def __init__(self, node: Node) -> None:
        self.node = node

    def until(self, end) -> None:
        while self.node.get_clock().now() < end:
            left = (end - self.node.get_clock().now()).nanoseconds / 1e9
            rclpy.spin_once(self.node, timeout_sec=max(0.0, left))


def pump(node: Node, seconds: float) -> None:
    Pump(node).until(node.get_clock().now() + Duration(seconds=seconds))
