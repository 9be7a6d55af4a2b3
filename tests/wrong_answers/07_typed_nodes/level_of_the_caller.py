# Keeps the charge that another program sends, and goes on with it by itself.
# loses: reports_as_before
# cause: reports-as-before.level-replaced
# before: self.battery_publisher.publish(Float32(data=float(level)))
self.level = float(level)
