"""A thread of its own publishes the line and looks at the clock; the callbacks only take notes."""

import threading
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import Bool, String

LATCHED = QoSProfile(
    depth=1, reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.TRANSIENT_LOCAL
)


class Dashboard(Node):
    def __init__(self):
        super().__init__("dashboard")
        self.lock = threading.Lock()
        self.last_status = "unknown"
        self.last_beat = time.monotonic()
        self.line_publisher = self.create_publisher(String, "/dashboard/line", 10)
        self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", LATCHED)
        self.create_subscription(String, "/robot/status", self.on_status, LATCHED)
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, qos_profile_sensor_data)
        threading.Thread(target=self.watch, daemon=True).start()

    def on_status(self, message):
        with self.lock:
            self.last_status = message.data

    def on_beat(self, message):
        with self.lock:
            self.last_beat = time.monotonic()

    def watch(self):
        alarm = None
        due = time.monotonic()
        while rclpy.ok():
            with self.lock:
                text, silent = self.last_status, time.monotonic() - self.last_beat > 2.0
            try:
                self.line_publisher.publish(String(data=text))
                if silent != alarm:
                    alarm = silent
                    self.alarm_publisher.publish(Bool(data=alarm))
            except Exception:
                return
            due += 0.5
            time.sleep(max(0.0, due - time.monotonic()))


def main(args=None):
    rclpy.init(args=args)
    try:
        rclpy.spin(Dashboard())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
