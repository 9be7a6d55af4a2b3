"""Counts the ticks of its line timer since the last beat. The line is a sentence, and kept, too."""


import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import Bool, String

LATCHED = QoSProfile(
    depth=1, reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.TRANSIENT_LOCAL
)


class Dashboard(Node):
    """Counts its own half seconds without a beat."""

    def __init__(self):
        super().__init__("dashboard")
        self.text = "unknown"
        self.ticks = 0
        self.lines = self.create_publisher(String, "/dashboard/line", LATCHED)
        self.alarms = self.create_publisher(Bool, "/dashboard/alarm", LATCHED)
        self.create_subscription(String, "/robot/status", self.on_status, LATCHED)
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, qos_profile_sensor_data)
        self.create_timer(0.5, self.tick)

    def on_status(self, message):
        self.text = "Robot reports " + message.data + "."

    def on_beat(self, _):
        self.ticks = 0

    def tick(self):
        self.ticks += 1
        self.lines.publish(String(data=self.text))
        self.alarms.publish(Bool(data=self.ticks > 4))


def main():
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=3)
    executor.add_node(Dashboard())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
