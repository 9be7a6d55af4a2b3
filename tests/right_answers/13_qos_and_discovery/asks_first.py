"""Waits for the status before it opens, then goes on listening."""

import time

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import Bool, String

STATE = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Dashboard(Node):
    def __init__(self) -> None:
        super().__init__("dashboard")
        found, message = wait_for_message(String, self, "/robot/status", qos_profile=STATE, time_to_wait=2.0)
        self.status = message.data if found else "unknown"
        self.last_beat = time.time()
        self.is_alarm = False
        self.line = self.create_publisher(String, "/dashboard/line", 10)
        self.alarm = self.create_publisher(Bool, "/dashboard/alarm", STATE)
        self.status_subscription = self.create_subscription(String, "/robot/status", self.on_status, STATE)
        self.beat_subscription = self.create_subscription(
            String, "/robot/heartbeat", self.on_beat, qos_profile_sensor_data
        )
        self.line_timer = self.create_timer(0.5, self.on_tick)
        self.ticks = 0

    def on_status(self, message: String) -> None:
        self.status = message.data

    def on_beat(self, message: String) -> None:
        self.last_beat = time.time()
        self.set_alarm(False)

    def on_tick(self) -> None:
        self.line.publish(String(data=self.status))
        if time.time() - self.last_beat > 2.0:
            self.set_alarm(True)

    def set_alarm(self, on: bool) -> None:
        if on != self.is_alarm:
            self.is_alarm = on
            self.alarm.publish(Bool(data=on))
            self.get_logger().warning("the heart is silent" if on else "the heart beats again")


def main(args=None):
    rclpy.init(args=args)
    dashboard = Dashboard()
    try:
        rclpy.spin(dashboard)
    except KeyboardInterrupt:
        pass
    dashboard.destroy_node()
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
