# Takes the driver for broken after three errors, and refuses all that follows.
# loses: floats_arrive, numbers_arrive
# also: zero_arrives
# cause: number.refused-later
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.errors = 0

# before: if isinstance(level, bool) or not isinstance(level, Real):
if self.errors >= 3:
    raise RuntimeError("the driver is broken")
self.errors += isinstance(level, (bool, str)) or not isinstance(level, Real)
