# The keyword of rospy: a line from a tutorial for ROS 1.
# loses: program_runs
# cause: error.ros-1-keyword
# says: 'queue_size'
# replaces: self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", 10)
self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", queue_size=10)
