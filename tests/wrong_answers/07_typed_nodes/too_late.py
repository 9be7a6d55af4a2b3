# Checks the number when the message is on its way.
# loses: refuses_wrong_types
# cause: refusal.too-late
# says: 0.0
# before: if not isinstance(level, (int, float)):
message = Float32()
if isinstance(level, (int, float)):
    message.data = float(level)
self.battery_publisher.publish(message)

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
