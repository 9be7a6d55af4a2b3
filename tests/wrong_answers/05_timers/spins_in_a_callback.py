# A callback spins its own node, which takes the node away from its executor.
# loses: heartbeat_count, battery_count, tilt_count
# cause: spin.in-a-callback
# replaces: self.heartbeat_publisher.publish(String(data="alive"))
self.heartbeat_publisher.publish(String(data="alive"))
rclpy.spin_once(self, timeout_sec=0.01)

# replaces: rclpy.spin(VitalSigns())
executor = rclpy.executors.SingleThreadedExecutor()
executor.add_node(VitalSigns())
executor.spin()
