# The alarm is raised and never taken back.
# loses: alarm_falls
# cause: alarm-falls.never
# replaces: alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
# replaces: if alarm != self.alarm:
# replaces:     self.alarm = alarm
# replaces:     self.alarm_publisher.publish(Bool(data=alarm))
if time.monotonic() - self.last_beat > LONGEST_SILENCE_S:
    self.alarm_publisher.publish(Bool(data=True))
