"""The battery sensor with a bad cable. Exercise 04's monitor subscribes to it."""

import math
import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32

PERIOD_S = 0.5
BAD = (-3.0, 250.0, math.nan, math.inf)
BAD_SHARE, OTHER_SHARE = 0.15, 0.2
FULL, LOW, STEP = 96.0, 6.0, 0.8  # percent; the charge drops by STEP with each reading


class BatterySensor(Node):
    """Publishes readings, most of them good, and pauses while another node publishes on its topic.

    Topics:
        /robot/battery (std_msgs/Float32): charge in percent, twice a second; sometimes an impossible value.
        /other_robot/battery (std_msgs/Float32): occasionally, another robot's charge.
    """

    def __init__(self, seed: int = 4) -> None:
        super().__init__("battery_sensor")
        self.dice = random.Random(seed)
        self.charge = FULL
        self.publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.other_publisher = self.create_publisher(Float32, "/other_robot/battery", 10)
        self.create_timer(PERIOD_S, self.measure)

    def measure(self) -> None:
        """Publish the next reading, unless another node publishes on the topic."""
        if self.count_publishers("/robot/battery") > 1:
            return
        self.charge = self.charge - STEP if self.charge > LOW else FULL
        bad = self.dice.random() < BAD_SHARE
        self.publisher.publish(Float32(data=self.dice.choice(BAD) if bad else self.charge))
        if self.dice.random() < OTHER_SHARE:
            self.other_publisher.publish(Float32(data=41.5))


def main(args: list[str] | None = None) -> None:
    """Run the sensor until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(BatterySensor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
