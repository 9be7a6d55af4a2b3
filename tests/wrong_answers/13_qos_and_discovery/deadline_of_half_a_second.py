# A deadline as long as the period of the heart: each late beat is an alarm.
# loses: no_false_alarm
# skips: alarm_falls
# cause: no-false-alarm.early
# after: import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks

# replaces: BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=0.5))

# replaces: self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
# replaces: self.create_timer(LOOK_PERIOD_S, self.look_at_the_clock)
missed = SubscriptionEventCallbacks(deadline=self.on_missed)
self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS, event_callbacks=missed)

# replaces: self.last_beat = time.monotonic()
self.alarm_publisher.publish(Bool(data=False))

# before: def look_at_the_clock(self) -> None:
def on_missed(self, event: object) -> None:
    self.alarm_publisher.publish(Bool(data=True))
