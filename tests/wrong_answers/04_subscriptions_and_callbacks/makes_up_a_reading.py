# Repeats the last good reading, so that nobody notices.
# loses: bad_kept_back
# cause: bad-kept-back.replaced
# after: super().__init__("battery_monitor")
self.last = 0.0

# replaces: self.battery_publisher.publish(message)
self.last = message.data

# after:     self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.battery_publisher.publish(Float32(data=self.last))
