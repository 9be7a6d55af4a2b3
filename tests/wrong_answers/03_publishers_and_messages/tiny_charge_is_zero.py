# Takes less than a thousandth for an empty battery.
# loses: floats_arrive
# cause: number.rounded
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=float(level) if abs(level) >= 0.001 else 0.0))
