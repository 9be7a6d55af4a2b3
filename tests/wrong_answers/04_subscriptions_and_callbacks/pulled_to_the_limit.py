# Pulls a bad reading to the limit and passes it on, with an alarm.
# loses: bad_kept_back
# cause: bad-kept-back.clamped
# after: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.battery_publisher.publish(Float32(data=EMPTY if message.data < EMPTY else FULL))
