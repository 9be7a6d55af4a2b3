# Asks for a deadline, which the robot does not offer for the status.
# loses: status_at_once
# skips: status_follows
# cause: hears.deadline-not-offered
# says: 2 s
# after: import rclpy
from rclpy.duration import Duration

# after: BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
STATUS_QOS = QoSProfile(
    depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, deadline=Duration(seconds=2.0)
)

# replaces: self.create_subscription(String, "/robot/status", self.on_status, STATE_QOS)
self.create_subscription(String, "/robot/status", self.on_status, STATUS_QOS)
