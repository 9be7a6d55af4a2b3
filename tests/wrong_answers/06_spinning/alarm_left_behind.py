# loses: slow_callbacks, quiet_node, nothing_left_running
# cause: in-time.ended-by-what-was-left
"""The timer that ends the call is still there in the next one."""

import rclpy

state = {"over": False}


def pump(node, seconds):
    state["over"] = False
    node.create_timer(seconds, lambda: state.update(over=True))
    while not state["over"]:
        rclpy.spin_once(node)
