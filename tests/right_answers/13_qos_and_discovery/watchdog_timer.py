"""Nothing but the class; a timer that every beat winds up again."""

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from std_msgs.msg import Bool, String


class Dashboard(Node):
    def __init__(self) -> None:
        super().__init__("dashboard")
        keep = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.text = "unknown"
        self.line = self.create_publisher(String, "/dashboard/line", 10)
        self.alarm = self.create_publisher(Bool, "/dashboard/alarm", keep)
        self.create_subscription(String, "/robot/status", self.on_status, keep)
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, qos_profile_sensor_data)
        self.create_timer(0.5, self.show)
        self.watchdog = self.create_timer(2.0, self.on_silence)
        self.silent = False

    def on_status(self, message: String) -> None:
        self.text = message.data

    def show(self) -> None:
        self.line.publish(String(data=f"status: {self.text}"))

    def on_beat(self, message: String) -> None:
        self.watchdog.reset()
        if self.silent:
            self.silent = False
            self.alarm.publish(Bool(data=False))

    def on_silence(self) -> None:
        self.silent = True
        self.alarm.publish(Bool(data=True))
