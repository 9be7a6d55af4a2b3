# Keeps nan back, and raises no alarm.
# loses: one_alarm
# cause: one-alarm.missed
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
if message.data == message.data:
    self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
