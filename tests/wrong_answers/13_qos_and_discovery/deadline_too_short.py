# Asks for a deadline that the robot does not offer.
# loses: hears_heartbeat
# skips: alarm_raised, no_false_alarm, alarm_falls
# cause: hears.deadline-too-short
# says: 0.3 s
# says: 0.5 s
# after: import rclpy
from rclpy.duration import Duration

# replaces: BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=0.3))
