# Gives the all-clear on the topic of the alarms, without a number.
# loses: no_false_alarm
# cause: no-false-alarm.names-no-reading
# after: super().__init__("battery_monitor")
self.bad = False

# after: self.battery_publisher.publish(message)
if self.bad:
    self.alarm_publisher.publish(String(data="all clear"))
self.bad = False

# after: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.bad = True
