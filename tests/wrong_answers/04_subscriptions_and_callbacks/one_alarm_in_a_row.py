# Raises one alarm for several bad readings in a row.
# loses: one_alarm
# cause: one-alarm.one-in-a-row
# after: super().__init__("battery_monitor")
self.last_was_bad = False

# after: self.battery_publisher.publish(message)
self.last_was_bad = False

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
if not self.last_was_bad:
    self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.last_was_bad = True
