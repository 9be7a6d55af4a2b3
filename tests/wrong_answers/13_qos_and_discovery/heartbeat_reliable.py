# Asks for reliable beats, which the robot does not offer.
# loses: hears_heartbeat
# skips: alarm_raised, no_false_alarm, alarm_falls
# cause: hears.reliable
# replaces: self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
self.create_subscription(String, "/robot/heartbeat", self.on_beat, 10)
