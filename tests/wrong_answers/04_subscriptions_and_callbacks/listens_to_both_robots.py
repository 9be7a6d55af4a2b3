# Two subscriptions, one for each robot in the hall.
# loses: own_robot_only
# cause: own-robot-only.hears-others
# after: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.create_subscription(Float32, "/other_robot/battery", self.on_battery, 10)
