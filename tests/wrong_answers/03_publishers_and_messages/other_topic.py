# Leaves out the first half of the name.
# loses: battery_topic
# cause: publishes.no-namespace
# says: /robot
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher(Float32, "battery", 10)
