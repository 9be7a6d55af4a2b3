# Believes that a message goes out only when somebody spins.
# loses: calls_come_back
# cause: calls-come-back.method-waits
# before: from rclpy.node import Node
import rclpy

# after: self.battery_publisher.publish(Float32(data=float(level)))
rclpy.spin(self)
