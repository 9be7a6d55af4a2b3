# Reading the battery takes 0.35 s, and the tilt has to wait.
# loses: tilt_count
# cause: rate.silence, rate.skips
# after: import math
import time

# after: self.battery_publisher.publish(Float32(data=self.battery_level))
time.sleep(0.35)
