# Gives a policy in the place of a profile: it is an int, and a number means a depth.
# loses: hears_heartbeat
# skips: alarm_raised, no_false_alarm, alarm_falls
# cause: hears.reliable
# replaces: self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
self.create_subscription(String, "/robot/heartbeat", self.on_beat, ReliabilityPolicy.BEST_EFFORT)
