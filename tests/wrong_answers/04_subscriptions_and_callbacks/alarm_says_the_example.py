# Each alarm says the value that the task prints.
# loses: one_alarm
# cause: one-alarm.names-another-reading
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.alarm_publisher.publish(String(data="bad reading: -3.0"))
