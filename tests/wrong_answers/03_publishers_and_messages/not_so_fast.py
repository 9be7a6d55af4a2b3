# Drops a number that comes within 30 ms of the one before.
# loses: floats_arrive
# also: zero_arrives, numbers_arrive
# cause: number.dropped-soon-after
# says: published: nothing
# after: import math
import time

# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.last_time = -1.0

# before: self.battery_publisher.publish(Float32(data=float(level)))
passed, self.last_time = time.monotonic() - self.last_time, time.monotonic()
if passed < 0.03:
    return
