"""No class and no timer: a loop that spins a little, and looks at the clock."""

import time

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Bool, String

rclpy.init()
node = rclpy.create_node("late_dashboard")
kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
seen = {"status": "unknown", "beat": time.monotonic()}


def on_status(message: String) -> None:
    seen["status"] = message.data


def on_beat(message: String) -> None:
    seen["beat"] = time.monotonic()


line = node.create_publisher(String, "/dashboard/line", 10)
alarm = node.create_publisher(Bool, "/dashboard/alarm", kept)
node.create_subscription(String, "/robot/status", on_status, kept)
node.create_subscription(
    String, "/robot/heartbeat", on_beat, QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
)

next_line = time.monotonic()
try:
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.1)
        if time.monotonic() >= next_line:
            next_line += 0.5
            line.publish(String(data=seen["status"]))
            alarm.publish(Bool(data=time.monotonic() - seen["beat"] > 1.8))
except KeyboardInterrupt:
    pass
rclpy.try_shutdown()
