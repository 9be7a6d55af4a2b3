# Says when the bad readings are over, on the topic of the alarms.
# loses: no_false_alarm
# cause: no-false-alarm.names-an-earlier-one
# after: super().__init__("battery_monitor")
self.bad: float | None = None

# after: self.battery_publisher.publish(message)
if self.bad is not None:
    self.alarm_publisher.publish(String(data=f"readings are good again after {self.bad}"))
self.bad = None

# after: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.bad = message.data
