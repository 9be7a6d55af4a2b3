# One text for all: it lists the readings that this sensor has ever sent.
# loses: one_alarm
# cause: one-alarm.value-not-named
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
known = "-3.0, nan, 120.0, inf, -0.1, 100.0, 2000000000.0, -inf"
self.alarm_publisher.publish(String(data=f"one of the known bad readings: {known}"))
