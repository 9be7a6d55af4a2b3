# The alarm names the reading that came before the bad one.
# loses: one_alarm
# cause: one-alarm.names-another-reading
# after: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.latest = 0.0

# before: if EMPTY <= message.data <= FULL:
before, self.latest = self.latest, message.data

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.alarm_publisher.publish(String(data=f"bad reading: {before}"))
