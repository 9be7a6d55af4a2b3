# The program stays alive but never spins.
# loses: twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept
# cause: no-message.silent
# after: import random
import time

# replaces: rclpy.spin(HumanoidStatusPublisher())
node = HumanoidStatusPublisher()
while rclpy.ok():
    print(node.get_name(), "is alive")
    time.sleep(1.0)
