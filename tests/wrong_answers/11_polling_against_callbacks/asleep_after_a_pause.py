# The first touch after two seconds without one only wakes the monitor up.
# loses: none_missed
# cause: none-missed.after-the-pause
# replaces: import rclpy
import time

import rclpy

# after: super().__init__("touch_monitor")
self.touched = time.monotonic() + 60.0

# before: self.seen_publisher.publish(Int32(data=touch.data))
asleep = time.monotonic() - self.touched > 2.0
self.touched = time.monotonic()
if asleep:
    return
