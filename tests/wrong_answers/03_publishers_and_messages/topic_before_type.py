# The name first and then the type, as in ROS 1.
# loses: calls_come_back
# cause: error.topic-name-no-text
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher("/robot/battery", Float32, 10)
