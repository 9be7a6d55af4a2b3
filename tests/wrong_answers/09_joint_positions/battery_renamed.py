# The battery got a longer name.
# loses: battery_kept
# cause: publishes.other-name
# says: /robot/battery_level
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher(Float32, "/robot/battery_level", 10)
