# Waits in the callback until the heart beats again.
# loses: line_rate, alarm_falls
# cause: line-rate.stops-with-the-alarm
# replaces: alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
# replaces: if alarm != self.alarm:
# replaces:     self.alarm = alarm
# replaces:     self.alarm_publisher.publish(Bool(data=alarm))
if time.monotonic() - self.last_beat > LONGEST_SILENCE_S:
    self.publish_line()
while time.monotonic() - self.last_beat > LONGEST_SILENCE_S:
    self.alarm_publisher.publish(Bool(data=True))
    time.sleep(0.2)
self.alarm_publisher.publish(Bool(data=False))
