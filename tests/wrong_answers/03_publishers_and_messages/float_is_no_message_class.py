# Gives create_publisher a Python type.
# loses: calls_come_back
# cause: error.no-message-class
# says: type object 'type' has no attribute '_TYPE_SUPPORT'
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher(float, "/robot/battery", 10)

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(float(level))
