# The loop spins once, then sleeps: one message each time.
# loses: none_missed, quick
# cause: none-missed.cannot-keep-up
# before: import rclpy
import time

# replaces: rclpy.spin(TouchMonitor())
monitor = TouchMonitor()
while rclpy.ok():
    rclpy.spin_once(monitor, timeout_sec=0.1)
    time.sleep(0.2)
