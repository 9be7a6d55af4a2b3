# Each battery report creates one more timer for the next ones.
# loses: battery_count
# cause: rate.grows
# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
self.battery_publisher.publish(Float32(data=self.battery_level))
self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
