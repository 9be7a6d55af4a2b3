# A whole program at the left margin, so the import of this file never ends.
# loses: calls_come_back
# cause: calls-come-back.import-does-not-end
# before: from rclpy.node import Node
import rclpy

# after:         self.battery_publisher.publish(Float32(data=float(level)))
rclpy.init()
rclpy.spin(BatteryPublisher())
