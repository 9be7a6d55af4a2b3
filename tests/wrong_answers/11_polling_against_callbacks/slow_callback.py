# The callback works for a fifth of a second on each touch, and the queue holds five.
# loses: none_missed, quick
# cause: none-missed.cannot-keep-up
# before: import rclpy
import time

# replaces: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
self.create_subscription(Int32, "/robot/touch", self.on_touch, 5)

# before: self.seen_publisher.publish(Int32(data=touch.data))
time.sleep(0.2)  # compute how hard it was
