"""A node that has exercise 06's driver call `pump` for two seconds, every four seconds."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32, String

PERIOD_S, PUMP_S = 4.0, 2.0
FIRST = 101  # the first call's number; other nodes use smaller numbers
WORDS = 3


class PumpUser(Node):
    """Orders one call of pump after another, and pauses while another node gives orders.

    Topics:
        /driver/go (std_msgs/String): "101 robot 2.0": the call's number, the node to pump, and the duration (s).
        /robot/words (std_msgs/Int32): three numbers, which the robot handles in the next call.
    """

    def __init__(self) -> None:
        super().__init__("pump_user")
        self.call = FIRST
        self.go_publisher = self.create_publisher(String, "/driver/go", 10)
        self.word_publisher = self.create_publisher(Int32, "/robot/words", 100)
        self.create_timer(PERIOD_S, self.order)

    def order(self) -> None:
        """Order the next call, unless the driver doesn't subscribe yet or another node gives orders."""
        if self.count_publishers("/driver/go") > 1 or self.go_publisher.get_subscription_count() == 0:
            return
        for word in range(WORDS):
            self.word_publisher.publish(Int32(data=word))
        self.go_publisher.publish(String(data=f"{self.call} robot {PUMP_S}"))
        self.call += 1


def main(args: list[str] | None = None) -> None:
    """Give orders until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(PumpUser())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
