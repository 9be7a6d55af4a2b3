# Parentheses behind the callback: Python calls it at once.
# loses: program_runs
# skips: listens, battery_topic, passes_on, in_order, bad_kept_back, alarm_topic, alarms_come, one_alarm, no_false_alarm, own_robot_only
# cause: error.missing-argument
# replaces: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.create_subscription(Float32, "/robot/battery", self.on_battery(), 10)
