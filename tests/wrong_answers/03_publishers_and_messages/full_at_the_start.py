# Reports a full battery when the node is made, though nothing was measured.
# loses: floats_arrive
# cause: floats-arrive.uncalled
# says: 100.0 was published before
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher.publish(Float32(data=100.0))
