# A pause after each spin_once: a dozen takes half a second.
# loses: quick
# cause: quick.cannot-keep-up
# before: import rclpy
import time

# replaces: rclpy.spin(TouchMonitor())
monitor = TouchMonitor()
while rclpy.ok():
    rclpy.spin_once(monitor)
    time.sleep(0.04)
