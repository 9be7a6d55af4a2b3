# Raises alarms for the other robot, too.
# loses: own_robot_only
# cause: own-robot-only.hears-others
# after: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.create_subscription(Float32, "/other_robot/battery", self.on_other, 10)

# before: def on_battery(self, message: Float32) -> None:
def on_other(self, message: Float32) -> None:
    if not EMPTY <= message.data <= FULL:
        self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
