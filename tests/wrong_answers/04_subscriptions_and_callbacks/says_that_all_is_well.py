# Says ok on the topic of the alarms for each good reading.
# loses: no_false_alarm
# cause: no-false-alarm.every-reading
# after: self.battery_publisher.publish(message)
self.alarm_publisher.publish(String(data="ok"))
