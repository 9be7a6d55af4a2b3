# The right callback, on the wrong robot.
# loses: listens
# skips: passes_on, in_order, bad_kept_back, alarms_come, one_alarm, no_false_alarm, own_robot_only
# cause: listens.other-name
# says: /other_robot/battery
# replaces: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.create_subscription(Float32, "/other_robot/battery", self.on_battery, 10)
