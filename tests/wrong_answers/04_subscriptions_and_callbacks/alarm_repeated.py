# A timer repeats the alarm, so that nobody misses it.
# loses: one_alarm
# cause: one-alarm.repeated
# before: self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
self.fault = ""
self.create_timer(0.2, self.warn)

# before: def on_battery(self, message: Float32) -> None:
def warn(self) -> None:
    if self.fault:
        self.alarm_publisher.publish(String(data=self.fault))

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.fault = f"bad reading: {message.data}"
