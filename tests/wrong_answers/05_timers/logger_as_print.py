# The logger is called like print, with several values.
# loses: heartbeat_count, battery_count, alive_at_end
# cause: error.logger-takes-text
# after: self.battery_publisher.publish(Float32(data=self.battery_level))
self.get_logger().info("battery:", self.battery_level)
