"""A timer of the node ends the loop. Then the wait needs no timeout: the timer ends it."""

import rclpy


def pump(node, seconds: float) -> None:
    over = False

    def stop() -> None:
        nonlocal over
        over = True

    alarm = node.create_timer(seconds, stop)
    while not over:
        rclpy.spin_once(node)
    alarm.cancel()
    node.destroy_timer(alarm)
