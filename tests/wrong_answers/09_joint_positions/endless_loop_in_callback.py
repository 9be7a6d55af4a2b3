# The joint callback sends in a loop of its own and never comes back.
# loses: status_kept, battery_kept
# cause: silence.of-one
# after: import random
import time

# replaces: message = Float32MultiArray(data=self.joint_angles())
# replaces: self.joint_publisher.publish(message)
# replaces: self.get_logger().info(f"Joints: {', '.join(f'{angle:.2f}' for angle in message.data)} rad")
while True:
    self.joint_publisher.publish(Float32MultiArray(data=self.joint_angles()))
    time.sleep(2.0)
