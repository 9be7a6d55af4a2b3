"""A timer completes a future when the time is up."""

import rclpy
from rclpy.node import Node
from rclpy.task import Future


def pump(node: Node, seconds: float) -> None:
    over = Future()

    def time_is_up() -> None:
        if not over.done():
            over.set_result(None)

    alarm = node.create_timer(seconds, time_is_up)
    try:
        rclpy.spin_until_future_complete(node, over)
    finally:
        node.destroy_timer(alarm)
