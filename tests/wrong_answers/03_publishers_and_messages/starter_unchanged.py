# loses: battery_topic
# says: nothing on /robot/battery; your program publishes nothing
# says: create_publisher(Float32, '/robot/battery', 10)
"""A node that reports the charge of the battery, and nothing but the charge."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    """Reports the charge of the battery whenever it is told one.

    Topics:
        /robot/battery (std_msgs/Float32): charge in percent.
    """

    def __init__(self) -> None:
        super().__init__("battery_publisher")
        # TODO 1: create a publisher for Float32 messages on /robot/battery

    def publish_level(self, level: object) -> None:
        """Send the charge in percent.

        Raises:
            TypeError: `level` is no number.
            ValueError: `level` is nan or infinite.
        """
        # TODO 2: raise an error if level is no number, no finite one, or a bool
        # TODO 3: make a Float32 message that holds level as a Python float, and publish it
