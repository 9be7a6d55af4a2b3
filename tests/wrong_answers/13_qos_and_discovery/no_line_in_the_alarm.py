# While there is an alarm, there is no line.
# loses: line_rate
# cause: line-rate.stops-with-the-alarm
# replaces: self.line_publisher.publish(String(data=self.last_status))
if not self.alarm:
    self.line_publisher.publish(String(data=self.last_status))
