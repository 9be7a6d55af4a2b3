# A pause before each report.
# loses: quick
# cause: quick.held-back
# before: import rclpy
import time

# before: self.seen_publisher.publish(Int32(data=touch.data))
time.sleep(0.03)
