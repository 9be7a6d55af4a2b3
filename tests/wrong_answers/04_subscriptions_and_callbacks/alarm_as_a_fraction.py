# The alarm gives the value as a fraction of one.
# loses: one_alarm
# cause: one-alarm.value-divided
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.alarm_publisher.publish(String(data=f"bad reading: {message.data / 100.0}"))
