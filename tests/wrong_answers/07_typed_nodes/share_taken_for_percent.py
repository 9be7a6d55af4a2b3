# Takes a charge up to 1 for a share, and sends it as percent.
# loses: numbers_arrive
# cause: numbers-arrive.share
# before: self.battery_publisher.publish(Float32(data=float(level)))
if 0.0 < level <= 1.0:
    level *= 100.0
