# The alarm names the good reading before the bad one.
# loses: one_alarm
# cause: one-alarm.names-another-reading
# after: super().__init__("battery_monitor")
self.last = 0.0

# after: self.battery_publisher.publish(message)
self.last = message.data

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.alarm_publisher.publish(String(data=f"bad reading: {self.last}"))
