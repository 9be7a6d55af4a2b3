# Makes the publisher of the alarm when there is an alarm. Nobody has found it by then.
# loses: one_alarm
# cause: one-alarm.publisher-made-late
# replaces: self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
if not hasattr(self, "alarm_publisher"):
    self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
