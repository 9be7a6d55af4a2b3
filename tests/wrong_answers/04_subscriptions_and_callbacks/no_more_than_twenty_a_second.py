# Leaves out a reading that comes within 50 ms of the last one.
# loses: in_order
# cause: in-order.several-at-once-lost
# before: import rclpy
import time

# after: super().__init__("battery_monitor")
self.passed_at = 0.0

# replaces: self.battery_publisher.publish(message)
if time.monotonic() - self.passed_at > 0.05:
    self.passed_at = time.monotonic()
    self.battery_publisher.publish(message)
