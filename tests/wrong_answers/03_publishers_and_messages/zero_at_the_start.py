# Sends an empty message when the node is made. No listener can hear it.
# loses: floats_arrive, no_invented_zero
# cause: floats-arrive.uncalled
# says: 0.0 was published before
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher.publish(Float32())
