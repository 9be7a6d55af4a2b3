# Makes the node, and then waits for messages in a loop of its own.
# loses: passes_on, alarms_come
# skips: in_order, bad_kept_back, one_alarm, no_false_alarm, own_robot_only
# cause: in-order.nothing-passed-on
# before: import rclpy
import time

# replaces: rclpy.spin(BatteryMonitor())
monitor = BatteryMonitor()
while rclpy.ok():
    time.sleep(0.1)
monitor.destroy_node()
