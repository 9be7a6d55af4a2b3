# Asks for a best-effort status.
# loses: status_at_once
# skips: status_follows
# cause: status-at-once.best-effort
# after: BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
STATUS_QOS = QoSProfile(
    depth=1, reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.TRANSIENT_LOCAL
)

# replaces: self.create_subscription(String, "/robot/status", self.on_status, STATE_QOS)
self.create_subscription(String, "/robot/status", self.on_status, STATUS_QOS)
