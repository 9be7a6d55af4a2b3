# The alarm is kept for those who come later, but not sent again when it is lost.
# loses: alarm_kept
# cause: kept-for-latecomers.best-effort
# after: BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
ALARM_QOS = QoSProfile(
    depth=1, reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.TRANSIENT_LOCAL
)

# replaces: self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", STATE_QOS)
self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", ALARM_QOS)
