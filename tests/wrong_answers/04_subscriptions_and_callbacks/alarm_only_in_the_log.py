# Tells its log, which no other node reads.
# loses: alarm_topic
# skips: alarms_come, one_alarm, no_false_alarm
# cause: publishes.nothing
# says: /monitor/alarm
# replaces: self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.get_logger().error(f"bad reading: {message.data}")
