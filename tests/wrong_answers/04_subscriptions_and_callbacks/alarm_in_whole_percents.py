# The alarm rounds its value: 100.125 becomes 100.
# loses: one_alarm
# cause: one-alarm.value-rounded
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.alarm_publisher.publish(String(data=f"bad reading: {message.data:.0f}"))
