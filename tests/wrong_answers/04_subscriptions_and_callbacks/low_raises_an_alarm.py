# Passes everything on as it should, and adds a warning of its own to the alarms.
# loses: no_false_alarm
# cause: no-false-alarm.low-charge
# after: self.battery_publisher.publish(message)
if message.data < 20.0:
    self.alarm_publisher.publish(String(data=f"battery low: {message.data} %"))
