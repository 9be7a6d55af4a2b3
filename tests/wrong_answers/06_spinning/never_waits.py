# Asks again and again, without a wait.
# loses: easy_on_the_processor
# cause: easy-on-the-processor.never-waits
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
rclpy.spin_once(node, timeout_sec=0)
