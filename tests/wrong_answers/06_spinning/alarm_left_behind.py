# loses: again
# skips: slow_callbacks, quiet_node
# says: Something of the first call is still there
"""The timer that ends the call is still there in the next one."""

import rclpy

state = {"over": False}


def pump(node, seconds):
    state["over"] = False
    node.create_timer(seconds, lambda: state.update(over=True))
    while not state["over"]:
        rclpy.spin_once(node)
