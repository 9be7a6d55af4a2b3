"""A node for the line and one for the alarm, in an executor with several threads."""

import time

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from std_msgs.msg import Bool, String

KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class LineNode(Node):
    def __init__(self) -> None:
        super().__init__("line")
        self.publisher = self.create_publisher(String, "/dashboard/line", 10)
        self.message = String(data="unknown")
        self.create_subscription(String, "/robot/status", self.on_status, KEPT)
        self.create_timer(0.5, lambda: self.publisher.publish(self.message))

    def on_status(self, message: String) -> None:
        self.message = message


class AlarmNode(Node):
    def __init__(self) -> None:
        super().__init__("alarm")
        group = ReentrantCallbackGroup()
        self.publisher = self.create_publisher(Bool, "/dashboard/alarm", KEPT)
        self.beats: list[float] = []
        self.on = False
        self.create_subscription(
            String, "/robot/heartbeat", self.on_beat, qos_profile_sensor_data, callback_group=group
        )
        self.create_timer(0.1, self.look, callback_group=group)

    def on_beat(self, message: String) -> None:
        self.beats.append(time.monotonic())

    def look(self) -> None:
        on = bool(self.beats) and time.monotonic() - self.beats[-1] >= 2.0
        if on is not self.on:
            self.on = on
            self.publisher.publish(Bool(data=on))


def main() -> None:
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=3)
    for node in (LineNode(), AlarmNode()):
        executor.add_node(node)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
