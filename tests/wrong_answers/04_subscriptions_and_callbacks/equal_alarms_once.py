# Raises no second alarm for a value that it has complained about before.
# loses: one_alarm
# cause: one-alarm.equal-once
# after: super().__init__("battery_monitor")
self.said: set[str] = set()

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
if str(message.data) not in self.said:
    self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.said.add(str(message.data))
