# A deadline, but nobody is told when it is missed.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.never
# after: import rclpy
from rclpy.duration import Duration

# replaces: BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=2.0))

# replaces: self.create_timer(LOOK_PERIOD_S, self.look_at_the_clock)
