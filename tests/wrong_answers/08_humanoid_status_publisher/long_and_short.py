# The timer of the battery is made anew each time, with a long and a short period in turn.
# loses: battery_rate
# cause: rate.uneven
# after: self.battery_level = 100.0
self.long = False

# after: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
self.long = not self.long
self.destroy_timer(self.battery_timer)
self.battery_timer = self.create_timer(3.2 if self.long else 0.8, self.publish_battery)
