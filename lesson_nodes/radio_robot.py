"""A robot with a radio: it says its name again and again, and remembers whom it hears.

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
    """Publishes its own name and listens to the same topic.

    Topics:
        /building/hello (std_msgs/String), 4 Hz: the name of who speaks.

    Attributes:
        called: Its own name, known to it after its node is gone as well.
        heard: Who was heard and when, as pairs of a name and a moment of `time.monotonic` (s). It hears itself, too.
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
        """Say who is speaking."""
        self.hello_publisher.publish(String(data=self.called))

    def on_hello(self, message: String) -> None:
        """Remember who spoke."""
        self.heard.append((message.data, time.monotonic()))

    def moments(self, speaker: str) -> list[float]:
        """When `speaker` was heard (s of `time.monotonic`)."""
        return [moment for name, moment in self.heard if name == speaker]

    def others(self) -> list[str]:
        """Names of the other robots that were heard."""
        return sorted({name for name, _ in self.heard} - {self.called})


def main(args: list[str] | None = None) -> None:
    """Run the robot until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(RadioRobot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
