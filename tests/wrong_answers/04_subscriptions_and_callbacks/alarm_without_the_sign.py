# The alarm gives the value without its sign.
# loses: one_alarm
# cause: one-alarm.sign-lost
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.alarm_publisher.publish(String(data=f"bad reading: {abs(message.data)}"))
