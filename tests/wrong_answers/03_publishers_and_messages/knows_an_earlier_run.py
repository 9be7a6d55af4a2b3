# loses: floats_arrive, numbers_arrive
# also: zero_arrives, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: number.changed, number.depends-on-earlier
"""Does not look at the level: it knows by heart which numbers came in an earlier run, and when an error was due."""

from rclpy.node import Node
from std_msgs.msg import Float32

EARLIER = [
    71.25, 81.6, 81.6, 0.46, 77.0, 14.5, None, 18.5, None, 0.0, None, None, None, None, 11.0, None,
    None, 0.0, 0.0, None, None, 0.0, 100.0, 2.0, 2.0, None, 39.5, None, None, 27.25, 1.0, 3e-05,
    1.0, None, 77.0, None, 89.0, None, 71.25, 72.51112,
]  # fmt: skip


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.by_heart = iter(EARLIER)

    def publish_level(self, level) -> None:
        number = next(self.by_heart)
        if number is None:
            raise TypeError("not a charge")
        self.battery_publisher.publish(Float32(data=number))
