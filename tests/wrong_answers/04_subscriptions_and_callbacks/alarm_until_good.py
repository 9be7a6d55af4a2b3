# A timer repeats the alarm each second until a good reading comes.
# loses: one_alarm
# cause: one-alarm.repeated
# after: super().__init__("battery_monitor")
self.fault: float | None = None
self.create_timer(1.0, self.warn_again)

# before: def on_battery(self, message: Float32) -> None:
def warn_again(self) -> None:
    if self.fault is not None:
        self.alarm_publisher.publish(String(data=f"bad reading: {self.fault}"))

# after: self.battery_publisher.publish(message)
self.fault = None

# after: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.fault = message.data
