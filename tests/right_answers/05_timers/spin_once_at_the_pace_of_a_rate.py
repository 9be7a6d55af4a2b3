"""A loop at the pace of a rate: spin_once returns when the timer of the rate fires, and no sleep is needed."""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

HEARTBEAT_PERIOD_S = 1.0  # 1 Hz
BATTERY_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
TILT_PERIOD_S = 0.2  # 5 Hz: five messages every second


class VitalSigns(Node):
    """Reports that the robot lives, how much charge is left, and how far it leans.

    Topics:
        /robot/heartbeat (std_msgs/String), 1 Hz: "alive".
        /robot/battery (std_msgs/Float32), 0.5 Hz: charge in percent, from 100.0 down to 0.0.
        /robot/tilt (std_msgs/Float32), 5 Hz: lean of the body in rad.
    """

    def __init__(self) -> None:
        super().__init__("vital_signs")
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.battery_level = 100.0
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", 10)

    def publish_heartbeat(self) -> None:
        """Say that the robot lives."""
        self.heartbeat_publisher.publish(String(data="alive"))

    def publish_battery(self) -> None:
        """Drain the simulated battery a little, never below empty, and report its charge."""
        self.battery_level = max(0.0, self.battery_level - 0.2)
        self.battery_publisher.publish(Float32(data=self.battery_level))

    def publish_tilt(self) -> None:
        """Report how far the body leans now; it sways from side to side as the robot walks."""
        seconds = self.get_clock().now().nanoseconds / 1e9
        self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))



def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        node = VitalSigns()
        rate = node.create_rate(5)
        tick = 0
        while rclpy.ok():
            node.publish_tilt()
            if tick % 5 == 0:
                node.publish_heartbeat()
            if tick % 10 == 0:
                node.publish_battery()
            tick += 1
            rclpy.spin_once(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
