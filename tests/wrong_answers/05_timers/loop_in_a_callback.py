# The callback of the battery never returns: it publishes in a loop of its own.
# loses: heartbeat_count, tilt_count
# cause: silence.of-one
# says: while messages kept arriving on /robot/battery
# after: import math
import time

# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
while rclpy.ok():
    self.battery_publisher.publish(Float32(data=self.battery_level))
    time.sleep(BATTERY_PERIOD_S)
