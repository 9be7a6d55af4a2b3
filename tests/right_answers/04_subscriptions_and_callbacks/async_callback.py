"""A coroutine as the callback, a queue of five, and one publisher class for both topics."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

LIMITS = range(101)


class Monitor(Node):
    def __init__(self, source: str = "/robot/battery", *, to: str = "/monitor") -> None:
        super().__init__("monitor")
        self.outlets = {
            kind: self.create_publisher(kind, f"{to}/{name}", 10)
            for kind, name in ((Float32, "battery"), (String, "alarm"))
        }
        self.create_subscription(Float32, source, self.sort, 5)

    async def sort(self, reading: Float32) -> None:
        good = LIMITS[0] <= reading.data <= LIMITS[-1]
        answer = reading if good else String(data=repr(reading))
        self.outlets[type(answer)].publish(answer)


if __name__ == "__main__":
    rclpy.init()
    try:
        rclpy.spin(Monitor())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
