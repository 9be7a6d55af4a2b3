"""Simulate a guard that walks through a museum at night, round after round, until it's told to stop.

Run it with ``python -m lesson_nodes.night_guard`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

ROUND_S = 0.5


class NightGuard(Node):
    """Logs each round that it has walked.

    Parameters:
        round_s: Time for one round (s), more than zero.

    Attributes:
        rounds: How many rounds it has walked.
    """

    def __init__(self) -> None:
        super().__init__("night_guard")
        self.rounds = 0
        round_s = self.declare_parameter("round_s", ROUND_S).value
        if round_s <= 0:
            raise ValueError(f"round_s must be more than zero seconds, not {round_s}")
        self.create_timer(round_s, self.walk_round)
        self.get_logger().info("Night guard started")

    def walk_round(self) -> None:
        """Walk one round."""
        self.rounds += 1
        self.get_logger().info(f"round {self.rounds}: all quiet")

    def park(self) -> None:
        """Fold the arms, so that the motors can be switched off. This doesn't use ROS."""
        print("arms parked", flush=True)


def main(args: list[str] | None = None) -> None:
    """Run the guard until Ctrl-C or SIGTERM, park it, and exit with code 0."""
    rclpy.init(args=args)
    guard = NightGuard()
    try:
        rclpy.spin(guard)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        guard.park()
        guard.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
