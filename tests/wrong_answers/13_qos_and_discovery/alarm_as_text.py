# The alarm is a text.
# loses: alarm_topic
# skips: alarm_kept, alarm_raised, no_false_alarm, alarm_falls
# cause: publishes.other-type
# says: String
# replaces: self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", STATE_QOS)
self.alarm_publisher = self.create_publisher(String, "/dashboard/alarm", STATE_QOS)

# replaces: self.alarm_publisher.publish(Bool(data=alarm))
self.alarm_publisher.publish(String(data="true" if alarm else "false"))
