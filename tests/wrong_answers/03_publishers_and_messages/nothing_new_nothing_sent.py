# Does not send a number that is equal to the last one.
# loses: floats_arrive, zero_arrives, numbers_arrive
# cause: number.repeat-dropped
# says: published: nothing
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.last = -1.0

# before: self.battery_publisher.publish(Float32(data=float(level)))
if float(level) == self.last:
    return
self.last = float(level)
