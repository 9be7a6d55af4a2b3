"""No main, no class: the night of a guard from top to bottom."""

import rclpy

rclpy.init()
guard = rclpy.create_node("night_guard")
guard.create_timer(0.5, lambda: guard.get_logger().info("all quiet"))
try:
    while rclpy.ok():
        rclpy.spin_once(guard, timeout_sec=0.5)
except KeyboardInterrupt:
    pass
print("Arms parked. Good night!")
guard.destroy_node()
rclpy.try_shutdown()
