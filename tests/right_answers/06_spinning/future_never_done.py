"""Waits for a future that nobody will ever complete; only the timeout ends it."""

import rclpy
from rclpy.node import Node
from rclpy.task import Future


def pump(node: Node, seconds: float) -> None:
    rclpy.spin_until_future_complete(node, Future(), timeout_sec=seconds)
