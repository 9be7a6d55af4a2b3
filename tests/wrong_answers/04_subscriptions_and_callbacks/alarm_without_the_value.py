# An alarm that does not say what it is about.
# loses: one_alarm
# cause: one-alarm.value-not-named
# says: "check the battery cable!"
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.alarm_publisher.publish(String(data="check the battery cable!"))
