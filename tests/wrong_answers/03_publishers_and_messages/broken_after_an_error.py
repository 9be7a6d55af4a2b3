# Remembers that it was broken, and stays so.
# loses: floats_arrive, zero_arrives, numbers_arrive
# cause: number.refused-later
# says: RuntimeError: the battery is broken
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.broken = False

# before: if isinstance(level, bool) or not isinstance(level, Real):
if self.broken:
    raise RuntimeError("the battery is broken")
self.broken = True

# after: self.battery_publisher.publish(Float32(data=float(level)))
self.broken = False
