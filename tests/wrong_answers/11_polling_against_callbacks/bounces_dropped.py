# A touch that comes soon after another one is taken for a bounce.
# loses: none_missed
# cause: none-missed.came-together
# before: import rclpy
import time

# after: super().__init__("touch_monitor")
self.last = 0.0

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
if time.monotonic() - self.last > 0.05:
    self.seen_publisher.publish(Int32(data=touch.data))
self.last = time.monotonic()
