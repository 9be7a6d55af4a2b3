# Takes one message and believes that this was it; then it goes on with something else.
# loses: in_order, alarms_come
# skips: one_alarm, no_false_alarm
# cause: in-order.stops
# before: import rclpy
import time

# after: super().__init__("battery_monitor")
self.heard = 0

# before: if EMPTY <= message.data <= FULL:
self.heard += 1

# replaces: rclpy.spin(BatteryMonitor())
monitor = BatteryMonitor()
while not monitor.heard:
    rclpy.spin_once(monitor, timeout_sec=0.1)
while rclpy.ok():
    time.sleep(0.1)
