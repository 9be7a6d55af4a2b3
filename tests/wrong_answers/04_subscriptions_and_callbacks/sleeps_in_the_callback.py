# Writes each reading to a slow display first. With a queue of one, most of them are pushed out.
# loses: in_order, one_alarm
# cause: in-order.some-lost
# before: import rclpy
import time

# replaces: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.create_subscription(Float32, "/robot/battery", self.on_battery, 1)

# before: if EMPTY <= message.data <= FULL:
time.sleep(0.35)
