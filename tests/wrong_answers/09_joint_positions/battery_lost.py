# The battery made room for the joints.
# loses: battery_kept
# cause: publishes.nothing
# says: /robot/battery
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

# replaces: self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
