# Waits for one status and does not subscribe.
# loses: status_follows
# cause: status-follows.never
# says: "error"
# after: from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.wait_for_message import wait_for_message

# replaces: self.last_status = "unknown"
found, message = wait_for_message(String, self, "/robot/status", qos_profile=STATE_QOS, time_to_wait=3.0)
self.last_status = message.data if found else "unknown"

# replaces: self.create_subscription(String, "/robot/status", self.on_status, STATE_QOS)
