# Subscribes once for the readings and once more for the alarms, with the same callback.
# loses: in_order, one_alarm
# cause: in-order.repeated
# after: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
