# A letter is missing in the name of the topic.
# loses: reports_as_before, numbers_arrive
# cause: publishes.other-name
# says: /robot/batery
# replaces: self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
self.battery_publisher = make_publisher(self, Float32, "/robot/batery")
