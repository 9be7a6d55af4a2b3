"""Publish the names of the nodes on the graph, and record the published names.

Run it with ``python -m lesson_nodes.roll_call`` and end it with Ctrl-C.
"""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

TOPIC = "/robot/roll_call"
PERIOD_S = 0.2


class RollCall(Node):
    """Publishes the fully qualified names of all other nodes, except those whose name begins with an underscore.

    Topics:
        /robot/roll_call (std_msgs/String), 5 Hz: the sorted names, separated by spaces. Duplicates are listed twice.

    Parameters:
        period_s: Time between two roll calls (s), more than zero.
    """

    def __init__(self) -> None:
        super().__init__("roll_call")
        period_s = self.declare_parameter("period_s", PERIOD_S).value
        if period_s <= 0:
            raise ValueError(f"period_s must be more than zero seconds, not {period_s}")
        self.roll_publisher = self.create_publisher(String, TOPIC, 10)
        self.create_timer(period_s, self.call_the_roll)
        self.get_logger().info("Roll call started")

    def call_the_roll(self) -> None:
        """Publish the names of the other nodes on the graph."""
        self.roll_publisher.publish(String(data=" ".join(self.others())))

    def others(self) -> list[str]:
        """Return the other nodes' fully qualified names, sorted."""
        own = self.get_fully_qualified_name()
        found = [
            f"{namespace.rstrip('/')}/{name}"
            for name, namespace in self.get_node_names_and_namespaces()
            if not name.startswith("_")
        ]
        return sorted(name for name in found if name != own)


class RollReader(Node):
    """Stores the roll calls that it receives.

    Attributes:
        calls: The roll calls so far, as pairs of an arrival time (`time.monotonic`, s) and the names.
    """

    def __init__(self) -> None:
        super().__init__("_roll_reader")
        self.calls: list[tuple[float, list[str]]] = []
        self.create_subscription(String, TOPIC, self.on_call, 10)

    def on_call(self, message: String) -> None:
        """Store a roll call's names."""
        self.calls.append((time.monotonic(), message.data.split()))

    def latest(self) -> list[str]:
        """Return the names in the latest roll call; an empty list before the first one."""
        return self.calls[-1][1] if self.calls else []

    def moments(self, name: str) -> list[float]:
        """Return the times (`time.monotonic`, s) of all roll calls that contained this name."""
        return [moment for moment, names in self.calls if name in names]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(RollCall())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
