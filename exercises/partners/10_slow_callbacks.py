"""A guest who hands things to the robot. Every four seconds, the guest requests a plan from exercise 10's program."""

import itertools

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32

PERIOD_S = 4.0
DISTANCES_M = (0.7, 0.25, 0.55)


class Guest(Node):
    """Requests one plan after another, and pauses while another node requests plans.

    Topics:
        /robot/plan_request (std_msgs/Float32): the distance from the shoulder to the hand (m).
    """

    def __init__(self) -> None:
        super().__init__("hungry_guest")
        self.distances = itertools.cycle(DISTANCES_M)
        self.publisher = self.create_publisher(Float32, "/robot/plan_request", 10)
        self.create_timer(PERIOD_S, self.ask)

    def ask(self) -> None:
        """Request a plan, unless another node requests plans."""
        if self.count_publishers("/robot/plan_request") == 1:
            self.publisher.publish(Float32(data=next(self.distances)))


def main(args: list[str] | None = None) -> None:
    """Request plans until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(Guest())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
