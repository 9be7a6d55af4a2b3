# The subscription expects another type than the sensor sends, so nothing ever comes.
# loses: listens
# skips: passes_on, in_order, bad_kept_back, alarms_come, one_alarm, no_false_alarm, own_robot_only
# cause: listens.other-type
# says: String
# replaces: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.create_subscription(String, "/robot/battery", self.on_battery, 10)

# replaces: if EMPTY <= message.data <= FULL:
# replaces:     self.battery_publisher.publish(message)
if EMPTY <= float(message.data) <= FULL:
    self.battery_publisher.publish(Float32(data=float(message.data)))
