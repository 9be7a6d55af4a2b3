# /tilt and not /robot/tilt.
# loses: tilt_topic
# skips: tilt_count
# cause: publishes.no-namespace
# says: /tilt
# replaces: self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", 10)
self.tilt_publisher = self.create_publisher(Float32, "/tilt", 10)
