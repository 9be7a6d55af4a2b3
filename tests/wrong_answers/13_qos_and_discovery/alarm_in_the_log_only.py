# Logs the alarm and publishes nothing.
# loses: alarm_topic
# skips: alarm_kept, alarm_raised, no_false_alarm, alarm_falls
# cause: publishes.nothing
# replaces: self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", STATE_QOS)

# replaces: self.alarm_publisher.publish(Bool(data=alarm))
self.get_logger().warning(f"alarm: {alarm}")
