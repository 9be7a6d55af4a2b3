# A callback, but the subscription holds only one touch, and each report is written to a slow log first.
# loses: none_missed
# cause: none-missed.came-together
# before: import rclpy
import time

# replaces: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
self.create_subscription(Int32, "/robot/touch", self.on_touch, 1)

# before: self.seen_publisher.publish(Int32(data=touch.data))
time.sleep(0.002)  # the log
