# A loop with a rate in a timer's callback, as in ROS 1: the rate waits for a timer that only the same thread could serve.
# loses: heartbeat_count, battery_count, tilt_count
# cause: spin.rate-in-a-callback
# replaces: self.battery_level = 100.0
self.battery_level = 100.0
self.rate = self.create_rate(5)

# replaces: seconds = self.get_clock().now().nanoseconds / 1e9
# replaces: self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
while rclpy.ok():
    seconds = self.get_clock().now().nanoseconds / 1e9
    self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
    self.rate.sleep()
