# The node spins itself in __init__, before two of its timers are created.
# loses: battery_count, tilt_count
# cause: spin.before-the-rest
# replaces: self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
rclpy.spin(self)
self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
