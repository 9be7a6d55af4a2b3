# loses: ends_cleanly
# says: publisher's context is invalid
"""A guard that walks through the museum at night, and parks its arms when the night is over."""

import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

ROUND_S = 0.5


class NightGuard(Node):
    """Logs each round that it has walked."""

    def __init__(self) -> None:
        super().__init__("night_guard")
        self.rounds = 0
        self.radio = self.create_publisher(String, "/museum/radio", 10)
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
    rclpy.init(args=args)
    guard = NightGuard()
    try:
        rclpy.spin(guard)
    except KeyboardInterrupt:
        time.sleep(0.5)  # one last look around
        guard.radio.publish(String(data="good night"))
    finally:
        guard.park()
        guard.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
