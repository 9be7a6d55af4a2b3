# Whoever comes later does not hear of the alarm.
# loses: alarm_kept
# cause: kept-for-latecomers.volatile
# replaces: self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", STATE_QOS)
self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", 10)
