"""Simulate a robot that blinks its lamp and beeps, each with a separate timer.

Run it with ``python -m lesson_nodes.blink_and_beep`` and end it with Ctrl-C.
"""

import math
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

BLINK_PERIOD_S = 1.0
BEEP_PERIOD_S = 2.0


class BlinkAndBeep(Node):
    """Blinks and beeps, and publishes a message each time.

    Topics:
        /robot/blink (std_msgs/String): "blink".
        /robot/beep (std_msgs/String): "beep".

    Parameters:
        blink_period_s (float): Time between two blinks, in seconds.
        beep_period_s (float): Time between two beeps, in seconds.
        beep_takes_s (float): How long the beep's callback takes, in real seconds.

    Raises:
        ValueError: A period is not a positive number, or `beep_takes_s` is negative or not finite.
    """

    def __init__(self) -> None:
        super().__init__("blink_and_beep")
        blink_period_s = self.declare_parameter("blink_period_s", BLINK_PERIOD_S).value
        beep_period_s = self.declare_parameter("beep_period_s", BEEP_PERIOD_S).value
        self.beep_takes_s = self.declare_parameter("beep_takes_s", 0.0).value
        for period_s in (blink_period_s, beep_period_s):
            if not 0.0 < period_s < math.inf:
                raise ValueError(
                    f"A period is the time between two ticks in seconds, for example 2.0, not {period_s}."
                )
        if not 0.0 <= self.beep_takes_s < math.inf:
            raise ValueError(f"A beep takes 0 s or longer, not {self.beep_takes_s}.")
        self.blink_publisher = self.create_publisher(String, "/robot/blink", 10)
        self.beep_publisher = self.create_publisher(String, "/robot/beep", 10)
        self.create_timer(blink_period_s, self.blink)
        self.create_timer(beep_period_s, self.beep)

    def blink(self) -> None:
        """Light the lamp for a moment."""
        self.blink_publisher.publish(String(data="blink"))

    def beep(self) -> None:
        """Beep once. If `beep_takes_s` is above zero, block for that time, as a badly written driver would."""
        self.beep_publisher.publish(String(data="beep"))
        if self.beep_takes_s > 0.0:
            time.sleep(self.beep_takes_s)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(BlinkAndBeep())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
