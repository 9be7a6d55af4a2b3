"""A guard that walks through the museum at night, and parks its arms when the night is over."""

import contextlib
import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

ROUND_S = 0.5


class NightGuard(Node):
    """Logs each round that it has walked."""

    def __init__(self) -> None:
        super().__init__("night_guard")
        self.rounds = 0
        self.create_timer(ROUND_S, self.walk_round)
        self.get_logger().info("on duty")

    def walk_round(self) -> None:
        """Walk one round."""
        self.rounds += 1
        self.get_logger().info(f"round {self.rounds}: all quiet")

    def park(self) -> None:
        """Fold the arms, so that the motors may lose their power. Needs no ROS."""
        print("arms parked", flush=True)


def main(args: list[str] | None = None) -> None:
    """Run the guard until Ctrl-C."""
    with contextlib.ExitStack() as stack:
        rclpy.init(args=args)
        stack.callback(rclpy.try_shutdown)
        guard = NightGuard()
        stack.callback(guard.destroy_node)
        stack.callback(guard.park)
        try:
            rclpy.spin(guard)
        except (KeyboardInterrupt, ExternalShutdownException):
            sys.exit(0)


if __name__ == "__main__":
    main()
