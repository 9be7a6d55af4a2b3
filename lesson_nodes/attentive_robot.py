"""Simulate a robot that publishes a heartbeat, looks around, and repeats each word that it receives.

Run it with ``python -m lesson_nodes.attentive_robot`` and end it with Ctrl-C.
"""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

BEAT_PERIOD_S = 1.0
LOOK_PERIOD_S = 2.1


class AttentiveRobot(Node):
    """Publishes and records an entry for each callback that runs: a heartbeat, a look around, or a received word.

    Topics:
        /robot/done (std_msgs/String): "beat", "look", or "heard " and the word.

    Subscriptions:
        /robot/words (std_msgs/String): words for the robot to repeat.

    Parameters:
        beat_period_s (float): Time between two heartbeats, in seconds.
        look_period_s (float): Time between two looks around, in seconds.

    Attributes:
        done: The entries published so far, one for each callback that ran.

    Raises:
        ValueError: A period is not a positive number.
    """

    def __init__(self) -> None:
        super().__init__("attentive_robot")
        beat_period_s = self.declare_parameter("beat_period_s", BEAT_PERIOD_S).value
        look_period_s = self.declare_parameter("look_period_s", LOOK_PERIOD_S).value
        for period_s in (beat_period_s, look_period_s):
            if not 0.0 < period_s < math.inf:
                raise ValueError(
                    f"A period is the time between two ticks in seconds, for example 1.0, not {period_s}."
                )
        self.done: list[str] = []
        self.done_publisher = self.create_publisher(String, "/robot/done", 10)
        self.create_timer(beat_period_s, self.beat)
        self.create_timer(look_period_s, self.look_around)
        self.create_subscription(String, "/robot/words", self.on_word, 10)

    def beat(self) -> None:
        """Publish a heartbeat."""
        self.tell("beat")

    def look_around(self) -> None:
        """Simulate one look around."""
        self.tell("look")

    def on_word(self, message: String) -> None:
        """Repeat a received word."""
        self.tell(f"heard {message.data}")

    def tell(self, deed: str) -> None:
        """Record an action, and publish it."""
        self.done.append(deed)
        self.done_publisher.publish(String(data=deed))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(AttentiveRobot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
