# loses: joint_topic
# skips: twelve_values, finite_in_range, joints_move, joint_rate
# says: nothing on /robot/joint_positions
"""The humanoid status publisher: state, battery and the angles of twelve joints."""

import math
import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

from std_msgs.msg import Float32, String  # TODO 1: import the message type with an array of floats

STATUS_PERIOD_S = 1.0
BATTERY_PERIOD_S = 2.0
DRAIN_PERCENT = (0.1, 0.5)


class HumanoidStatusPublisher(Node):
    """Publishes the state of the robot, the charge of its battery and the angles of its joints.

    Topics:
        /robot/status (std_msgs/String), 1 Hz: "operational", or "error" once the battery is empty.
        /robot/battery (std_msgs/Float32), 0.5 Hz: charge in percent, from 100.0 down to 0.0.
        /robot/joint_positions (std_msgs/Float32MultiArray), 0.5 Hz: 12 angles in radians.
    """

    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        # TODO 2: create the publisher for /robot/joint_positions
        self.status_timer = self.create_timer(STATUS_PERIOD_S, self.publish_status)
        self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        # TODO 3: create a timer for 0.5 Hz. How many seconds lie between two messages?
        self.get_logger().info("Humanoid status publisher started")

    def publish_status(self) -> None:
        """Say whether the robot can work."""
        message = String(data="operational" if self.battery_level > 0.0 else "error")
        self.status_publisher.publish(message)
        self.get_logger().info(f"Status: {message.data}")

    def publish_battery(self) -> None:
        """Drain the simulated battery a little, never below empty, and report its charge."""
        self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
        self.battery_publisher.publish(Float32(data=self.battery_level))
        self.get_logger().info(f"Battery: {self.battery_level:.1f} %")

    # TODO 4: write the method that the new timer calls. It makes a message, puts 12 angles
    #         in radians into its data field (let them move!) and publishes it.


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
