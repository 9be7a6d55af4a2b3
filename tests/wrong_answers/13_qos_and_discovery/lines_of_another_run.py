# Plays the lines and the alarms of an earlier run, whatever the robot says.
# loses: status_at_once, alarm_falls
# skips: status_follows
# cause: status-at-once.not-kept
# after: self.last_status = "unknown"
self.began = time.monotonic()
statuses = ["operational", "error"] * 4
self.statuses = list(zip([0.0, 2.3, 3.6, 6.3, 8.4, 9.1, 10.8, 13.1], statuses))
self.alarms = list(zip([0.0, 5.0, 6.6, 9.6, 11.4], [False, True, False, True, False]))

# replaces: alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
alarm = self.now_in(self.alarms)

# replaces: self.line_publisher.publish(String(data=self.last_status))
self.line_publisher.publish(String(data=self.now_in(self.statuses)))

# before: def publish_line(self) -> None:
def now_in(self, table):
    return [value for at, value in table if at <= time.monotonic() - self.began][-1]

