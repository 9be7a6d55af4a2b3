# Does not trust the first number after a wrong type.
# loses: floats_arrive, zero_arrives, numbers_arrive
# cause: number.dropped-after-error
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.doubtful = False

# replaces: raise TypeError(f"a charge is a number, not {level!r}")
self.doubtful = True
raise TypeError(f"a charge is a number, not {level!r}")

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
if not self.doubtful:
    self.battery_publisher.publish(Float32(data=float(level)))
self.doubtful = False
