# Drops a reading of minus infinity without an alarm.
# loses: one_alarm
# cause: one-alarm.infinite-missed
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
if message.data != float("-inf"):
    self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
