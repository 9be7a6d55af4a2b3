# Asks for old beats, which the robot does not offer.
# loses: hears_heartbeat
# skips: alarm_raised, no_false_alarm, alarm_falls
# cause: hears.transient-local
# replaces: BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
BEAT_QOS = QoSProfile(
    depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.TRANSIENT_LOCAL
)
