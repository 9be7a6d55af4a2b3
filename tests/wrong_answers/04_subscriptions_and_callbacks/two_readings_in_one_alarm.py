# Collects two bad readings for each alarm.
# loses: one_alarm
# cause: one-alarm.not-each
# after: super().__init__("battery_monitor")
self.bad: list[str] = []

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.bad.append(str(message.data))
if len(self.bad) == 2:
    self.alarm_publisher.publish(String(data="bad readings: " + ", ".join(self.bad)))
    self.bad.clear()
