# Raises an alarm for the first bad reading only.
# loses: one_alarm
# cause: one-alarm.first-only
# after: super().__init__("battery_monitor")
self.raised = False

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
if not self.raised:
    self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.raised = True
