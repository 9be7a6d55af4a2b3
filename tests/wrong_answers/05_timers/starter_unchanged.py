# loses: battery_topic, tilt_topic
# skips: battery_count, tilt_count
# says: nothing on /robot/battery
"""The vital signs of a humanoid: heartbeat, battery and tilt, each in its own rhythm."""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

HEARTBEAT_PERIOD_S = 1.0  # 1 Hz
# TODO 1: the battery reports at 0.5 Hz, the tilt at 5 Hz. How many seconds lie between two messages?


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
        self.create_timer(HEARTBEAT_PERIOD_S, self.publish_heartbeat)
        # TODO 2: create the publishers for /robot/battery and /robot/tilt
        # TODO 3: create a timer for each of them

    def publish_heartbeat(self) -> None:
        """Say that the robot lives."""
        self.heartbeat_publisher.publish(String(data="alive"))

    # TODO 4: write the two methods that your timers call. Each makes a Float32 message,
    #         gives its data a float and publishes it.



def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(VitalSigns())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
