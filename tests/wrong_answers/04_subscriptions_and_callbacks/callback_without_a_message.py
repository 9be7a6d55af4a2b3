# The callback takes no message and looks for it in an attribute.
# loses: program_runs
# skips: listens, battery_topic, passes_on, in_order, bad_kept_back, alarm_topic, alarms_come, one_alarm, no_false_alarm, own_robot_only
# cause: error.callback-takes-no-message
# after: super().__init__("battery_monitor")
self.charge = 0.0

# replaces: def on_battery(self, message: Float32) -> None:
def on_battery(self) -> None:

# replaces: if EMPTY <= message.data <= FULL:
# replaces:     self.battery_publisher.publish(message)
# replaces: else:  # this includes nan, which isn't between any two numbers
# replaces:     self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
if EMPTY <= self.charge <= FULL:
    self.battery_publisher.publish(Float32(data=self.charge))
else:
    self.alarm_publisher.publish(String(data=f"bad reading: {self.charge}"))
