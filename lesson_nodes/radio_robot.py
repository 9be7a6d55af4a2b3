"""Simulate a robot with a radio: publish its name again and again, and record the names that it receives.

Run it with ``python -m lesson_nodes.radio_robot`` and end it with Ctrl-C.
"""

import time

import rclpy
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

TOPIC = "/building/hello"
PERIOD_S = 0.25


class RadioRobot(Node):
    """Publishes its name on a topic, and subscribes to that topic.

    Topics:
        /building/hello (std_msgs/String), 4 Hz: the sender's name.

    Attributes:
        called: The robot's name, which stays available after the node is destroyed.
        heard: Pairs of a received name and its arrival time (`time.monotonic`, s). They include the robot's own name.
    """

    def __init__(self, name: str = "radio_robot", context: Context | None = None) -> None:
        super().__init__(name, context=context)
        self.called = name
        self.heard: list[tuple[str, float]] = []
        self.hello_publisher = self.create_publisher(String, TOPIC, 10)
        self.create_subscription(String, TOPIC, self.on_hello, 10)
        self.create_timer(PERIOD_S, self.say_hello)
        self.get_logger().info("Radio robot started")

    def say_hello(self) -> None:
        """Publish the robot's name."""
        self.hello_publisher.publish(String(data=self.called))

    def on_hello(self, message: String) -> None:
        """Record a received name."""
        self.heard.append((message.data, time.monotonic()))

    def moments(self, speaker: str) -> list[float]:
        """Return the arrival times (`time.monotonic`, s) of one robot's messages."""
        return [moment for name, moment in self.heard if name == speaker]

    def others(self) -> list[str]:
        """Return the sorted names of the other robots that published a message."""
        return sorted({name for name, _ in self.heard} - {self.called})


def main(args: list[str] | None = None) -> None:
    """Run the robot until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(RadioRobot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
