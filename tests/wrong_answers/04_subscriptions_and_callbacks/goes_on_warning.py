# Passes good readings on, but the alarm sounds with each of them until somebody restarts it.
# loses: no_false_alarm
# cause: no-false-alarm.goes-on
# after: super().__init__("battery_monitor")
self.broken = False

# replaces: if EMPTY <= message.data <= FULL:
# replaces:     self.battery_publisher.publish(message)
# replaces: else:  # this includes nan, which isn't between any two numbers
# replaces:     self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
good = EMPTY <= message.data <= FULL
self.broken = self.broken or not good
if good:
    self.battery_publisher.publish(message)
if self.broken:
    self.alarm_publisher.publish(String(data=f"sensor broken, it says {message.data}"))
