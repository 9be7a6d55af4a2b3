# Leaves out the last argument of create_publisher.
# loses: calls_come_back
# cause: error.no-qos
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher(Float32, "/robot/battery")
