# A latched topic, as rospy makes one.
# loses: program_runs
# cause: error.ros-1-keyword
# says: 'latch'
# says: TRANSIENT_LOCAL
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10, latch=True)
