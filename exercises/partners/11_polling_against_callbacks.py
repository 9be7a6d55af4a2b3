"""The skin of the hand in exercise 11, which numbers its touches and sometimes publishes several at the same time."""

import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32

PERIOD_S = 0.8
TOUCHES = (0, 1, 1, 1, 3)  # the possible numbers of touches at the same time


class Skin(Node):
    """Publishes touches, and pauses while another node publishes on its topic.

    Topics:
        /robot/touch (std_msgs/Int32): the number of the touch.
    """

    def __init__(self, seed: int = 11) -> None:
        super().__init__("skin")
        self.dice = random.Random(seed)
        self.number = 40  # the skin has been counting for a long time
        self.publisher = self.create_publisher(Int32, "/robot/touch", 100)
        self.create_timer(PERIOD_S, self.feel)

    def feel(self) -> None:
        """Publish zero, one, or three touches, unless another node publishes on the topic."""
        if self.count_publishers("/robot/touch") > 1:
            return
        for _ in range(self.dice.choice(TOUCHES)):
            self.number += 1
            self.publisher.publish(Int32(data=self.number))


def main(args: list[str] | None = None) -> None:
    """Run the skin until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(Skin())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
