# Waits only for a node without timers, and polls where a timer may be due soon.
# loses: easy_on_the_processor
# cause: easy-on-the-processor.polls-with-timers
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
rclpy.spin_once(node, timeout_sec=0 if any(node.timers) else min(left, TURN_S))
