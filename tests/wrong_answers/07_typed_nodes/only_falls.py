# Refuses a number that is higher than its own charge.
# loses: numbers_arrive
# cause: numbers-arrive.check-too-strict
# says: send_battery(99.
# before: self.battery_publisher.publish(Float32(data=float(level)))
if level > self.level:
    raise ValueError("this battery is not being charged")
